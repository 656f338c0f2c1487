"""Every parameter of the simulated person has a range with a source, and every named person lies within."""

import dataclasses
import math

import pytest

from app.hardware.body.parameter_ranges import RANGES, numbers_of, out_of_range
from app.hardware.body.person_parameters import NOVICE, PARAMETERS, PersonParameters, PracticeEffect

NOT_MEASURED = {"learns", "practice"}  # a switch, and where the person stands in his learning


def test_every_parameter_has_a_range_and_every_range_a_parameter() -> None:
    names = {field.name for field in dataclasses.fields(PersonParameters)} - NOT_MEASURED
    assert {name.partition(".")[0] for name in RANGES} == names
    assert list(numbers_of(NOVICE)) == list(RANGES)


def test_ranges_are_finite_and_say_their_unit_and_source() -> None:
    for name, known in RANGES.items():
        assert math.isfinite(known.low), name
        assert math.isfinite(known.high), name
        assert known.low < known.high, name
        assert known.unit, name
        assert known.source, name


@pytest.mark.parametrize("name", PARAMETERS)
def test_every_named_person_lies_within(name) -> None:
    assert out_of_range(PARAMETERS[name]) == ()


def test_a_number_outside_is_named_with_its_range() -> None:
    odd = dataclasses.replace(NOVICE, reaction_time=0.05, wrong_limb=PracticeEffect(0.9, 0.01, math.nan))
    said = out_of_range(odd)
    assert said[0] == "reaction_time is 0.05 s: choose 0.18 to 0.5"
    assert [sentence.split(" is ")[0] for sentence in said[1:]] == ["wrong_limb.first", "wrong_limb.strokes"]
