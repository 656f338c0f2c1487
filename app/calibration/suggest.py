"""The suggested vocabulary: which four gestures to drive with, and the numbers that speak for them."""

import math
from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.vocabulary import Binding, Control

FORWARD_PART = "elbow"  # the paper drives forward and back with the elbows, and turns with the shoulders
EQUAL_COST = 0.05  # smaller differences are chance
REPEAT_PENALTY = 1.0  # a joint graded `repeat` is taken only when nothing else is there
LEAST_SIGNAL_TO_NOISE = 0.1

Pair = tuple[JointMap, JointMap]


class Suggestion(NamedTuple):
    """Bindings, and why these."""

    bindings: tuple[Binding, ...]
    reason: str


def suggest_bindings(profile: CalibrationProfile) -> Suggestion:
    """Return the two antagonist pairs with the least cross-talk and the best signal to noise, u1 first.

    Left and right of one body part make a pair where there are two such pairs; otherwise any two joints do. With
    fewer than four joints, one pair (or one gesture) drives forward and back, and what is left turns. Both gestures of
    the first pair together stop. Gestures are named after their joints, as in `standard_parameters`.
    """
    joints = list(profile.joints)
    if len(joints) < 4:
        chosen = joints
    else:
        mirrored = [pair for pair in combinations(joints, 2) if _mirrored(*pair)]
        chosen = _best_four(profile, mirrored) or _best_four(profile, list(combinations(joints, 2)))
    controls: tuple[Control, ...] = ("u1+", "u1-", "u2+", "u2-")
    bindings = [
        Binding(control=control, gestures=(joint.name,)) for control, joint in zip(controls, chosen, strict=False)
    ]
    if len(chosen) > 1:
        bindings.append(Binding(control="stop", gestures=(chosen[0].name, chosen[1].name)))
    return Suggestion(tuple(bindings), _reason(profile, chosen))


def _best_four(profile: CalibrationProfile, pairs: Sequence[Pair]) -> list[JointMap]:
    """Return four joints, u1+ u1- u2+ u2-, or nothing when no two pairs are disjoint."""
    candidates = [
        (one, other)
        for one, other in combinations(pairs, 2)
        if not {joint.name for joint in one} & {joint.name for joint in other}
    ]
    if not candidates:
        return []
    # Among equals the first wins: the layout's own order, in which the main joints come first.
    one, other = min(candidates, key=lambda both: math.floor(_cost(profile, [*both[0], *both[1]]) / EQUAL_COST))
    if FORWARD_PART in other[0].name and FORWARD_PART not in one[0].name:
        one, other = other, one
    return [*_right_first(one), *_right_first(other)]


def _cost(profile: CalibrationProfile, joints: Sequence[JointMap]) -> float:
    """Return the mean cross-talk plus the mean noise-to-signal ratio, both shares of a full activation."""
    noise = sum(1.0 / max(joint.signal_to_noise or 0.0, LEAST_SIGNAL_TO_NOISE) for joint in joints) / len(joints)
    repeats = REPEAT_PENALTY * sum(joint.grade == "repeat" for joint in joints)
    return _mean_cross_talk(profile, joints) + noise + repeats


def _mean_cross_talk(profile: CalibrationProfile, joints: Sequence[JointMap]) -> float:
    if profile.cross_talk is None or len(joints) < 2:
        return 0.0
    names = [joint.name for joint in profile.joints]
    places = [names.index(joint.name) for joint in joints]
    shares = [profile.cross_talk[row][column] for row in places for column in places if row != column]
    return sum(shares) / len(shares)


def _mirrored(one: JointMap, other: JointMap) -> bool:
    sides = {one.name.partition("_")[0], other.name.partition("_")[0]}
    return sides == {"left", "right"} and one.name.partition("_")[2] == other.name.partition("_")[2]


def _right_first(pair: Pair) -> Pair:
    return (pair[1], pair[0]) if pair[1].name.startswith("right") else pair


def _reason(profile: CalibrationProfile, joints: Sequence[JointMap]) -> str:
    names = ", ".join(joint.name for joint in joints)
    weakest = min(joint.signal_to_noise or 0.0 for joint in joints)
    words = f"Suggested: {names}. The weakest of them stands {weakest:.0f} times above its noise"
    if profile.cross_talk is None:
        return f"{words}; nothing was prompted, so cross-talk is not known."
    return (
        f"{words}; on average {_mean_cross_talk(profile, joints):.0%} of another's activation appears while one moves."
    )
