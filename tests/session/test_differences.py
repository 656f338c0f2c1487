"""What is said of two parameter sets: nothing exactly when they are equal."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.vocabulary import Binding, DriveParameters, standard_parameters
from app.session.words.differences import CONTROLS, SPEEDS, differences
from app.speeds import HIGHEST_SPEEDS, Speeds
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
        "turn_cruise_time": st.one_of(st.none(), st.floats(1, 10)),
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


@given(SOME, SOME)
def test_nothing_is_said_exactly_when_both_have_one_hash(one: dict[str, Any], other: dict[str, Any]) -> None:
    now, before = changed(**one), changed(**other)
    said = differences(now, before)
    assert (said == []) == (now.hash == before.hash)
    assert all(sentence.endswith(".") for sentence in said)


@pytest.mark.parametrize(
    ("now", "sentence"),
    [
        (changed(title="Gentle"), "The set's name: “Standard” → “Gentle”."),
        (changed(mode_u1="velocity"), "Forward and back: keeps its speed → follows the movement."),
        (changed(mode_u2="acceleration"), "Turning: follows the movement → keeps turning."),
        (changed(cutoff=4.0), "Tremor damping: 3.0 → 4.0 Hz."),
        (changed(cutoff=3.001), "Tremor damping: 3.000 → 3.001 Hz."),
        (changed(cruise_time=8.0), "Stops by itself after: 10 → 8 s."),
        (changed(turn_cruise_time=2.5), "Stops turning by itself after: 3.0 → 2.5 s."),
        (changed(turn_cruise_time=None), "Stops turning by itself after: 3 s → no time-out."),
        (changed(speeds=Speeds(forward=0.6)), "Forward speed: 0.80 → 0.60 m/s."),
        (changed(speeds=Speeds(turn=0.6)), "Turn speed: 69 → 34 °/s."),
        (gesture(dead_zone=0.25), "right_elbow counts from: 0.20 → 0.25 FS/s."),
        (gesture(full=1.2), "right_elbow is full: 1.00 → 1.20 FS/s."),
        (gesture(feature="displacement"), "right_elbow: moving → holding."),
        (gesture(direction=-1), "right_elbow, going back: counts in the other direction."),
        (changed(bindings=()), "Faster: right_elbow, gain 1 → nothing."),
        (
            changed(profile=small_profile(("right_elbow", "left_elbow", "left_wrist"))),
            "The calibration is another one.",
        ),
    ],
)
def test_each_field_has_its_sentence(now: DriveParameters, sentence: str) -> None:
    assert sentence in differences(now, STANDARD)


def test_every_speed_and_every_field_has_its_words() -> None:
    assert set(SPEEDS) == set(Speeds.model_fields)
    for name in SPEEDS:
        faster = Speeds(**{name: getattr(HIGHEST_SPEEDS, name)})
        assert len(differences(changed(speeds=faster), STANDARD)) == 1
