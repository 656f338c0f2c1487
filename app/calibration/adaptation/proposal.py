"""Proposes an adapted parameter set after the last trials, beside the one that drives (docs/learning/adapting.md)."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from app.calibration.adaptation.change_limits import STANDARD_LIMITS, ChangeLimits
from app.calibration.adaptation.channel_range import shift_ranges, sound_channels
from app.calibration.adaptation.direction import (
    angle,
    exponential_covariance,
    felt_change,
    principal,
    share_along,
    turn_towards,
)
from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.movement import (
    MappedTrial,
    Movement,
    Numbers,
    gesture_of,
    map_trials,
    movement_rows,
    rate_along,
)
from app.calibration.adaptation.proposal_document import JointChange, Proposal, Status
from app.calibration.adaptation.thresholds import Thresholds, full_for, step_thresholds
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.vocabulary import DriveParameters, Gesture
from app.layout import ShirtLayout
from app.texts import Figure, Text, in_sequence

AT_ITS_END = Text("calibration-change-at-end")


@dataclass(frozen=True, slots=True)
class _Evidence:
    """The parameters, trials, losses and limits by which every joint is assessed."""

    parameters: DriveParameters
    movements: Sequence[Movement]
    trials: list[MappedTrial]
    losses: Mapping[str, JointLoss]
    shifted: Collection[str]  # joints of which the range that S5 checks follows the shirt
    limits: ChangeLimits
    fresh: int
    calibrated: dict[str, JointMap]


@dataclass(frozen=True, slots=True)
class _JointAssessment:
    """The change of one joint, and the weights and thresholds for the new parameters."""

    change: JointChange
    weights: Numbers
    thresholds: Thresholds


class _Turn(NamedTuple):
    """The turn of a joint's direction."""

    weights: Numbers  # (k,) after the turn; the old ones when there is none
    values: dict[str, object]  # fields of JointChange
    values_unturned: dict[str, object]  # fields of JointChange in case the turn is not applied
    refusal: Text | None  # why the direction may not turn, in one sentence; None when it may


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
    evidence = _Evidence(
        parameters,
        movements,
        map_trials(parameters, movements),
        losses,
        _joints_moved(parameters.profile, profile),
        limits,
        new_trials,
        {joint.name: joint for joint in origin.joints},
    )
    assessments = [
        _assess_joint(evidence, joint, gesture)
        for joint in parameters.profile.joints
        if (gesture := gesture_of(parameters, joint.name)) is not None
    ]
    changes = tuple(assessment.change for assessment in assessments)
    new = _new_parameters(parameters, profile, assessments)
    applied = [change for change in changes if change.status == "applied"]
    felt = max((change.felt_change for change in applied), default=0.0)
    return Proposal(
        trials=count,
        joints=changes,
        felt_change=felt,
        warns=felt >= limits.warn,
        parameters=new if new != parameters else None,
        difference={
            "felt_change": felt,
            "joints": {change.name: change.model_dump(mode="json", exclude={"name"}) for change in applied},
        },
        reason=_summary(changes, count, profile.layout),
    )


def _joints_moved(before: CalibrationProfile, after: CalibrationProfile) -> set[str]:
    """Return the joints of which a channel's range was shifted."""
    return {
        joint.name
        for joint in before.joints
        if any(before.low[channel] != after.low[channel] for channel in joint.channels)
    }


def _new_parameters(
    parameters: DriveParameters, profile: CalibrationProfile, assessments: Sequence[_JointAssessment]
) -> DriveParameters:
    """Return the parameters with new weights and thresholds; the span and all else stay."""
    new = {assessment.change.name: assessment for assessment in assessments}
    joints = tuple(_with_weights(joint, new.get(joint.name)) for joint in profile.joints)
    gestures = tuple(_with_thresholds(parameters, gesture, new.get(gesture.joint)) for gesture in parameters.gestures)
    document = parameters.model_dump()
    document["profile"] = profile.model_copy(update={"joints": joints}).model_dump()
    document["gestures"] = [gesture.model_dump() for gesture in gestures]
    return DriveParameters.model_validate(document)


def _with_weights(joint: JointMap, new: _JointAssessment | None) -> JointMap:
    is_new = new is not None and new.weights.tolist() != list(joint.direction)
    return joint.with_direction(new.weights.tolist()) if new is not None and is_new else joint


def _with_thresholds(parameters: DriveParameters, gesture: Gesture, new: _JointAssessment | None) -> Gesture:
    """Return a gesture with its new thresholds; unchanged when its joint was assessed by another gesture."""
    if new is None or gesture_of(parameters, gesture.joint) != gesture:
        return gesture
    return gesture.model_copy(update={"dead_zone": new.thresholds.dead_zone, "full": new.thresholds.full})


def _summary(changes: Sequence[JointChange], trials: int, layout: ShirtLayout) -> Text:
    """Return one sentence on which joints would change."""
    called = layout.joints_within
    applied = [called[change.name] for change in changes if change.status == "applied"]
    refused = [called[change.name] for change in changes if change.status == "refused"]
    if applied and refused:
        return Text("calibration-proposal-some", trials=trials, applied=applied, refused=refused)
    if applied:
        return Text("calibration-proposal", trials=trials, applied=applied)
    if refused:
        return Text("calibration-proposal-refused", trials=trials, refused=refused)
    return Text("calibration-proposal-none", trials=trials) if trials else Text("calibration-proposal-no-trial")


def _assess_joint(evidence: _Evidence, joint: JointMap, gesture: Gesture) -> _JointAssessment:
    """Return the change of one joint, first of its direction, then of its thresholds; refused when it would be felt.

    A joint that loses nothing stays as it is.
    """
    limits, old = evidence.limits, np.array(joint.direction)
    now = Thresholds(gesture.dead_zone, gesture.full)
    values: dict[str, object] = {
        "name": joint.name,
        "dead_zone_before": now.dead_zone,
        "full_before": now.full,
        "dead_zone_after": now.dead_zone,
        "full_after": now.full,
        "range_moved": joint.name in evidence.shifted,
    }
    loss = evidence.losses.get(joint.name)
    if stop := _reason_to_skip(evidence, joint, loss):
        return _JointAssessment(_change(values, stop[0], stop[1]), old, now)
    assert loss is not None
    moved = movement_rows(evidence.trials, joint)
    turn = _turn(evidence, joint, moved) if loss.turns and joint.map == "pca" else _Turn(old, {}, {}, None)
    values |= turn.values
    turns = not np.array_equal(turn.weights, old)
    thresholds = _thresholds(evidence, joint, gesture, loss, turns=turns)
    sample_rate = evidence.trials[-1].sample_rate
    felt = felt_change(old / now.full, turn.weights / thresholds.full, moved, sample_rate) if len(moved) else 0.0
    if felt >= limits.refuse:
        share, limit = Figure(100 * min(felt, 9.99)), Figure(100 * limits.refuse)
        too_much = Text("calibration-change-felt", percent=share, limit=limit)
        values |= turn.values_unturned
        values |= {"felt_change": min(felt, 1e6)}
        refused = _change(values, "refused", in_sequence([loss.message, too_much]))
        return _JointAssessment(refused, old, now)
    values |= {"dead_zone_after": thresholds.dead_zone, "full_after": thresholds.full}
    if turns or thresholds != now or values["range_moved"]:
        values |= {"felt_change": felt, "angle_applied_deg": angle(old, turn.weights) if turns else 0.0}
        change = _change(values, "applied", loss.message)
        reason = in_sequence([loss.message, *_effects(change, turn.refusal)])
        return _JointAssessment(change.model_copy(update={"reason": reason}), turn.weights, thresholds)
    refused = _change(values, "refused", in_sequence([loss.message, turn.refusal or AT_ITS_END]))
    return _JointAssessment(refused, old, now)


def _change(values: dict[str, object], status: Status, reason: Text) -> JointChange:
    return JointChange.model_validate({**values, "status": status, "reason": reason})


def _reason_to_skip(evidence: _Evidence, joint: JointMap, loss: JointLoss | None) -> tuple[Status, Text] | None:
    """Return status and reason of a joint that is not to be adapted, None for one that is."""
    if not evidence.trials or not evidence.fresh:
        return "unchanged", Text("calibration-change-no-trial")
    if loss is None:
        return "unchanged", Text("calibration-change-none")
    weighed = {channel for channel, weight in zip(joint.channels, joint.pca.rates[0], strict=True) if weight != 0.0}
    broken = sorted(weighed - set(sound_channels(evidence.parameters.profile, joint, evidence.movements)))
    if broken:
        name = evidence.parameters.profile.layout.channel_names[broken[0]]
        return "refused", Text("calibration-change-sensor", sensor=name)
    return None


def _turn(evidence: _Evidence, joint: JointMap, moved: Numbers) -> _Turn:
    """Return one limited turn towards the main direction of the movements `moved` (m, k), unless a limit refuses it."""
    limits, old = evidence.limits, np.array(joint.direction)
    sample_rate = evidence.trials[-1].sample_rate
    used = old != 0.0  # a weight of zero stays zero: the decoder does not read such a channel, and S5 does not check it
    covariance = exponential_covariance(moved * used, sample_rate) if len(moved) else np.zeros((len(old), len(old)))
    main = principal(covariance, old)
    if main is None or len(moved) < limits.least_movement * sample_rate:
        return _Turn(old, {}, {}, None)
    proposed = angle(old, main.weights)
    most = min(limits.per_update_deg, limits.per_trial_deg * evidence.fresh)
    weights = np.where(used, turn_towards(old, main.weights, most), 0.0) if proposed > limits.worth_it_deg else old
    calibrated = evidence.calibrated.get(joint.name, joint)
    same = calibrated.channels == joint.channels  # directions of another shirt cannot be compared
    away, before = (angle(np.array(calibrated.direction), direction) if same else 180.0 for direction in (weights, old))
    gesture = gesture_of(evidence.parameters, joint.name)
    assert gesture is not None
    talk = tuple(_cross_talk(evidence, joint, gesture, direction) for direction in (old, weights))
    unturned: dict[str, object] = {
        "angle_proposed_deg": proposed,
        "angle_from_calibration_deg": before,
        "evr_before": share_along(covariance, old),
        "evr_after": share_along(covariance, old),
        "cross_talk_before": talk[0],
        "cross_talk_after": talk[0],
    }
    values = unturned | {
        "angle_from_calibration_deg": away,
        "evr_after": share_along(covariance, weights),
        "cross_talk_after": talk[1],
    }
    refusal = None
    if np.array_equal(weights, old):
        pass
    elif main.share < limits.least_evr:
        share, least = Figure(100 * main.share), Figure(100 * limits.least_evr)
        refusal = Text("calibration-change-unclear", percent=share, least=least)
    elif away > limits.largest_angle_deg:
        refusal = Text("calibration-change-away", degrees=Figure(away))
    elif talk[0] is not None and talk[1] is not None and talk[1] > talk[0] + limits.cross_talk_slack:
        before_turn, after_turn = Figure(100 * talk[0]), Figure(100 * talk[1])
        refusal = Text("calibration-change-cross-talk", before=before_turn, after=after_turn)
    return _Turn(old, unturned, unturned, refusal) if refusal else _Turn(weights, values, unturned, None)


def _rates(evidence: _Evidence, joint: JointMap, gesture: Gesture, weights: Numbers) -> list[Numbers]:
    """Return the gesture's rate (n,) in FS/s in each trial, computed with `weights`."""
    return [
        gesture.direction * rate_along(joint, weights, trial.values, trial.sample_rate, evidence.parameters.cutoff)
        for trial in evidence.trials
    ]


def _thresholds(evidence: _Evidence, joint: JointMap, gesture: Gesture, loss: JointLoss, *, turns: bool) -> Thresholds:
    """Return the thresholds after one limited step towards those that answer the loss.

    While the direction `turns`, full waits: a direction beside the movement also makes it look weaker, and both steps
    at once could be felt too much.
    """
    dead_zone = gesture.dead_zone if loss.dead_zone is None else loss.dead_zone
    calibrated = evidence.calibrated.get(joint.name, joint)
    full = gesture.full if loss.growth is None or turns else full_for(calibrated, gesture.full, loss.growth)
    return step_thresholds(gesture, Thresholds(dead_zone, full))


def _cross_talk(evidence: _Evidence, joint: JointMap, gesture: Gesture, weights: Numbers) -> float | None:
    """Return the gesture's largest mean activation while another bound joint moves, over that while its own does."""
    rates = _rates(evidence, joint, gesture, weights)
    trials: Sequence[MappedTrial] = evidence.trials
    activation = [np.clip((rate - gesture.dead_zone) / (gesture.full - gesture.dead_zone), 0.0, 1.0) for rate in rates]

    def _mean(name: str) -> float | None:
        values = np.concatenate([active[trial.own[name]] for active, trial in zip(activation, trials, strict=True)])
        return float(values.mean()) if len(values) else None

    own_mean = _mean(joint.name)
    others = [
        value
        for other in trials[0].own
        if other != joint.name and gesture_of(evidence.parameters, other) and (value := _mean(other)) is not None
    ]
    return max(others) / max(own_mean, 0.05) if own_mean is not None and others else None


def _effects(change: JointChange, refusal: Text | None) -> list[Text]:
    """Return sentences on what is applied to a joint, and why its direction is not turned."""
    effects = [Text("calibration-change-range")] if change.range_moved else []
    if change.angle_applied_deg:
        applied, proposed = Figure(change.angle_applied_deg, 1), Figure(change.angle_proposed_deg or 0.0, 1)
        if proposed.number - applied.number < 0.05:
            effects.append(Text("calibration-change-turned", degrees=applied))
        else:
            effects.append(Text("calibration-change-turned-part", degrees=applied, proposed=proposed))
    if change.dead_zone_before != change.dead_zone_after:
        thresholds = _per_second(change.dead_zone_before, change.dead_zone_after)
        effects.append(Text("calibration-change-from", **thresholds))
    if change.full_before != change.full_after:
        effects.append(Text("calibration-change-full", **_per_second(change.full_before, change.full_after)))
    if refusal is not None:
        effects += [Text("calibration-change-unturned"), refusal]
    return effects


def _per_second(before: float | None, after: float | None) -> dict[str, Figure]:
    """Return thresholds (FS/s) in percent a second."""
    return {"before": Figure(100 * (before or 0.0)), "after": Figure(100 * (after or 0.0))}
