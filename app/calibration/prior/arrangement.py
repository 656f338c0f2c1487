"""Finds how a ring of sensors sits on the body: as on other people, turned by some places, or mirrored.

Two things of the first seconds of movement tell the sensors of a ring apart: how far each moves, and which of them move
together. Both are compared with those of other people for every way in which the ring may sit.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import Arrangement
from app.calibration.prior.scale import log_ranges
from app.signals.low_pass import STANDARD_CUTOFF, smooth

LARGEST_CORRELATION = 0.999  # keeps atanh finite
SMALLEST_DEVIATION = 0.05  # of log ranges and of atanh of correlations: a few people differ less than all people do
PAIR_WEIGHT = 0.5
LARGEST_SQUARE = 16.0  # of a difference in deviations: one sensor that hardly moves does not decide about the others
# Cost added to each mirrored arrangement: a ring mirrored about its middle sensor is similar to itself. On the real
# knit, the cost of rings that were not mirrored was lower by up to 11 when they were taken as mirrored.
MIRROR_MARGIN = 15.0

Array = NDArray[np.float64]


class RingMovement(NamedTuple):
    """What tells the k sensors of a ring apart, in the ring's order; -inf, or NaN, for one that stands still."""

    logs: Array  # (k,) logarithm of the range of each
    pairs: Array  # (k, k) atanh of the correlation of the rates of each pair


@dataclass(frozen=True, slots=True)
class RingMoments:
    """Sums over people of what tells the sensors of a ring apart, and of its squares."""

    people: float
    logs: Array  # (k,) of the centred log ranges
    logs_squared: Array  # (k,)
    pairs: Array  # (k, k)
    pairs_squared: Array  # (k, k)

    @classmethod
    def of(cls, movement: RingMovement) -> Self:
        """Return the moments of one recording, all of whose sensors move."""
        logs = movement.logs - movement.logs.mean()
        return cls(1.0, logs, logs**2, movement.pairs, movement.pairs**2)

    def __add__(self, other: Self) -> Self:
        return type(self)(
            self.people + other.people,
            self.logs + other.logs,
            self.logs_squared + other.logs_squared,
            self.pairs + other.pairs,
            self.pairs_squared + other.pairs_squared,
        )

    def __mul__(self, share: float) -> Self:
        return type(self)(
            share * self.people,
            share * self.logs,
            share * self.logs_squared,
            share * self.pairs,
            share * self.pairs_squared,
        )


def ring_movement(values: Array, sample_rate: float) -> RingMovement:
    """Return what tells the sensors of a ring apart, from frames (n, k) in the ring's order, without NaN."""
    rates = np.diff(smooth(values, STANDARD_CUTOFF, sample_rate), axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        correlation = np.asarray(np.corrcoef(rates, rowvar=False))
    np.fill_diagonal(correlation, 0.0)
    return RingMovement(
        log_ranges(values, sample_rate), np.arctanh(np.clip(correlation, -LARGEST_CORRELATION, LARGEST_CORRELATION))
    )


def sensors_at(arrangement: Arrangement, count: int) -> NDArray[np.int_]:
    """Return (count,) which sensor, by its own place in the ring, lies where each place of the ring should be."""
    places = np.arange(count)
    return (arrangement.shift - places if arrangement.mirrored else arrangement.shift + places) % count


def find_arrangement(movement: RingMovement, people: RingMoments) -> Arrangement:
    """Return the way to sit in which the ring's movement is most like that of other people.

    Sensors that stand still are not compared. A mirrored ring must be clearly more alike than any that is not.
    """
    count = len(movement.logs)
    moves = np.isfinite(movement.logs)
    if moves.sum() < 2:
        return Arrangement()
    log_mean, log_deviation = _mean_and_deviation(people.logs, people.logs_squared, people.people)
    pair_mean, pair_deviation = _mean_and_deviation(people.pairs, people.pairs_squared, people.people)
    ways = [Arrangement(shift=shift, mirrored=mirrored) for mirrored in (False, True) for shift in range(count)]
    costs = []
    for way in ways:
        sensors = sensors_at(way, count)
        there = moves[sensors]
        logs = movement.logs[sensors][there]
        apart = ((logs - logs.mean()) - (log_mean[there] - log_mean[there].mean())) / log_deviation[there]
        both = np.ix_(there, there)
        turned = (movement.pairs[np.ix_(sensors, sensors)][both] - pair_mean[both]) / pair_deviation[both]
        pairs = np.triu(np.minimum(turned**2, LARGEST_SQUARE), 1)
        cost = float(np.minimum(apart**2, LARGEST_SQUARE).sum() + PAIR_WEIGHT * pairs.sum())
        costs.append(cost + MIRROR_MARGIN * way.mirrored)
    return ways[int(np.argmin(costs))]


def total(rings: Sequence[RingMoments]) -> RingMoments:
    """Return the sum of at least one ring's moments."""
    return reduce(add, rings)


def _mean_and_deviation(total: Array, squares: Array, people: float) -> tuple[Array, Array]:
    mean = total / people
    return mean, np.maximum(np.sqrt(np.maximum(squares / people - mean**2, 0.0)), SMALLEST_DEVIATION)
