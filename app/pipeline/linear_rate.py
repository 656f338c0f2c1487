"""The rate of a linear map, frame by frame: projections, earlier rates, two slow averages, one low-pass."""

import math

import numpy as np
from numpy.typing import NDArray

from app.butterworth import Coefficients
from app.calibration.profile import AVERAGING_TIMES, RATE_LAGS, LinearMap
from app.calibration.vocabulary import DriveParameters, Gesture
from app.pipeline.low_pass import LowPass

LEVELS = len(AVERAGING_TIMES)  # projections that are not differentiated; they follow those that are


def linear_map_of(parameters: DriveParameters, gesture: Gesture) -> LinearMap | None:
    """Return the linear map that a gesture reads; None for the PCA map, which a displacement gesture always reads."""
    if gesture.feature != "rate":
        return None
    return next(joint.linear for joint in parameters.profile.joints if joint.name == gesture.joint)


def linear_projection(parameters: DriveParameters) -> tuple[NDArray[np.float64], dict[int, slice]]:
    """Return weights (n_rows, n_channels) in FS and FS/s, and which rows belong to each gesture with a linear map.

    The rows of a gesture are the parts of its map; those of a gesture against the prompted direction have the opposite
    sign.
    """
    channels = {joint.name: list(joint.channels) for joint in parameters.profile.joints}
    count = len(parameters.profile.layout.channels)
    rows: list[NDArray[np.float64]] = []
    places = {}
    for index, gesture in enumerate(parameters.gestures):
        linear = linear_map_of(parameters, gesture)
        if linear is None:
            continue
        places[index] = slice(len(rows), len(rows) + len(linear.parts))
        for part in linear.parts:
            row = np.zeros(count)
            row[channels[gesture.joint]] = gesture.direction * np.array(part)
            rows.append(row)
    return np.array(rows).reshape(-1, count), places


class LinearRate:
    """The rate of one gesture; a change while a channel was bad does not count as a movement afterwards."""

    def __init__(self, coefficients: Coefficients, sample_rate: float, parts: int) -> None:
        self._low_pass = LowPass(coefficients)
        self._parts = parts  # projections: the one that is differentiated, earlier ones, and two levels
        self._first_level = parts - LEVELS
        self._earlier = EarlierMovement(sample_rate) if self._first_level > 1 else None
        self._per_frame = [1.0 / (sample_rate * memory) for memory in AVERAGING_TIMES]
        self._usual = [1.0 - math.exp(-share) for share in self._per_frame]
        self.reset()

    def reset(self) -> None:
        """Reset all state; the next frame settles the filters."""
        self._low_pass.reset()
        self._fresh = True
        self._all_seen = True  # whether every change so far counts
        self._last = [0.0] * self._parts
        self._unseen = [0.0] * self._parts
        self._slow = [0.0] * LEVELS
        if self._earlier is not None:
            self._earlier.reset()

    def step(self, products: list[float], bad: bool, was_bad: bool, periods: float, sample_rate: float) -> float:
        """Return the rate in FS/s after the projections of a frame, `periods` sample periods after the last.

        The projections of a `bad` frame do not count; `was_bad`: the frame before was bad.
        """
        last, slow = self._last, self._slow
        moved = 0.0
        if not bad:
            if was_bad:
                self._all_seen = False
                for part in range(self._parts):
                    self._unseen[part] += products[part] - last[part]
            elif not self._fresh:
                moved = products[0] - last[0]
            self._last = last = products
        seen = last if self._all_seen else [now - lost for now, lost in zip(last, self._unseen, strict=True)]
        if self._earlier is not None:
            moved += self._earlier.step(seen, periods)
        levels = 0.0
        for i, usual in enumerate(self._usual):
            level = seen[self._first_level + i]
            if self._fresh:
                slow[i] = level
            share = usual if periods == 1.0 else 1.0 - math.exp(-periods * self._per_frame[i])
            slow[i] += share * (level - slow[i])
            levels += level - slow[i]
        self._fresh = False
        return self._low_pass.step(moved * sample_rate / periods + levels)


class EarlierMovement:
    """How far the earlier projections of one gesture moved in the time step that lies RATE_LAGS before the newest.

    Keeps a ring of projections. Between two frames a projection counts as moving evenly, so that the lags need be no
    whole number of sample periods and frames may be missing. Before the first frame nothing moves.
    """

    def __init__(self, sample_rate: float) -> None:
        self._lags = [round(lag * sample_rate, 6) for lag in RATE_LAGS[1:]]  # sample periods
        self._whole = [int(lag) for lag in self._lags]
        self._part = [lag - int(lag) for lag in self._lags]
        self._is_even = not any(self._part)
        self._size = self._whole[-1] + 2
        self.reset()

    def reset(self) -> None:
        """Forget all projections."""
        self._ring: list[list[float]] = []
        self._times: list[float] = []  # sample periods
        self._newest = 0
        self._even = 0  # frames since one was missing
        self._sum = 0.0

    def step(self, seen: list[float], periods: float) -> float:
        """Return the movement in FS; `seen` are the projections of a frame, `periods` after the frame before it."""
        if not self._ring:
            self._ring = [seen] * self._size
            self._times = [float(-age) for age in range(self._size, 0, -1)]
            self._even = self._size
            self._sum = sum(seen[1 : 1 + len(self._lags)])
            self._newest = self._size - 1
        before = self._times[self._newest]
        self._newest = newest = (self._newest + 1) % self._size
        self._ring[newest] = seen
        self._times[newest] = before + periods
        self._even = self._even + 1 if periods == 1.0 else 0
        total = self._even_sum() if self._even >= self._size else self._uneven_sum()
        moved = total - self._sum
        self._sum = total
        return moved

    def _even_sum(self) -> float:
        """Return the sum of the earlier projections, when no frame of the ring is missing."""
        ring, newest, size = self._ring, self._newest, self._size
        total = 0.0
        for i, whole in enumerate(self._whole):
            there = ring[(newest - whole) % size][1 + i]
            part = self._part[i]
            if part:
                there += part * (ring[(newest - whole - 1) % size][1 + i] - there)
            total += there
        return total

    def _uneven_sum(self) -> float:
        """Return the sum of the earlier projections, when a frame is missing: each is looked for by its time."""
        total = 0.0
        for i, lag in enumerate(self._lags):
            wanted = self._times[self._newest] - lag
            place, after = self._newest, self._newest
            for _ in range(self._size - 1):
                if self._times[place] <= wanted:
                    break
                after, place = place, (place - 1) % self._size
            there, span = self._ring[place][1 + i], self._times[after] - self._times[place]
            if span > 0.0 and self._times[place] < wanted:
                there += (wanted - self._times[place]) / span * (self._ring[after][1 + i] - there)
            total += there
        return total
