"""Proposes an adapted parameter set after the last trials, beside the one that drives (docs/learning/adapting.md)."""

from collections.abc import Mapping, Sequence

from app.calibration.adaptation.change_limits import STANDARD_LIMITS, ChangeLimits
from app.calibration.adaptation.channel_range import shift_ranges
from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.joint_proposal import AdaptationInput, JointAssessment, assess_joint
from app.calibration.adaptation.movement import Movement, gesture_of, map_trials
from app.calibration.adaptation.proposal_document import JointChange, Proposal
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.vocabulary import DriveParameters, Gesture


def propose(
    parameters: DriveParameters,
    movements: Sequence[Movement],
    losses: Mapping[str, JointLoss],
    limits: ChangeLimits = STANDARD_LIMITS,
    *,
    calibrated: CalibrationProfile | None = None,
    fresh: int | None = None,
) -> Proposal:
    """Return the proposed changes of map, dead-zones and fulls, for those joints whose present map loses something.

    Parameters
    ----------
    parameters
        The parameter set that drives now.
    movements
        The last trials with these parameters or their parents, oldest first, all recorded since the shirt was last put
        on.
    losses
        Joint -> what its present map loses, with the evidence in words. A joint that is not named stays as it is.
    limits
        How far it may change.
    calibrated
        The calibration that these parameters descend from, whose directions the limit of 30 degrees refers to; the
        profile of `parameters` when not given.
    fresh
        How many of the trials are new since the map last changed; all when not given. The map may turn by 2 degrees
        for each, and by 5 at once.
    """
    count = len(movements)
    new_trials = count if fresh is None else max(0, min(count, fresh))
    origin, profile = calibrated or parameters.profile, parameters.profile
    silenced = [name for name, loss in losses.items() if loss.silenced]
    if silenced and new_trials:
        profile = shift_ranges(profile, movements, calibrated, silenced)
    evidence = AdaptationInput(
        parameters,
        movements,
        map_trials(parameters, movements),
        losses,
        _joints_moved(parameters.profile, profile),
        limits,
        new_trials,
        {joint.name: joint for joint in origin.joints},
    )
    found = [
        assess_joint(evidence, joint, gesture)
        for joint in parameters.profile.joints
        if (gesture := gesture_of(parameters, joint.name)) is not None
    ]
    changes = tuple(one.change for one in found)
    new = _new_parameters(parameters, profile, found)
    applied = [one for one in changes if one.status == "applied"]
    felt = max((one.felt_change for one in applied), default=0.0)
    return Proposal(
        trials=count,
        joints=changes,
        felt_change=felt,
        warns=felt >= limits.warn,
        parameters=new if new != parameters else None,
        difference={
            "felt_change": felt,
            "joints": {one.name: one.model_dump(mode="json", exclude={"name"}) for one in applied},
        },
        reason=_sentence(changes, count),
    )


def _joints_moved(before: CalibrationProfile, after: CalibrationProfile) -> set[str]:
    """Return the joints of which a channel's range was shifted."""
    return {
        joint.name
        for joint in before.joints
        if any(before.low[channel] != after.low[channel] for channel in joint.channels)
    }


def _new_parameters(
    parameters: DriveParameters, profile: CalibrationProfile, found: Sequence[JointAssessment]
) -> DriveParameters:
    """Return the parameters with new weights and thresholds; the span and all else stay."""
    new = {one.change.name: one for one in found}
    joints = tuple(_with_weights(joint, new.get(joint.name)) for joint in profile.joints)
    gestures = tuple(_with_handles(parameters, gesture, new.get(gesture.joint)) for gesture in parameters.gestures)
    document = parameters.model_dump()
    document["profile"] = profile.model_copy(update={"joints": joints}).model_dump()
    document["gestures"] = [gesture.model_dump() for gesture in gestures]
    return DriveParameters.model_validate(document)


def _with_weights(joint: JointMap, new: JointAssessment | None) -> JointMap:
    is_new = new is not None and new.weights.tolist() != list(joint.direction)
    return joint.with_direction(new.weights.tolist()) if new is not None and is_new else joint


def _with_handles(parameters: DriveParameters, gesture: Gesture, new: JointAssessment | None) -> Gesture:
    """Return a gesture with its new thresholds; unchanged when its joint was assessed by another gesture."""
    if new is None or gesture_of(parameters, gesture.joint) != gesture:
        return gesture
    return gesture.model_copy(update={"dead_zone": new.thresholds.dead_zone, "full": new.thresholds.full})


def _sentence(changes: Sequence[JointChange], trials: int) -> str:
    """Return one sentence on which joints would change."""
    applied = [one.name.replace("_", " ") for one in changes if one.status == "applied"]
    refused = [one.name.replace("_", " ") for one in changes if one.status == "refused"]
    after = "the last trial" if trials == 1 else f"the last {trials} trials"
    if applied:
        words = f"After {after}, {', '.join(applied)} would change"
        return f"{words}; {', '.join(refused)} may not." if refused else f"{words}."
    if refused:
        return f"After {after}, nothing changes: what {', '.join(refused)} would need may not be done."
    return (
        f"After {after}, the calibration fits as well as before, and stays as it is."
        if trials
        else "No trial was driven yet."
    )
