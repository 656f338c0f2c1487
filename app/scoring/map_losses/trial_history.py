"""The trials with maps of one calibration, as the present set reads them: what a loss is told from."""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.movement import Movement
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.scoring.map_losses.gesture_trial import GestureTrial, gesture_trials
from app.scoring.map_losses.losses import TrialEvidence, joint_losses

MOST_TRIALS = 30  # the newest ones; older ones are not read again


class PastTrial(NamedTuple):
    """One trial: its name among the others, how to read it, and the fulls it was driven with."""

    name: str
    movement: Callable[[], Movement | None]  # None when it is gone
    fulls: Mapping[str, float]  # gesture -> FS/s


class ReadTrials(NamedTuple):
    """The figures of trials as one set reads them."""

    hash: str  # of the set
    figures: Mapping[str, Mapping[str, GestureTrial]]  # name of the trial -> gesture -> figures


NOTHING_READ = ReadTrials("", {})


def read_trials(
    parameters: DriveParameters, trials: Sequence[PastTrial], known: ReadTrials = NOTHING_READ
) -> ReadTrials:
    """Return the figures of the newest trials as `parameters` read them; those that are `known` are not read again."""
    same = known.figures if known.hash == parameters.hash else {}
    figures = dict(same)
    for trial in trials[-MOST_TRIALS:]:
        if trial.name not in figures:
            movement = trial.movement()
            figures[trial.name] = {} if movement is None else gesture_trials(parameters, movement)
    return ReadTrials(parameters.hash, {trial.name: figures[trial.name] for trial in trials[-MOST_TRIALS:]})


def losses_of(
    parameters: DriveParameters, calibrated: CalibrationProfile, trials: Sequence[PastTrial], read: ReadTrials
) -> dict[str, JointLoss]:
    """Return what the present map of each joint loses, told from trials, oldest first (see `joint_losses`)."""
    evidence = [TrialEvidence(read.figures[trial.name], trial.fulls) for trial in trials[-MOST_TRIALS:]]
    return joint_losses(parameters, calibrated, evidence)
