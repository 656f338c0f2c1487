"""Assesses one joint: how its direction and thresholds would follow what its map loses, or why they do not."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from app.calibration.adaptation.change_limits import ChangeLimits
from app.calibration.adaptation.channel_range import sound_channels
from app.calibration.adaptation.direction import (
    angle,
    exponential_covariance,
    felt_change,
    principal,
    share_along,
    turn_towards,
)
from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.movement import MappedTrial, Movement, Numbers, gesture_of, movement_rows, rate_along
from app.calibration.adaptation.proposal_document import JointChange, Status
from app.calibration.adaptation.thresholds import Thresholds, full_for, step_thresholds
from app.calibration.profile import JointMap
from app.calibration.vocabulary import DriveParameters, Gesture
from app.number_words import percent

ANEW = "calibrate this joint again"
AT_ITS_END = f"It cannot follow any further: {ANEW}."


@dataclass(frozen=True, slots=True)
class AdaptationInput:
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
class JointAssessment:
    """The change of one joint, and the weights and thresholds for the new parameters."""

    change: JointChange
    weights: Numbers
    thresholds: Thresholds


def assess_joint(evidence: AdaptationInput, joint: JointMap, gesture: Gesture) -> JointAssessment:
    """Return the change of one joint, first of its direction, then of its thresholds; refused when it would be felt.

    A joint that loses nothing stays as it is.
    """
    limits, old = evidence.limits, np.array(joint.direction)
    now = Thresholds(gesture.dead_zone, gesture.full)
    values: dict[str, Any] = {
        "name": joint.name,
        "dead_zone_before": now.dead_zone,
        "full_before": now.full,
        "dead_zone_after": now.dead_zone,
        "full_after": now.full,
        "range_moved": joint.name in evidence.shifted,
    }
    loss = evidence.losses.get(joint.name)
    if stop := _reason_to_skip(evidence, joint, loss):
        return JointAssessment(JointChange(**values, status=stop[0], reason=stop[1]), old, now)
    assert loss is not None
    moved = movement_rows(evidence.trials, joint)
    turn = _turn(evidence, joint, moved) if loss.turns and joint.map == "pca" else _Turn(old, {}, {}, "")
    values |= turn.values
    turns = not np.array_equal(turn.weights, old)
    thresholds = _thresholds(evidence, joint, gesture, loss, turns=turns)
    sample_rate = evidence.trials[-1].sample_rate
    felt = felt_change(old / now.full, turn.weights / thresholds.full, moved, sample_rate) if len(moved) else 0.0
    if felt >= limits.refuse:
        words = (
            f"The patient would feel a change of {percent(min(felt, 9.99))}, and from {percent(limits.refuse)} on it "
            f"is refused: {ANEW}."
        )
        values |= turn.values_unturned
        refused = JointChange(**values, felt_change=min(felt, 1e6), status="refused", reason=f"{loss.words} {words}")
        return JointAssessment(refused, old, now)
    values |= {"dead_zone_after": thresholds.dead_zone, "full_after": thresholds.full}
    if turns or thresholds != now or values["range_moved"]:
        values |= {"felt_change": felt, "angle_applied_deg": angle(old, turn.weights) if turns else 0.0}
        change = JointChange(**values, status="applied", reason="")
        reason = f"{loss.words} {_reason(change, turn.refusal)}"
        return JointAssessment(change.model_copy(update={"reason": reason}), turn.weights, thresholds)
    return JointAssessment(
        JointChange(**values, status="refused", reason=f"{loss.words} {turn.refusal or AT_ITS_END}"), old, now
    )


def _reason_to_skip(evidence: AdaptationInput, joint: JointMap, loss: JointLoss | None) -> tuple[Status, str] | None:
    """Return status and reason of a joint that is not to be adapted, None for one that is."""
    if not evidence.trials or not evidence.fresh:
        return "unchanged", "No trial was driven since the calibration last changed."
    if loss is None:
        return "unchanged", "The calibration fits it as well as before."
    weighed = {channel for channel, weight in zip(joint.channels, joint.pca.rates[0], strict=True) if weight != 0.0}
    broken = sorted(weighed - set(sound_channels(evidence.parameters.profile, joint, evidence.movements)))
    if broken:
        name = evidence.parameters.profile.layout.channel_names[broken[0]]
        return "refused", f"Sensor {name} is dead or at the end of its range: check the shirt, then calibrate again."
    return None


class _Turn(NamedTuple):
    """The turn of a joint's direction."""

    weights: Numbers  # (k,) after the turn; the old ones when there is none
    values: dict[str, Any]  # fields of JointChange
    values_unturned: dict[str, Any]  # fields of JointChange in case the turn is not applied
    refusal: str  # why the direction may not turn, in one sentence; empty when it may


def _turn(evidence: AdaptationInput, joint: JointMap, moved: Numbers) -> _Turn:
    """Return one limited turn towards the main direction of the movements `moved` (m, k), unless a limit refuses it."""
    limits, old = evidence.limits, np.array(joint.direction)
    sample_rate = evidence.trials[-1].sample_rate
    used = old != 0.0  # a weight of zero stays zero: the decoder does not read such a channel, and S5 does not check it
    covariance = exponential_covariance(moved * used, sample_rate) if len(moved) else np.zeros((len(old), len(old)))
    found = principal(covariance, old)
    if found is None or len(moved) < limits.least_movement * sample_rate:
        return _Turn(old, {}, {}, "")
    asked = angle(old, found.weights)
    most = min(limits.per_update_deg, limits.per_trial_deg * evidence.fresh)
    weights = np.where(used, turn_towards(old, found.weights, most), 0.0) if asked > limits.worth_it_deg else old
    calibrated = evidence.calibrated.get(joint.name, joint)
    same = calibrated.channels == joint.channels  # directions of another shirt cannot be compared
    away, before = (angle(np.array(calibrated.direction), one) if same else 180.0 for one in (weights, old))
    gesture = gesture_of(evidence.parameters, joint.name)
    assert gesture is not None
    talk = tuple(_cross_talk(evidence, joint, gesture, direction) for direction in (old, weights))
    unturned: dict[str, Any] = {
        "angle_proposed_deg": asked,
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
    refusal = ""
    if np.array_equal(weights, old):
        pass
    elif found.share < limits.least_evr:
        refusal = f"Its main movement is clear to only {percent(found.share)}, less than {percent(limits.least_evr)}."
    elif away > limits.largest_angle_deg:
        refusal = f"It would be {away:.0f} degrees away from the calibration: {ANEW}."
    elif talk[0] is not None and talk[1] is not None and talk[1] > talk[0] + limits.cross_talk_slack:
        refusal = f"It would answer more to other joints ({percent(talk[0])} before, {percent(talk[1])} after)."
    return _Turn(old, unturned, unturned, refusal) if refusal else _Turn(weights, values, unturned, "")


def _rates(evidence: AdaptationInput, joint: JointMap, gesture: Gesture, weights: Numbers) -> list[Numbers]:
    """Return the gesture's rate (n,) in FS/s in each trial, computed with `weights`."""
    return [
        gesture.direction * rate_along(joint, weights, trial.values, trial.sample_rate, evidence.parameters.cutoff)
        for trial in evidence.trials
    ]


def _thresholds(
    evidence: AdaptationInput, joint: JointMap, gesture: Gesture, loss: JointLoss, *, turns: bool
) -> Thresholds:
    """Return the thresholds after one limited step towards those that answer the loss.

    While the direction `turns`, full waits: a direction beside the movement also makes it look weaker, and both steps
    at once could be felt too much.
    """
    dead_zone = gesture.dead_zone if loss.dead_zone is None else loss.dead_zone
    calibrated = evidence.calibrated.get(joint.name, joint)
    full = gesture.full if loss.growth is None or turns else full_for(calibrated, gesture.full, loss.growth)
    return step_thresholds(gesture, Thresholds(dead_zone, full))


def _cross_talk(evidence: AdaptationInput, joint: JointMap, gesture: Gesture, weights: Numbers) -> float | None:
    """Return the gesture's largest mean activation while another bound joint moves, over that while its own does."""
    rates = _rates(evidence, joint, gesture, weights)
    trials: Sequence[MappedTrial] = evidence.trials
    activation = [np.clip((rate - gesture.dead_zone) / (gesture.full - gesture.dead_zone), 0.0, 1.0) for rate in rates]

    def _mean(name: str) -> float | None:
        values = np.concatenate([one[trial.own[name]] for one, trial in zip(activation, trials, strict=True)])
        return float(values.mean()) if len(values) else None

    own = _mean(joint.name)
    others = [
        value
        for other in trials[0].own
        if other != joint.name and gesture_of(evidence.parameters, other) and (value := _mean(other)) is not None
    ]
    return max(others) / max(own, 0.05) if own is not None and others else None


def _reason(change: JointChange, refusal: str) -> str:
    """Return one sentence on what is applied to a joint, and why its direction is not turned."""
    words = ["the range in which its sensors are believed follows the shirt"] if change.range_moved else []
    if change.angle_applied_deg:
        asked = change.angle_proposed_deg or 0.0
        part = "" if asked - change.angle_applied_deg < 0.05 else f" of the {asked:.1f} that its movements ask for"
        words.append(f"turned by {change.angle_applied_deg:.1f} degrees{part}")
    for what, before, after in (
        ("counts from", change.dead_zone_before, change.dead_zone_after),
        ("full at", change.full_before, change.full_after),
    ):
        if before is not None and after is not None and before != after:
            words.append(f"{what} {percent(after)} / s instead of {percent(before)} / s")
    unturned = f"; the direction stays: {refusal[0].lower()}{refusal[1:-1]}" if refusal else ""
    text = f"{'; '.join(words)}{unturned}."
    return text[:1].upper() + text[1:]
