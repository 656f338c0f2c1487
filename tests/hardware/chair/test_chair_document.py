"""A chair's document: from speeds to the percents of its joystick, and what is no document."""

import hashlib
import json
import os

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.chair_document import ASSUMED_SPEED, UNMEASURED, UNMEASURED_MOST, joystick_table
from app.hardware.chair.outputs import OutputRefused

GOOD = {
    "version": 1,
    "name": "Blue",
    "dead_band": 8,
    "forward": [[20, 0.2], [60, 0.7], [100, 1.8]],
    "back": [[50, 0.3]],
    "turn": [[50, 0.5], [100, 2.0]],
    "lag": 0.2,
}


@pytest.fixture
def table(tmp_path):
    """Return a function that reads a document of these fields, or of this text."""

    def read(document):
        file = tmp_path / "chair.json"
        file.write_text(document if isinstance(document, str) else json.dumps(document))
        return joystick_table(file)

    return read


def test_deflections_are_read_off_the_tables(table):
    chair = table(GOOD)
    assert chair.deflection(STANDSTILL) == (0.0, 0.0)
    assert chair.deflection(Twist(0.2, 0.5)) == pytest.approx((20.0, -50.0))
    assert chair.deflection(Twist(0.45, -1.25)) == pytest.approx((40.0, 75.0))
    assert chair.deflection(Twist(-0.15, 0.25)) == pytest.approx((-29.0, -29.0))
    assert chair.deflection(Twist(1e-6, 0.0))[0] == pytest.approx(8.0, abs=0.001)
    assert chair.deflection(Twist(9.0, -9.0)) == (100.0, 100.0)
    assert chair.deflection(Twist(-9.0, 0.0))[0] == -50.0, "nothing is driven that was not measured"


def test_who_sets_it_up_is_told_which_document_it_is(table, tmp_path):
    note = table(GOOD).note
    digits = hashlib.sha256((tmp_path / "chair.json").read_bytes()).hexdigest()
    assert f"begins with {digits[:12]}." in note
    assert table(GOOD).report == (bytes.fromhex(digits[:16]), False)


def test_nothing_faster_is_commanded_than_was_measured_or_than_any_receiver_drives(table):
    assert table(GOOD).most == Twist(1.5, 2.0)
    assert table({**GOOD, "forward": [[30, 0.4]]}).most == Twist(0.4, 2.0)


def test_without_a_document_every_chair_drives_slower_than_it_is_commanded():
    assert joystick_table(None) is UNMEASURED
    ahead, right = UNMEASURED.deflection(UNMEASURED_MOST)
    assert ahead == pytest.approx(100 * 0.3 / 4.2)
    assert right == pytest.approx(-100 * 0.5 / 4.0)
    assert (UNMEASURED.most, ASSUMED_SPEED) == (Twist(0.3, 0.5), 4.2)
    assert UNMEASURED.report == (bytes(8), True)
    assert "0.3 m/s and 0.5 rad/s" in UNMEASURED.note


ascending = st.lists(st.floats(0.01, 1.0), min_size=1, max_size=20)


@given(ascending, ascending, st.floats(0.0, 50.0), st.lists(st.floats(0.0, 8.0), min_size=2, max_size=20))
def test_more_speed_never_takes_less_deflection(tmp_path_factory, steps, rises, dead_band, speeds):
    rows = min(len(steps), len(rises))
    percents = [dead_band + (100 - dead_band) * sum(steps[: n + 1]) / sum(steps[:rows]) for n in range(rows)]
    of_speed = [6.0 * sum(rises[: n + 1]) / sum(rises[:rows]) for n in range(rows)]
    axis = [[min(100.0, percent), min(6.0, speed)] for percent, speed in zip(percents, of_speed, strict=True)]
    file = tmp_path_factory.mktemp("chair") / "chair.json"
    file.write_text(json.dumps({**GOOD, "dead_band": dead_band, "forward": axis, "back": axis, "turn": axis}))
    chair = joystick_table(file)
    deflections = [chair.deflection(Twist(speed, 0.0))[0] for speed in sorted(speeds)]
    assert deflections == sorted(deflections)
    assert all(deflection == 0.0 or dead_band <= deflection <= 100.0 for deflection in deflections)
    for percent, speed in axis:
        assert chair.deflection(Twist(speed, 0.0))[0] == pytest.approx(percent)
        assert chair.deflection(Twist(-speed, -speed)) == pytest.approx((-percent, percent))


@pytest.mark.parametrize(
    ("document", "why"),
    [
        ("", "no JSON"),
        ("[" * 50_000, "no JSON"),
        ("[]", "an object"),
        ({}, "version must be 1"),
        *(({**GOOD, "version": value}, "version must be 1") for value in (0, 2, True, "1", None)),
        ({**GOOD, "colour": "blue"}, "no field 'colour'"),
        *(({**GOOD, "name": value}, "name must be") for value in (7, None, "x" * 81)),
        *(({**GOOD, "lag": value}, "lag must be") for value in (-0.1, 5.1, "1", None, True)),
        *(({**GOOD, "dead_band": value}, "dead_band") for value in (-1, 51, True, "8", None, [8])),
        ('{"dead_band": NaN}', "NaN is no number"),
        ('{"version": 1, "dead_band": 1e999}', "dead_band"),
        *(
            ({**GOOD, "turn": value}, "turn must be")
            for value in (None, [], 7, [[20]], [[20, "x"]], [[20, True]], [[1, 2]] * 101, [[10**400, 1]])
        ),
        ({**GOOD, "forward": [[20, 0.2], [20, 0.3]]}, "in forward each row"),
        ({**GOOD, "forward": [[20, 0.3], [30, 0.3]]}, "in forward each row"),
        ({**GOOD, "back": [[8, 0.3]]}, "in back each row"),
        ({**GOOD, "back": [[20, 0.0]]}, "in back each row"),
        ({**GOOD, "turn": [[101, 1.0]]}, "above 100 percent"),
        ({**GOOD, "turn": [[100, 6.5]]}, "above 6"),
        ("x" * 70_000, "larger than 65536 bytes"),
    ],
)
def test_what_is_no_document_is_refused_in_one_sentence(table, document, why):
    with pytest.raises(OutputRefused, match=why) as refused:
        table(document)
    assert "\n" not in str(refused.value)
    assert "chair.json" in str(refused.value)


def test_what_cannot_be_read_is_refused_and_a_pipe_is_not_waited_for(tmp_path):
    (tmp_path / "binary").write_bytes(b"\xff\xfe")
    os.mkfifo(tmp_path / "pipe")
    for name, why in (("none", "cannot be read"), (".", "cannot be read"), ("binary", "UTF-8"), ("pipe", "no JSON")):
        with pytest.raises(OutputRefused, match=why):
            joystick_table(tmp_path / name)
