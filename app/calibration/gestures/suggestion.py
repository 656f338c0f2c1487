"""Suggests a vocabulary: the four gestures to drive with, chosen by their numbers."""

import math
from collections.abc import Mapping, Sequence
from itertools import combinations

from app.calibration.gestures.numbers import WORST_RATIO, FoundGesture, ratios
from app.calibration.map_grades import CROSS_TALK_LIMIT, signal_strength
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import Binding, Control, Gesture
from app.layout import ShirtLayout
from app.messages import MAX_GESTURES
from app.quantities import Document
from app.texts import Figure, Text, in_sequence

FORWARD_PART = "elbow"  # the paper drives forward and back with the elbows, and turns with the shoulders
EQUAL_COST = 0.1  # smaller differences are chance
REPEAT_PENALTY = 1.0  # added to the cost of a joint whose movement has to be repeated, so that it is taken last
LEAST_SAID = 0.1  # false activations a minute: smaller predictions are written as "fewer than 0.1"
MIRROR_WORTH = 0.25  # by which left and right of one body part may cost more: they are easier to remember

Shares = Mapping[str, float]
"""Name of another joint -> activation of a gesture during that joint's prompts, over that during its own prompts."""
Pair = tuple[FoundGesture, FoundGesture]


class SuggestedVocabulary(Document):
    """The suggested gestures and bindings, and the reason for them."""

    gestures: tuple[Gesture, ...]
    bindings: tuple[Binding, ...]
    reason: Text


class _Costs:
    """Costs of sets of gestures: the mean ratio of their numbers to the limits; 1 means at all limits.

    A set with two gestures that must not both be bound has no cost: `is_allowed` says so.
    """

    def __init__(
        self, profile: CalibrationProfile, gestures: Sequence[FoundGesture], shares: Mapping[str, Shares]
    ) -> None:
        repeated = {joint.name for joint in profile.joints if joint.has_to_be_repeated}
        self._shares = shares
        self._joints = [joint.name for joint in profile.joints]
        self._matrix = profile.cross_talk
        self._alone: dict[str, float] = {}
        for gesture in gestures:
            of_limits = ratios(gesture)
            alone = math.fsum(of_limits.values()) - of_limits["cross_talk"]
            self._alone[gesture.name] = alone / len(of_limits) + REPEAT_PENALTY * (gesture.joint in repeated)

    def together(self, first: FoundGesture, second: FoundGesture) -> float:
        """Return the larger share of one joint's activation during the other's prompts, of which the grades warn."""
        if self._matrix is None:
            return 0.0
        row, column = self._joints.index(first.joint), self._joints.index(second.joint)
        return max(self._matrix[row][column], self._matrix[column][row])

    def is_allowed(self, chosen: Sequence[FoundGesture]) -> bool:
        """Return whether no two of the chosen gestures come together."""
        return all(self.together(*pair) <= CROSS_TALK_LIMIT for pair in combinations(chosen, 2))

    def cross_talk(self, chosen: Sequence[FoundGesture]) -> float | None:
        """Return the mean cross-talk among the chosen gestures, None when it is unknown."""
        shares = [
            self._shares[gesture.name][other.joint]
            for gesture in chosen
            for other in chosen
            if other.joint in self._shares[gesture.name]
        ]
        return math.fsum(shares) / len(shares) if shares else None

    def of(self, chosen: Sequence[FoundGesture]) -> float:
        """Return the cost of the chosen gestures."""
        alone = math.fsum(self._alone[gesture.name] for gesture in chosen) / len(chosen)
        mutual = self.cross_talk(chosen)
        return alone + (1.0 if mutual is None else min(mutual / CROSS_TALK_LIMIT, WORST_RATIO)) / 4.0


def suggest_vocabulary(
    profile: CalibrationProfile, gestures: Sequence[FoundGesture], shares: Mapping[str, Shares]
) -> SuggestedVocabulary:
    """Return the two pairs of gestures with the lowest cost, that for u1 first, and the stop.

    A pair is left and right of one body part moved in the same direction, unless four other gestures cost clearly less.
    No two gestures use one joint, because each movement there is followed by one back. A joint that was not prompted
    while others were is not chosen, because its sign is unknown. With fewer than four joints, the first two gestures
    drive forward and back, and a third one turns. Both gestures of the first pair made together stop. Two gestures of
    which one comes with the other, beyond the limit of the grades, are never both bound: rather fewer than four are.
    """
    prompted = {joint.name for joint in profile.joints if joint.prompted}
    candidates = [gesture for gesture in gestures if gesture.joint in prompted] or list(gestures)
    costs = _Costs(profile, candidates, shares)
    chosen = _choose_gestures(profile, candidates, costs)
    controls: tuple[Control, ...] = ("u1+", "u1-", "u2+", "u2-")
    bindings = [
        Binding(control=control, gestures=(gesture.name,)) for control, gesture in zip(controls, chosen, strict=False)
    ]
    if len(chosen) > 1:
        bindings.append(Binding(control="stop", gestures=(chosen[0].name, chosen[1].name)))
    return SuggestedVocabulary(
        gestures=_gestures(gestures, chosen),
        bindings=tuple(bindings),
        reason=in_sequence(
            [
                *_reasons_of(chosen, costs.cross_talk(chosen), profile.layout),
                *_forecast(chosen),
                *_left_out(candidates, chosen, costs, profile.layout),
            ]
        ),
    )


def _choose_gestures(
    profile: CalibrationProfile, candidates: Sequence[FoundGesture], costs: _Costs
) -> list[FoundGesture]:
    """Return at most four gestures in the order u1+, u1-, u2+, u2-, no two of one joint."""
    order = [joint.name for joint in profile.joints]
    better = {
        joint: min(
            (gesture for gesture in candidates if gesture.joint == joint), key=lambda gesture: costs.of([gesture])
        )
        for joint in order
        if any(gesture.joint == joint for gesture in candidates)
    }
    sizes = range(min(len(better), 4), 0, -1)
    allowed = ([some for some in combinations(better.values(), size) if costs.is_allowed(some)] for size in sizes)
    sets = next(filter(None, allowed), [()])
    mirrored = [pair for pair in combinations(candidates, 2) if _is_mirrored(*pair) and costs.is_allowed(pair)]
    pairs_of_pairs = [
        (*first, *second)
        for first, second in combinations(mirrored, 2)
        if not _joints(first) & _joints(second) and costs.is_allowed((*first, *second))
    ]
    chosen = sets[0] if len(sets) == 1 else _cheapest(sets, costs)
    if pairs_of_pairs:
        mirror = _cheapest(pairs_of_pairs, costs)
        if len(chosen) < 4 or costs.of(mirror) <= costs.of(chosen) + MIRROR_WORTH:
            chosen = mirror
    if len(chosen) < 4:
        return list(chosen)
    first, second = (chosen[0], chosen[1]), (chosen[2], chosen[3])
    if FORWARD_PART in second[0].joint and FORWARD_PART not in first[0].joint:
        first, second = second, first
    return [*_right_first(first), *_right_first(second)]


def _cheapest(sets: Sequence[Sequence[FoundGesture]], costs: _Costs) -> Sequence[FoundGesture]:
    """Return the set of lowest cost; of nearly equal ones the first, as layouts name their main joints first."""
    all_costs = [costs.of(gestures) for gestures in sets]
    enough = min(all_costs) + EQUAL_COST
    return next(gestures for gestures, cost in zip(sets, all_costs, strict=True) if cost <= enough)


def _joints(pair: Pair) -> set[str]:
    return {gesture.joint for gesture in pair}


def _is_mirrored(first: FoundGesture, second: FoundGesture) -> bool:
    sides = {first.joint.partition("_")[0], second.joint.partition("_")[0]}
    parts = {first.joint.partition("_")[2], second.joint.partition("_")[2]}
    return sides == {"left", "right"} and len(parts) == 1 and first.direction == second.direction


def _right_first(pair: Pair) -> Pair:
    return (pair[1], pair[0]) if pair[1].joint.startswith("right") else pair


def _gestures(gestures: Sequence[FoundGesture], chosen: Sequence[FoundGesture]) -> tuple[Gesture, ...]:
    """Return the bound gestures and, as far as there is room, the prompted direction of every other joint."""
    bound = {gesture.name for gesture in chosen}
    others = [gesture for gesture in gestures if gesture.direction == 1 and gesture.name not in bound]
    names = bound | {gesture.name for gesture in others[: MAX_GESTURES - len(bound)]}
    return tuple(
        Gesture(
            name=gesture.name,
            joint=gesture.joint,
            direction=gesture.direction,
            dead_zone=gesture.dead_zone,
            full=gesture.full,
        )
        for gesture in gestures
        if gesture.name in names
    )


def _reasons_of(chosen: Sequence[FoundGesture], cross_talk: float | None, layout: ShirtLayout) -> list[Text]:
    names = [_called(gesture, layout) for gesture in chosen]
    signal = signal_strength(min(gesture.signal_to_noise for gesture in chosen))
    suggested = Text("calibration-suggested", gestures=names)
    if len(chosen) == 1:
        return [suggested, Text("calibration-suggested-one", signal=signal)]
    if cross_talk is None:
        return [suggested, Text("calibration-suggested-unprompted", signal=signal)]
    return [suggested, Text("calibration-suggested-several", signal=signal, percent=Figure(100 * cross_talk))]


def _called(gesture: FoundGesture, layout: ShirtLayout) -> Text | str:
    joint = layout.joints_within[gesture.joint]
    return joint if gesture.direction == 1 else Text("calibration-gesture-back", joint=joint)


def _left_out(
    candidates: Sequence[FoundGesture], chosen: Sequence[FoundGesture], costs: _Costs, layout: ShirtLayout
) -> list[Text]:
    """Return sentences on the joints that come with a chosen gesture, when fewer than four could be chosen."""
    if len(chosen) >= 4:
        return []
    sentences = []
    for joint in dict.fromkeys(gesture.joint for gesture in candidates):
        if all(gesture.joint != joint for gesture in chosen):
            gestures = [gesture for gesture in candidates if gesture.joint == joint]
            share, partner = min(
                max((costs.together(gesture, other), other.joint) for other in chosen) for gesture in gestures
            )
            names = {"joint": layout.joint_titles[joint], "partner": layout.joints_within[partner]}
            percent = Figure(100 * min(share, 9.99))
            sentences.append(Text("calibration-suggested-without", percent=percent, **names))
    return sentences


def _forecast(chosen: Sequence[FoundGesture]) -> list[Text]:
    """Return sentences on the predicted hit rate and false activations, and on the bound that the rest proves."""
    forecasts = [gesture.prediction for gesture in chosen if gesture.prediction is not None]
    hits = [forecast.hit_rate for forecast in forecasts if forecast.hit_rate is not None]
    rates = [forecast.false_per_minute for forecast in forecasts if forecast.false_per_minute is not None]
    bounds = [forecast.counted_at_most for forecast in forecasts if forecast.counted_at_most is not None]
    sentences = []
    if hits:
        sentences.append(Text("calibration-suggested-hits", hits=math.floor(100 * min(hits))))
    if rates:
        together = math.fsum(rates)
        proven = {
            "seconds": Figure(min(forecast.rest_seconds for forecast in forecasts)),
            "bound": Figure(max(bounds)),
        }
        if together >= LEAST_SAID:
            sentences.append(Text("calibration-suggested-false", rate=Figure(together, 1), **proven))
        else:
            sentences.append(Text("calibration-suggested-hardly-false", rate=LEAST_SAID, **proven))
    return sentences
