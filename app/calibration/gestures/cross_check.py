"""Predicts from one part of the recordings how a gesture will behave, and checks the prediction on the other part."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.calibration.dead_zone import LEAST_RANGE
from app.calibration.fit.joint_evidence import full_rate
from app.calibration.gestures.ability import Ability
from app.calibration.gestures.evidence import Evidence
from app.calibration.gestures.numbers import HitCheck, Prediction, RestCheck
from app.calibration.gestures.prediction import (
    HIT_ACTIVATION,
    at_least_share,
    at_most_per_minute,
    count_crossings,
    false_per_minute,
    hit_probability,
    rest_statistics,
)

Pieces = list[NDArray[np.float64]]


def predict(ability: Ability, all_abilities: Sequence[Ability], evidence: Evidence) -> Prediction | None:
    """Return false activations and hits to be expected of a gesture; None without rest and without repetitions."""
    first, second = _two_parts_of_rest(ability, evidence)
    quiet = rest_statistics([*first, *second], evidence.sample_rate)
    others = [other.peaks for other in all_abilities if other.joint.name != ability.joint.name and len(other.rates) > 1]
    peaks = ability.peaks
    if quiet is None and not peaks:
        return None
    counted = count_crossings([*first, *second], ability.dead_zone)
    hits = sum(peak >= hit_level(ability.dead_zone, ability.full) for peak in peaks)
    return Prediction(
        false_per_minute=None if quiet is None else false_per_minute(quiet, ability.dead_zone),
        counted=counted,
        rest_seconds=0.0 if quiet is None else quiet.seconds,
        counted_at_most=None if quiet is None else at_most_per_minute(counted, quiet.seconds),
        hit_rate=hit_probability(peaks, hit_level(ability.dead_zone, ability.full), others) if peaks else None,
        hit_at_least=at_least_share(hits, len(peaks)) if peaks else None,
        rest_check=_check_rest(ability.dead_zone, first, second, evidence.sample_rate),
        hit_check=_check_hits(ability, others),
    )


def _two_parts_of_rest(ability: Ability, evidence: Evidence) -> tuple[Pieces, Pieces]:
    """Return the rest to predict from and the rest to check on: the step at rest and the pauses, else two halves."""
    way = ability.direction
    first = [way * piece for piece in evidence.at_rest(ability.column)]
    second = [way * piece for piece in evidence.in_pauses(ability.column, ability.joint.name)]
    if not second:
        halves = [np.array_split(piece, 2) for piece in first]
        first, second = [half[0] for half in halves], [half[1] for half in halves]
    return first, second


def _check_rest(dead_zone: float, first: Pieces, second: Pieces, sample_rate: float) -> RestCheck | None:
    before = rest_statistics(first, sample_rate)
    seconds = sum(map(len, second)) / sample_rate
    if before is None or not seconds:
        return None
    return RestCheck(
        predicted=false_per_minute(before, dead_zone),
        counted=count_crossings(second, dead_zone),
        seconds=seconds,
    )


def _check_hits(ability: Ability, others: Sequence[Sequence[float]]) -> HitCheck | None:
    """Cross-check the hit rate by leaving one repetition out: `full` and spread are those of the other repetitions."""
    count = len(ability.rates)
    if count < 2:
        return None
    predicted = counted = 0.0
    for left_out in range(count):
        rest = [rate for index, rate in enumerate(ability.rates) if index != left_out]
        full = max(full_rate(rest, ability.dead_zone) or 0.0, ability.dead_zone + LEAST_RANGE)
        level = hit_level(ability.dead_zone, full)
        predicted += hit_probability([float(rate.max()) for rate in rest], level, others) / count
        counted += float(ability.rates[left_out].max()) >= level
    return HitCheck(predicted=min(1.0, predicted), counted=int(counted), repetitions=count)


def hit_level(dead_zone: float, full: float) -> float:
    """Return the rate (FS/s) from which on a movement counts as a hit: half of a full activation."""
    return dead_zone + HIT_ACTIVATION * (full - dead_zone)
