"""Make a proposal to adapt a map from the recordings of the last trials."""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.calibration.adaptation.change_limits import STANDARD_LIMITS
from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.movement import Movement
from app.calibration.adaptation.proposal import propose
from app.calibration.adaptation.proposal_document import Proposal
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.recording.reader import read_run
from app.scoring.map_losses.losses import NOTHING_READ, PastTrial, ReadTrials, losses_of, read_trials
from app.scoring.trial_forecast import Effect, predicted_effect


class AdaptationResult(NamedTuple):
    """The proposal to adapt a parameter set, and its predicted effect on the newest trial."""

    proposal: Proposal
    effect: Effect | None  # None when nothing would change, or the trial cannot be decoded again
    read: ReadTrials = NOTHING_READ  # figures of the past trials, which need not be read again for the next proposal


class PastRun(NamedTuple):
    """The recording of a trial of this or an earlier session, and the fulls it was driven with."""

    folder: Path
    fulls: Mapping[str, float]  # gesture -> FS/s


def adapt_from_recordings(
    parameters: DriveParameters,
    calibrated: CalibrationProfile,
    folders: list[Path],
    fresh: int,
    past: Sequence[PastRun],
    past_read: ReadTrials = NOTHING_READ,
) -> AdaptationResult:
    """Return what the recordings of trials (the newest last) propose to change.

    `parameters` is the set that drives, `calibrated` the calibration that its map goes back to. The newest `fresh`
    recordings were driven with the map of `parameters`: each allows one small turn of the map. Earlier trials allowed
    theirs before. `past` are all trials with a map of this calibration, oldest first: they tell what the map loses. A
    recording that is gone, or of another shirt, is left out.
    """
    movements, fresh_read = [], 0
    for age, folder in zip(range(len(folders), 0, -1), folders, strict=True):
        movement = movement_of(folder, parameters)
        if movement is not None:
            movements.append(movement)
            fresh_read += age <= fresh
    trials = [PastTrial(str(run.folder), partial(movement_of, run.folder, parameters), run.fulls) for run in past]
    read = read_trials(parameters, trials, past_read)
    losses = losses_of(parameters, calibrated, trials, read)
    proposal = _proposal(parameters, calibrated, movements, losses, fresh_read)
    return AdaptationResult(proposal, _effect(parameters, proposal, folders[-1]) if folders else None, read)


def _effect(parameters: DriveParameters, proposal: Proposal, folder: Path) -> Effect | None:
    """Return the predicted effect on the newest trial; None when nothing changes or it cannot be decoded again."""
    if proposal.parameters is None:
        return None
    try:
        return predicted_effect(read_run(folder), parameters, proposal.parameters)
    except (ValueError, OSError):
        return None


def _proposal(
    parameters: DriveParameters,
    calibrated: CalibrationProfile,
    movements: list[Movement],
    losses: Mapping[str, JointLoss],
    fresh: int,
) -> Proposal:
    """Return the proposal of the largest step of which no joint's change is felt too much.

    The step grows with the trials since the last change. Without the smaller steps, a clinician who waits for more
    trials before deciding would be refused.
    """
    while True:
        proposal = propose(parameters, movements, losses, calibrated=calibrated, fresh=fresh)
        if fresh <= 1 or all(joint.felt_change < STANDARD_LIMITS.refuse for joint in proposal.joints):
            return proposal
        fresh -= 1


def movement_of(folder: Path, parameters: DriveParameters) -> Movement | None:
    """Return the movement of one recorded trial, None when it cannot be read or is of another shirt or rate."""
    try:
        run = read_run(folder)
    except (ValueError, OSError):
        return None
    rate, profile = float(run.meta.get("sample_rate", 0.0)), parameters.profile
    names = [channel["name"] for channel in run.meta.get("layout", {}).get("channels", ())]
    if names != list(profile.layout.channel_names) or abs(rate - profile.sample_rate) > 0.01 * profile.sample_rate:
        return None
    frames = run.frames()
    return Movement(frames["values"], rate, np.asarray(frames["state"] == State.ARMED))
