"""What becomes of one joint's map and handles after the last trials, gate by gate."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from app.calibration.adaptation.channel_range import sound_channels
from app.calibration.adaptation.direction import (
    angle,
    exponential_covariance,
    felt_change,
    principal,
    share_along,
    turned,
)
from app.calibration.adaptation.documents import JointChange, Limits, Part, Status
from app.calibration.adaptation.handles import Handles, stepped, wanted_dead_zone, wanted_full
from app.calibration.adaptation.movement import Heard, Movement, Numbers, gesture_of, moved_rows, rate_along
from app.calibration.fit.joint_fit import LEAST_RANGE
from app.calibration.profile import JointMap
from app.calibration.vocabulary import DriveParameters, Gesture


@dataclass(frozen=True, slots=True)
class Evidence:
    """What all joints are judged by."""

    parameters: DriveParameters
    movements: Sequence[Movement]
    heard: list[Heard]
    parts: Collection[Part]
    limits: Limits
    fresh: int
    calibrated: dict[str, JointMap]


@dataclass(frozen=True, slots=True)
class Judged:
    """A joint's change, with the weights and handles that go into the parameters."""

    change: JointChange
    weights: Numbers
    handles: Handles


def judged(evidence: Evidence, joint: JointMap, gesture: Gesture) -> Judged:
    """Return what becomes of one joint: first its direction, then its handles, then whether that would be felt."""
    limits, parts, old = evidence.limits, evidence.parts, np.array(joint.weights)
    now = Handles(gesture.dead_zone, gesture.full)
    told: dict[str, Any] = {
        "name": joint.name,
        "dead_zone_before": now.dead_zone,
        "full_before": now.full,
        "dead_zone_after": now.dead_zone,
        "full_after": now.full,
    }
    if stop := _nothing_to_learn_from(evidence, joint):
        return Judged(JointChange(**told, status=stop[0], reason=stop[1]), old, now)
    moved = moved_rows(evidence.heard, joint)
    turn = _turn(evidence, joint, moved)
    told |= turn.told
    weights = turn.weights if "map" in parts else old
    wanted = _handles(evidence, joint, gesture, weights)
    handles = Handles(
        wanted.dead_zone if "dead_zones" in parts else now.dead_zone, wanted.full if "full" in parts else now.full
    )
    if handles.full < handles.dead_zone + LEAST_RANGE:
        handles = now
    sample_rate = evidence.heard[-1].sample_rate
    felt = felt_change(old / now.full, weights / handles.full, moved, sample_rate) if len(moved) else 0.0
    turns = not np.array_equal(weights, old)
    if felt >= limits.refuse:
        words = f"It would be felt as a change of {min(felt, 9.99):.0%}, more than {limits.refuse:.0%}: refused."
        told |= turn.kept
        return Judged(JointChange(**told, felt_change=min(felt, 1e6), status="refused", reason=words), old, now)
    told |= {"dead_zone_after": handles.dead_zone, "full_after": handles.full}
    if turns or handles != now:
        told |= {"felt_change": felt, "angle_applied_deg": angle(old, weights) if turns else 0.0}
        change = JointChange(**told, status="applied", reason="")
        return Judged(change.model_copy(update={"reason": _why(change, turn.refused)}), weights, handles)
    if turn.refused:
        return Judged(JointChange(**told, status="refused", reason=turn.refused), old, now)
    if not np.array_equal(turn.weights, old) or wanted != now:
        told |= {"dead_zone_after": wanted.dead_zone, "full_after": wanted.full}
        words = "The last trials ask for a change, but this part is not to be adapted: shown only."
        return Judged(JointChange(**told, status="shown", reason=words), old, now)  # what it would be
    return Judged(JointChange(**told, status="unchanged", reason="The last trials ask for no change."), old, now)


def _nothing_to_learn_from(evidence: Evidence, joint: JointMap) -> tuple[Status, str] | None:
    """Return why a joint is left as it is before anything is computed."""
    if not evidence.heard or not evidence.fresh:
        return "unchanged", "No trial was driven since the map last changed."
    if joint.map == "guided":
        return "unchanged", "A guided map drives it, which is not adapted: calibrate again to renew it."
    weighed = {channel for channel, weight in zip(joint.channels, joint.weights, strict=True) if weight != 0.0}
    broken = sorted(weighed - set(sound_channels(evidence.parameters.profile, joint, evidence.movements)))
    if broken:
        name = evidence.parameters.profile.layout.channel_names[broken[0]]
        return "refused", f"Channel {name} is dead or at the end of its range: check the shirt, then calibrate again."
    return None


class _Turn(NamedTuple):
    """How a direction would turn; the old weights where it would not."""

    weights: Numbers
    told: dict[str, Any]
    kept: dict[str, Any]  # the same, for the case that it does not turn after all
    refused: str  # why it may not, in one sentence


def _turn(evidence: Evidence, joint: JointMap, moved: Numbers) -> _Turn:
    """Return the direction after one careful step towards that of the movements, if all gates are open."""
    limits, old = evidence.limits, np.array(joint.weights)
    sample_rate = evidence.heard[-1].sample_rate
    used = old != 0.0  # a weight of zero stays one: the decoder reads no such channel, and S5 does not watch it
    covariance = exponential_covariance(moved * used, sample_rate) if len(moved) else np.zeros((len(old), len(old)))
    found = principal(covariance, old)
    if found is None or len(moved) < limits.least_movement * sample_rate:
        return _Turn(old, {}, {}, "")
    asked = angle(old, found.weights)
    most = min(limits.per_update_deg, limits.per_trial_deg * evidence.fresh)
    weights = np.where(used, turned(old, found.weights, most), 0.0) if asked > limits.worth_it_deg else old
    calibrated = evidence.calibrated.get(joint.name, joint)
    same = calibrated.channels == joint.channels  # another shirt's calibration tells nothing of this one
    away, before = (angle(np.array(calibrated.weights), one) if same else 180.0 for one in (weights, old))
    gesture = gesture_of(evidence.parameters, joint.name)
    assert gesture is not None
    talk = tuple(_cross_talk(evidence, joint, gesture, direction) for direction in (old, weights))
    kept: dict[str, Any] = {
        "angle_proposed_deg": asked,
        "angle_from_calibration_deg": before,
        "evr_before": share_along(covariance, old),
        "evr_after": share_along(covariance, old),
        "cross_talk_before": talk[0],
        "cross_talk_after": talk[0],
    }
    told = kept | {
        "angle_from_calibration_deg": away,
        "evr_after": share_along(covariance, weights),
        "cross_talk_after": talk[1],
    }
    refused = ""
    if np.array_equal(weights, old):
        pass
    elif found.share < limits.least_evr:
        refused = f"One direction explains only {found.share:.0%} of its movement, less than {limits.least_evr:.0%}."
    elif away > limits.largest_angle_deg:
        refused = f"It would be {away:.0f} degrees away from the calibration: calibrate this joint again."
    elif talk[0] is not None and talk[1] is not None and talk[1] > talk[0] + limits.cross_talk_slack:
        refused = f"It would answer more to other joints ({talk[0]:.0%} before, {talk[1]:.0%} after)."
    return _Turn(old, kept, kept, refused) if refused else _Turn(weights, told, kept, "")


def _rates(evidence: Evidence, joint: JointMap, gesture: Gesture, weights: Numbers) -> list[Numbers]:
    """Return the gesture's rate (FS/s) in each trial with these weights."""
    return [
        gesture.direction * rate_along(joint, weights, trial.values, trial.sample_rate, evidence.parameters.cutoff)
        for trial in evidence.heard
    ]


def _handles(evidence: Evidence, joint: JointMap, gesture: Gesture, weights: Numbers) -> Handles:
    """Return the handles after one careful step towards what rest and strokes ask for."""
    rates = _rates(evidence, joint, gesture, weights)
    dead_zone = wanted_dead_zone(joint, evidence.heard, rates)
    full = wanted_full(joint, evidence.heard, rates, gesture)
    wanted = Handles(gesture.dead_zone if dead_zone is None else dead_zone, gesture.full if full is None else full)
    return stepped(gesture, wanted, evidence.fresh)


def _cross_talk(evidence: Evidence, joint: JointMap, gesture: Gesture, weights: Numbers) -> float | None:
    """Return the largest activation while another bound joint moves, as a share of that while its own does."""
    rates = _rates(evidence, joint, gesture, weights)
    heard: Sequence[Heard] = evidence.heard
    activation = [np.clip((rate - gesture.dead_zone) / (gesture.full - gesture.dead_zone), 0.0, 1.0) for rate in rates]

    def _mean(name: str) -> float | None:
        values = np.concatenate([one[trial.own[name]] for one, trial in zip(activation, heard, strict=True)])
        return float(values.mean()) if len(values) else None

    own = _mean(joint.name)
    others = [
        value
        for other in heard[0].own
        if other != joint.name and gesture_of(evidence.parameters, other) and (value := _mean(other)) is not None
    ]
    return max(others) / max(own, 0.05) if own is not None and others else None


def _why(change: JointChange, refused: str) -> str:
    """Return in one sentence what is applied to a joint, and what of it is not."""
    words = []
    if change.angle_applied_deg:
        asked = change.angle_proposed_deg or 0.0
        part = "" if asked - change.angle_applied_deg < 0.05 else f" of the {asked:.1f} that its movements ask for"
        words.append(f"turned by {change.angle_applied_deg:.1f} degrees{part}")
    for what, before, after in (
        ("dead-zone", change.dead_zone_before, change.dead_zone_after),
        ("full", change.full_before, change.full_after),
    ):
        if before is not None and after is not None and before != after:
            words.append(f"{what} from {before:.2f} to {after:.2f} FS/s")
    kept = f"; the direction stays: {refused[0].lower()}{refused[1:-1]}" if refused else ""
    text = f"{'; '.join(words)}{kept}."
    return text[:1].upper() + text[1:]
