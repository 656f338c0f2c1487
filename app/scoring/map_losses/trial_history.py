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


class TrialHistory:
    """Reads trials with one set after the other; what was read with the present set is not read again."""

    def __init__(self) -> None:
        self._hash = ""
        self._read: dict[str, Mapping[str, GestureTrial]] = {}

    def losses(
        self, parameters: DriveParameters, calibrated: CalibrationProfile, trials: Sequence[PastTrial]
    ) -> dict[str, JointLoss]:
        """Return what each joint's present map loses, of the trials, oldest first (see `joint_losses`)."""
        if parameters.hash != self._hash:
            self._hash, self._read = parameters.hash, {}
        read = {}
        for trial in trials[-MOST_TRIALS:]:
            found = self._read.get(trial.name)
            if found is None:
                movement = trial.movement()
                found = gesture_trials(parameters, movement) if movement is not None else {}
            read[trial.name] = found
        self._read = read
        evidence = [TrialEvidence(read[trial.name], trial.fulls) for trial in trials[-MOST_TRIALS:]]
        return joint_losses(parameters, calibrated, evidence)
