"""Warnings of control: one for each fault of a trial, none for a steady person, each with advice."""

import math
from typing import Any

import numpy as np
import pytest
from scoring.warning_cases import CONDITIONS, sessions_of, warnings_by_session

from app.scoring.control_quality import BadChannel, ControlQuality
from app.scoring.control_warnings import control_warnings
from app.scoring.joint_quality import JointQuality
from app.scoring.trial_assessment import TrialAssessment
from app.texts import reader_language

CHANNELS = ("e1", "e2", "e3")


def joint(turn_deg: float = 0.0, **more: Any) -> JointQuality:
    direction = (math.cos(math.radians(turn_deg)), math.sin(math.radians(turn_deg)), 0.0)
    known: dict[str, Any] = {"name": "right_elbow", "label": "Right elbow", "channels": CHANNELS, "dead_zone": 0.15}
    known |= {"map_angle_deg": 5.0, "evr": 0.95, "null_space_share": 0.05, "span": 2.0, "span_share": 1.0}
    known |= {"rest_rate": 0.02, "moved": 20.0, "activations": 20}
    known["direction"] = dict(zip(CHANNELS, direction, strict=True))
    return JointQuality.model_validate({**known, **more})


def trial(number: int, *joints: JointQuality, session: int = 1, per_metre: float = 2.0, **more: Any) -> TrialAssessment:
    figures: dict[str, Any] = {"map_angle_deg": 5.0, "evr": 0.95, "null_space_share": 0.05, "cross_talk": 0.0}
    seen = {"joints": joints or (joint(),), "bad_channels": more.pop("bad", ())}
    quality = ControlQuality(activations=20, activations_per_metre=per_metre, **figures, **seen)
    return TrialAssessment(
        number, number, session, more.pop("map_version", 1), more.pop("task", "clinic/main"), quality
    )


def bad(name: str, share: float, silent: bool = True) -> BadChannel:
    return BadChannel(name=name, joint="right_elbow", share=share, silent=silent)


def kinds(trials: list[TrialAssessment], **more: Any) -> list[str]:
    found = control_warnings(trials, **more).warnings
    assert all(
        len(str(one.message)) > 20 and len(str(one.advice)) > 20 and str(one.advice).endswith(".") for one in found
    )
    return [one.kind for one in found]


def test_no_trials_and_steady_trials_give_no_warning():
    assert control_warnings([]) == ([], None)
    random = np.random.default_rng(1)
    trials = [trial(n, joint(random.normal(0, 1.5), span=random.normal(2, 0.1)), session=1 + n // 4) for n in range(32)]
    assert control_warnings(trials) == ([], None)


def test_few_trials_are_called_few():
    assert "1 trial in the last session, 1 session in all" in str(control_warnings([trial(1)]).note)
    assert control_warnings([trial(n) for n in range(8)]).note is None
    assert "of one task" in str(control_warnings([trial(n, task=f"clinic/{n}") for n in range(8)]).note)


def test_a_sensor_that_failed_in_the_last_trial_is_named_with_what_to_do():
    (warning,) = control_warnings([trial(1), trial(2, bad=(bad("e2", 0.64),))]).warnings
    assert (warning.kind, str(warning.joint)) == ("sensor", "Right elbow")
    assert "e2 gave no signal for 64 %" in str(warning.message)
    assert "plug" in str(warning.advice)
    assert kinds([trial(1, bad=(bad("e2", 0.64),)), trial(2)]) == []
    assert kinds([trial(1, bad=(bad("e2", 0.01),))]) == []


def test_several_sensors_outside_their_range_mean_that_the_shirt_moved():
    outside = (bad("e1", 1.0, silent=False), bad("e3", 1.0, silent=False))
    (warning,) = control_warnings([trial(1, bad=outside)]).warnings
    assert (warning.kind, "2 sensors" in str(warning.message)) == ("map", True)
    assert "fit the calibration" in str(warning.advice)
    assert kinds([trial(1, bad=outside[:1])]) == ["sensor"]


def test_joints_are_called_as_the_reader_calls_them():
    bad_channels = [bad("e1", 1.0, silent=False), BadChannel(name="k1", joint="knee", share=1.0, silent=False)]
    (warning,) = control_warnings([trial(1, joint(), joint(name="knee", label="Knee"), bad=bad_channels)]).warnings
    assert "(right elbow and Knee)" in str(warning.message)
    with reader_language("de"):
        assert str(warning.joint) == "Rechter Ellbogen und Knee"
        assert "(rechter Ellbogen und Knee)" in str(warning.message)


def test_trials_with_an_older_map_give_no_warning_of_sensors_and_fit():
    broken = [trial(1), trial(2, joint(map_angle_deg=50.0), bad=(bad("e2", 0.64),))]
    broken.append(trial(3, joint(map_angle_deg=50.0), bad=(bad("e2", 0.64),)))
    assert kinds(broken) == ["sensor", "map"]
    assert kinds(broken, map_version=2) == []


@pytest.mark.parametrize(("turn_deg", "expected"), [(3.0, []), (12.0, ["map"])])
def test_a_direction_that_turned_since_the_first_trials_of_the_map(turn_deg, expected):
    trials = [trial(n) for n in range(3)] + [trial(3 + n, joint(turn_deg), session=2) for n in range(2)]
    assert kinds(trials) == expected
    if expected:
        assert "turned by 12°" in str(control_warnings(trials).warnings[0].message)
    assert kinds(trials[:-1]) == []  # one trial gives no warning


def test_a_new_map_begins_anew():
    turned = [trial(3 + n, joint(12.0), session=2, map_version=2) for n in range(3)]
    assert kinds([trial(n) for n in range(3)] + turned) == []


def test_a_map_that_never_fitted():
    trials = [trial(n, joint(map_angle_deg=41.0, null_space_share=0.43)) for n in range(3)]
    (warning,) = control_warnings(trials).warnings
    assert "41° off the calibration" in str(warning.message)
    assert "43 %" in str(warning.message)


def test_a_movement_with_a_falling_evr():
    trials = [trial(n, joint(evr=0.93)) for n in range(3)] + [trial(3 + n, joint(evr=0.6)) for n in range(3)]
    assert kinds(trials) == ["map"]
    assert kinds([trial(n, joint(evr=0.6)) for n in range(6)]) == []  # low from the first trial on


def test_a_guided_joint_is_called_one():
    trials = [trial(n, joint(map_angle_deg=41.0, guided=True, dead_zone=None)) for n in range(3)]
    assert "than the standard one drives" in str(control_warnings(trials).warnings[0].advice)


def test_noise_near_the_dead_zone_and_noise_that_grows():
    assert kinds([trial(n, joint(rest_rate=0.06)) for n in range(2)]) == ["noise"]
    assert kinds([trial(n, joint(rest_rate=0.045)) for n in range(2)]) == []
    growing = [trial(n, joint(rest_rate=0.01 * 1.08**n)) for n in range(10)]
    assert kinds(growing) == ["noise"]
    assert "times that of the first trials" in str(control_warnings(growing).warnings[0].message)
    assert kinds(growing[:7]) == []
    assert kinds([trial(n, joint(rest_rate=0.01 * 1.01**n)) for n in range(10)]) == []


def test_a_span_that_falls_over_sessions_or_within_one():
    def over(fall: float, per_metre: float = 0.0, task: str = "") -> list[TrialAssessment]:
        return [
            trial(
                3 * s + n,
                joint(span=2.0 * (1 - fall) ** s),
                session=s + 1,
                per_metre=2.0 - per_metre * (3 * s + n),
                task=task or "clinic/main",
            )
            for s in range(6)
            for n in range(3)
        ]

    assert kinds(over(0.02)) == ["span"]
    assert "10 % smaller over 6 sessions" in str(control_warnings(over(0.02)).warnings[0].message)
    assert kinds(over(0.01)) == []
    assert kinds(over(0.02)[:9]) == []  # three sessions
    assert kinds(over(0.02, per_metre=0.02)) == []  # fewer and smaller movements are skill
    tired = [trial(n, joint(span=2.0 * 0.96**n)) for n in range(9)]
    assert kinds(tired) == ["span"]
    assert "rest" in str(control_warnings(tired).warnings[0].advice)
    other = [trial(n, joint(span=1.0), task="clinic/corner") for n in range(3)]
    assert kinds([trial(n) for n in range(9)] + other) == []


def test_a_map_with_other_channels_is_not_compared():
    smaller = [trial(9 + n, joint(span=1.0, channels=("e1", "e2")), session=s) for s in range(2, 7) for n in range(2)]
    assert kinds([trial(n) for n in range(3)] + smaller) == []


@pytest.mark.parametrize(("name", "expected"), [("steady", set()), ("turned", {"map"}), ("channel dies", {"sensor"})])
def test_a_simulated_person_earns_the_right_warning(name, expected):
    """One seed and few trials; the table of many is in docs/learning/quality.md."""
    condition = CONDITIONS[name]._replace(sessions=2, trials=2)
    said = warnings_by_session(sessions_of(condition, 3, "clinic", "first-corner"))
    assert said[1] == []
    assert {one.kind for one in said[2]} == expected
