"""The differences of two parameter sets: none exactly when the sets are equal."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.vocabulary import Binding, DriveParameters, standard_parameters
from app.session.parameter_differences import CONTROLS, differences
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from small_profile import small_profile

STANDARD = standard_parameters(small_profile())
SOME = st.fixed_dictionaries(
    {},
    optional={
        "title": st.sampled_from(["Standard", "Gentle"]),
        "mode_u1": st.sampled_from(["velocity", "acceleration"]),
        "mode_u2": st.sampled_from(["velocity", "acceleration"]),
        "cutoff": st.floats(1, 8),
        "cruise_time": st.floats(1, 30),
        "turn_cruise_time": st.floats(1, 10),
        "speeds": st.builds(Speeds, forward=st.floats(0.1, 1.5), jerk=st.floats(0.5, 20)),
        "bindings": st.lists(
            st.builds(
                Binding,
                control=st.sampled_from(sorted(CONTROLS)),
                gestures=st.sampled_from([(), ("right_elbow",), ("left_elbow", "right_elbow")]),
                gain=st.sampled_from([1.0, 1.5]),
            ),
            max_size=4,
        ).map(tuple),
        "gestures": st.permutations(STANDARD.gestures).map(tuple),
    },
)


def changed(**fields: Any) -> DriveParameters:
    return STANDARD.model_copy(update=fields)


def gesture(**fields: Any) -> DriveParameters:
    first, *others = STANDARD.gestures
    return changed(gestures=(first.model_copy(update=fields), *others))


RIGHT_ELBOW = {"joint": "right_elbow", "direction": 1}


@given(SOME, SOME)
def test_there_is_no_difference_exactly_when_both_have_one_hash(one: dict[str, Any], other: dict[str, Any]) -> None:
    now, before = changed(**one), changed(**other)
    assert (differences(now, before) == []) == (now.hash == before.hash)


@pytest.mark.parametrize(
    ("now", "expected"),
    [
        (changed(title="Gentle"), {"kind": "field", "name": "title", "before": "Standard", "now": "Gentle"}),
        (changed(speeds=Speeds(turn=0.6)), {"kind": "field", "name": "turn", "before": 1.2, "now": 0.6}),
        (changed(turn_cruise_time=2.0), {"kind": "field", "name": "turn_cruise_time", "before": 3.0, "now": 2.0}),
        (
            gesture(dead_zone=0.25),
            {"kind": "gesture", "gesture": RIGHT_ELBOW, "feature": "rate"}
            | {"name": "dead_zone", "before": 0.2, "now": 0.25},
        ),
        (
            changed(bindings=()),
            {"kind": "binding", "control": "u1+", "before": [{"gestures": [RIGHT_ELBOW], "gain": 1.0}], "now": []},
        ),
    ],
)
def test_a_difference_names_its_field_and_both_values(now: DriveParameters, expected: dict[str, Any]) -> None:
    assert expected in [one.model_dump(mode="json") for one in differences(now, STANDARD)]


@pytest.mark.parametrize("name", Speeds.model_fields)
def test_every_speed_is_compared(name: str) -> None:
    faster = Speeds(**{name: getattr(HIGHEST_SPEEDS, name)})
    assert len(differences(changed(speeds=faster), STANDARD)) == 1
