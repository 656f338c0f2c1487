"""From the newest orientation of each sensor to frames of rotation vectors (docs/orientation.md)."""

import math
from collections import deque
from collections.abc import Collection, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.hardware.shirt.orientation_sensors.body_parts import PARTS, channel_names, reference_of
from app.hardware.shirt.orientation_sensors.orientation import (
    Rotations,
    angle_between,
    drift_rate,
    inverse,
    logarithm,
    mean_orientation,
    nearest_vector,
    product,
)
from app.messages import FRESH_PERIODS

REST_TIME: Final = 1.0  # s in which a sensor has to be still before its posture counts as "at rest, arms down"
REST_ANGLE: Final = math.radians(5)  # by which it may move meanwhile: breathing and a small tremor
REST_PATIENCE: Final = 10.0  # s after which the newest second counts: somebody with a large tremor is never still
DRIFT_STEP: Final = 0.5  # s between two samples of an orientation
DRIFT_TIME: Final = 10.0  # s: longer than a movement
DRIFT_LIMIT: Final = math.radians(2)  # rad/s beyond which a page says that a sensor drifts


class OrientationFrames:
    """Keeps the newest samples of the sensors on a body, and makes frames of them.

    A sensor's first second of stillness is its posture at rest, from which its rotation vector is measured. Until
    then, and without a sample or a sign of it or of its reference within `FRESH_PERIODS`, its channels are NaN.
    """

    def __init__(
        self, parts: Collection[str], bends: Collection[str], sample_rate: float, from_neighbour: bool
    ) -> None:
        """Take the parts of the body (names of PARTS) that wear a sensor; those in `bends` wear a strain sensor.

        `sample_rate` is that of the frames, in Hz; `from_neighbour` is that of `reference_of`.
        """
        self._period = 1.0 / sample_rate
        self._turned = [part for part in PARTS if part in parts and part not in bends]
        self._bent = [part for part in PARTS if part in bends]
        count = len(self._turned)
        references = [reference_of(part, self._turned, from_neighbour) for part in self._turned]
        # The last row is the room, for sensors without a reference.
        self._reference = [count if part is None else self._turned.index(part) for part in references]
        self._orientation = np.full((count + 1, 4), np.nan)
        self._orientation[count] = (0.0, 0.0, 0.0, 1.0)
        self._turned_t = np.full(count, -math.inf)  # monotonic s
        self._first_t = np.full(count, math.inf)  # since when a sensor sends
        self._rest = np.full((count, 4), np.nan)  # relative orientation at rest
        self._vector = np.zeros((count, 3))  # newest rotation vector, rad
        self._recent: deque[Rotations] = deque(maxlen=max(2, round(REST_TIME * sample_rate)))
        self._bend = np.full(len(self._bent), np.nan)
        self._bent_t = np.full(len(self._bent), -math.inf)
        self._frames = 0
        self._drift_every = round(DRIFT_STEP * sample_rate)  # frames
        self._drift_samples: deque[Rotations] = deque(maxlen=round(DRIFT_TIME / DRIFT_STEP) + 1)
        self._drift = np.full(count, np.nan)  # rad/s
        self._is_signal = np.array([PARTS[part].joint is not None for part in self._turned], dtype=np.bool_)
        names = [name for part in PARTS if part in parts for name in channel_names(part, bends)]
        signals = [part for part in self._turned if PARTS[part].joint is not None]
        self._vector_places = [names.index(name) for part in signals for name in channel_names(part, bends)]
        self._bend_places = [names.index(name) for part in self._bent for name in channel_names(part, bends)]
        self._count = len(names)

    def take_orientation(self, part: str, orientation: Rotations, t: float) -> None:
        """Take a sample (4,) of a sensor, which came at `t` (monotonic s)."""
        i = self._turned.index(part)
        self._orientation[i], self._turned_t[i] = orientation, t
        self._first_t[i] = min(self._first_t[i], t)

    def take_sign(self, part: str, t: float) -> bool:
        """Take a sign at `t` (monotonic s) that a sensor works: its orientation has not changed since the last one.

        Returns whether the sign counts: after a longer silence than a sample counts for, orientations may be lost.
        """
        i = self._turned.index(part)
        counts = bool(self._turned_t[i] >= self._oldest(t))
        if counts:
            self._turned_t[i] = t
        return counts

    def take_bend(self, part: str, value: float, t: float) -> None:
        """Take a sample of a strain sensor, in its own unit, which came at `t` (monotonic s)."""
        i = self._bent.index(part)
        self._bend[i], self._bent_t[i] = value, t

    def forget(self, part: str) -> None:
        """Forget the posture at rest of a sensor that was started again, and of those that are measured from it."""
        if part not in self._turned:
            return
        i = self._turned.index(part)
        self._turned_t[i], self._first_t[i] = -math.inf, math.inf
        measured = [j for j, reference in enumerate(self._reference) if i in (j, reference)]
        self._rest[measured] = np.nan
        for relative in self._recent:
            relative[measured] = np.nan
        for orientation in self._drift_samples:
            orientation[i] = np.nan
        self._drift[i] = np.nan

    def frame(self, t: float) -> NDArray[np.float32] | None:
        """Return the frame (n_channels,) at `t` (monotonic s), None when no channel has a value.

        To be called once a period: the samples of the last frames show who is still.
        """
        limit = self._oldest(t)
        orientation = self._orientation.copy()
        orientation[:-1][self._turned_t < limit] = np.nan
        relative = product(inverse(orientation[self._reference]), orientation[:-1])
        self._find_rest(relative, t)
        self._measure_drift(orientation[:-1])
        vector = nearest_vector(logarithm(product(inverse(self._rest), relative)), self._vector)
        is_known = np.isfinite(vector[:, 0])
        self._vector[is_known] = vector[is_known]
        values = np.full(self._count, np.nan, dtype=np.float32)
        values[self._vector_places] = vector[self._is_signal].ravel()
        values[self._bend_places] = np.where(self._bent_t < limit, np.nan, self._bend)
        return values if np.isfinite(values).any() else None

    def silent(self, t: float) -> list[str]:
        """Return the parts whose sensors have sent nothing that counts at `t` (monotonic s)."""
        limit = self._oldest(t)
        turned = zip(self._turned, self._turned_t, strict=True)
        bent = zip(self._bent, self._bent_t, strict=True)
        return [part for part, newest in (*turned, *bent) if newest < limit]

    @property
    def moving(self) -> list[str]:
        """The parts whose sensors send, but whose posture at rest is not known yet."""
        unknown = self._is_signal & np.isnan(self._rest[:, 0]) & np.isfinite(self._first_t)
        return self._names(unknown)

    @property
    def drifting(self) -> list[str]:
        """The parts whose sensors drift by more than DRIFT_LIMIT."""
        return self._names(self._drift > DRIFT_LIMIT)

    def _oldest(self, t: float) -> float:
        """Return when (monotonic s) the oldest sample came that counts at `t`; rounding makes none too old."""
        return t - (FRESH_PERIODS + 1e-6) * self._period

    def _names(self, which: NDArray[np.bool_]) -> list[str]:
        return [part for part, is_one in zip(self._turned, which, strict=True) if is_one]

    def _find_rest(self, relative: Rotations, t: float) -> None:
        """Take the mean of the last second as the posture at rest of each sensor that has none and was still."""
        self._recent.append(relative)
        unknown: Sequence[int] = np.flatnonzero(self._is_signal & np.isnan(self._rest[:, 0])).tolist()
        if not unknown or len(self._recent) < (self._recent.maxlen or 0):
            return
        recent = np.stack(self._recent)
        for i in unknown:
            postures = recent[:, i]
            if np.isnan(postures).any():
                continue
            mean = mean_orientation(postures)
            is_still = angle_between(mean, postures).max() < REST_ANGLE
            if is_still or t - self._first_t[i] > REST_PATIENCE:
                self._rest[i], self._vector[i] = mean, 0.0

    def _measure_drift(self, orientation: Rotations) -> None:
        self._frames += 1
        if self._frames % self._drift_every:
            return
        samples = self._drift_samples
        samples.append(orientation)
        if len(samples) == samples.maxlen:
            course = np.stack(samples)
            for i in range(course.shape[1]):
                has_all = bool(np.isfinite(course[:, i]).all())
                self._drift[i] = drift_rate(course[:, i], self._drift_every * self._period) if has_all else np.nan
