"""Proposals to adapt the map, made from recordings on disk."""

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from session.test_recordings import JOINTS, LAYOUT, RATE, record

from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.proposal import propose
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.faults import State
from app.messages import Tick
from app.session.adaptation_reading import PastRun, adapt_from_recordings, movement_of
from app.texts import Text
from building import joint_map, profile_of

Recorder = Callable[..., Path]
AS_CALIBRATED, PUT_ON_AGAIN = (1.0, -0.6), (1.0, -0.05)  # how a joint's two channels answer to its angle
SIZE = math.hypot(*AS_CALIBRATED)


@pytest.fixture
def parameters() -> DriveParameters:
    rates, figures = [gain / SIZE**2 for gain in AS_CALIBRATED], {"full": 3.0, "evr": 0.95}
    maps = [joint_map(joint, (2 * i, 2 * i + 1), rates, AS_CALIBRATED, **figures) for i, joint in enumerate(JOINTS)]
    return standard_parameters(profile_of(LAYOUT, maps, -1.0, 1.5, RATE))


@pytest.fixture
def trial(tmp_path: Path) -> Recorder:
    """Record a trial of 30 s in which one joint moves after the other."""

    def _record(name: str, gains: tuple[float, float] = PUT_ON_AGAIN, state: State = State.ARMED) -> Path:
        random = np.random.default_rng(5)
        ticks = []
        for number in range(round(30 * RATE)):
            t = number / RATE
            turn, within = divmod(t, 1.5)
            angle = dict.fromkeys(JOINTS, 0.0)
            if within < 1.0:
                angle[JOINTS[int(turn) % 2]] = 0.5 - 0.5 * math.cos(2 * math.pi * within)
            values = np.array([gain * angle[joint] for joint in JOINTS for gain in gains]) + random.normal(0, 0.002, 4)
            ticks.append(Tick(t=t, t_device=t, frame_seq=number, state=state, values=values.astype(np.float32)))
        return record(tmp_path / name, ticks)

    return _record


@pytest.fixture
def earlier(trial: Recorder) -> list[Path]:
    """Return the recordings of five trials of an earlier session, with the shirt as it was calibrated."""
    return [trial("earlier", AS_CALIBRATED)] * 5


def answer(parameters: DriveParameters, folders: list[Path], fresh: int, earlier: Sequence[Path] = ()) -> Any:
    fulls = {gesture.name: gesture.full for gesture in parameters.gestures}
    past = [PastRun(folder, fulls) for folder in [*earlier, *folders]]
    return adapt_from_recordings(parameters, parameters.profile, folders, fresh, past)


def adapt(parameters: DriveParameters, folders: list[Path], fresh: int, earlier: Sequence[Path] = ()) -> Any:
    return answer(parameters, folders, fresh, earlier).proposal


def test_a_shirt_that_hides_the_movement_turns_the_map_two_degrees_for_each_new_trial(
    parameters: DriveParameters, trial: Recorder, earlier: list[Path]
) -> None:
    folders = [trial(name) for name in "abc"]
    for fresh in (1, 2):
        for joint in adapt(parameters, folders, fresh, earlier).joints:
            assert joint.status == "applied"
            assert joint.angle_proposed_deg == pytest.approx(28.0, abs=1.0)
            assert joint.angle_applied_deg == pytest.approx(2.0 * fresh)
            assert joint.evr_after > joint.evr_before
            assert "goes in another direction" in str(joint.reason)


def test_one_trial_alone_turns_nothing(parameters: DriveParameters, trial: Recorder, earlier: list[Path]) -> None:
    assert adapt(parameters, [trial("a")], 1, earlier).parameters is None


def test_who_waits_is_offered_a_smaller_step_instead_of_a_refusal(
    parameters: DriveParameters, trial: Recorder, earlier: list[Path]
) -> None:
    folders = [trial(name, (1.0, 0.5)) for name in "abc"]
    movements = [one for folder in folders if (one := movement_of(folder, parameters))]
    everything = {joint: JointLoss(Text("calibration-loss-noise"), turns=True) for joint in JOINTS}
    asked = propose(parameters, movements, everything, fresh=3)
    assert {joint.status for joint in asked.joints} == {"refused"}
    for joint in adapt(parameters, folders, 3, earlier).joints:
        assert joint.status == "applied"
        assert 0.0 < joint.felt_change < 0.10


def test_the_effect_is_what_the_last_trial_would_have_been(
    parameters: DriveParameters, trial: Recorder, earlier: list[Path]
) -> None:
    effect = answer(parameters, [trial(name) for name in "abc"], 1, earlier).effect
    assert effect is not None
    assert effect.seconds == pytest.approx(30.0, abs=0.1)
    assert 18 <= effect.activations_before <= 22
    assert 18 <= effect.activations_after <= 22
    assert 0.0 < effect.felt_change < 0.10
    assert effect.alike > 0.95


def test_a_map_that_fits_stays(parameters: DriveParameters, trial: Recorder) -> None:
    assert adapt(parameters, [trial("a", AS_CALIBRATED)] * 6, 1).parameters is None


def test_what_was_read_for_one_proposal_is_known_for_the_next(parameters: DriveParameters, trial: Recorder) -> None:
    folder = trial("a")
    read = answer(parameters, [folder], 1).read
    assert (read.hash, set(read.figures)) == (parameters.hash, {str(folder)})
    assert set(read.figures[str(folder)]) == set(JOINTS)


def test_what_cannot_be_read_or_never_moved_says_nothing(
    parameters: DriveParameters, trial: Recorder, earlier: list[Path], tmp_path: Path
) -> None:
    gone = tmp_path / "gone"
    assert adapt(parameters, [gone], 1).parameters is None
    assert adapt(parameters, [trial("still", state=State.DISARMED)] * 8, 1).parameters is None
    # The new trial is gone: those before have had their turn already.
    assert adapt(parameters, [*[trial("old")] * 3, gone], 1, earlier).parameters is None
    joints = adapt(parameters, [gone, *[trial("new")] * 3], 1, earlier).joints
    assert joints[0].angle_applied_deg == pytest.approx(2.0)
    other = parameters.profile.model_copy(update={"sample_rate": 200.0})
    assert adapt(parameters.model_copy(update={"profile": other}), [tmp_path / "new"], 1).parameters is None
