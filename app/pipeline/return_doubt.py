"""Doubt about channels that returned: the part of their change that was perhaps a movement, and perhaps none.

That part is removed from the signal (`channel_substitution.py`), as if it was no movement. If it was one, a map that
reads levels would see the way back from it as a movement of its own. So a gesture is activated only as far as both
readings agree: the doubt, which is added to its rate before the dead-zone, is what the change would take away from its
levels if it was a movement. The doubt fades as the averages do from which levels are counted.
"""

# Compiled in a wheel (hatch_build.py).

from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import AVERAGING_TIMES, RATE_LAGS
from app.calibration.vocabulary import DriveParameters
from app.pipeline.projection import projections

BASELINE_TIME: Final = 30.0  # s: time constant of the baseline of a displacement gesture
LEAST: Final = 1e-9  # FS/s or FS: smaller doubts are none
LARGEST: Final = 0.5  # of a gesture's range: with more, not even a full movement reaches half, which a stop needs

Array = NDArray[np.float64]


class ReturnDoubt:
    """How much less each gesture reads, so that no reading of a return activates it; 0 or below."""

    def __init__(self, parameters: DriveParameters, sample_rate: float) -> None:
        read = projections(parameters)
        levels: list[Array] = []
        self._owners: list[int] = []
        self._times: list[float] = []
        for gesture, chosen in enumerate(parameters.gestures):
            averages = read.parts[gesture, len(RATE_LAGS) :]
            if chosen.feature == "displacement":
                levels.append(read.score[gesture])
                self._owners.append(gesture)
                self._times.append(BASELINE_TIME)
            elif averages.any():
                levels.extend(averages)
                self._owners.extend([gesture] * len(AVERAGING_TIMES))
                self._times.extend(AVERAGING_TIMES)
        self._rows = np.array(levels).reshape(len(levels), read.score.shape[1])
        self._per_frame = -1.0 / (sample_rate * np.array(self._times))
        self._is_displacement = np.array([time == BASELINE_TIME for time in self._times], dtype=np.bool_)
        self._count = len(read.score)
        self.largest = [-LARGEST * (gesture.full - gesture.dead_zone) for gesture in parameters.gestures]
        """The doubt of each gesture below which it counts as bad, FS/s or FS."""
        self.reset()

    def reset(self) -> None:
        """Forget all doubts."""
        self._amount = np.zeros(len(self._times))
        self.exists = False

    def add(self, step: Array) -> None:
        """Doubt the step (n_channels,) of channels that returned, in signal units."""
        self._amount = self._amount + np.minimum(self._rows @ step, 0.0)
        self.exists = bool((self._amount < -LEAST).any())

    def fade(self, periods: float, was_quiet: bool) -> None:
        """Let `periods` sample periods pass; the baseline of a displacement moves only when it `was_quiet`."""
        share = np.exp(periods * self._per_frame)
        if not was_quiet:
            share[self._is_displacement] = 1.0
        self._amount = self._amount * share
        self.exists = bool((self._amount < -LEAST).any())

    def over(self, periods: Array) -> Array:
        """Return the doubt of each gesture (n + 1, n_gestures) now and after each of the next n `periods`."""
        time = np.concatenate(([0.0], np.cumsum(periods)))
        fading = self._amount * np.exp(time[:, np.newaxis] * self._per_frame)
        totals = np.zeros((len(time), self._count))
        for column, owner in enumerate(self._owners):
            totals[:, owner] += fading[:, column]
        return totals

    def of_gestures(self) -> list[float]:
        """Return the doubt of each gesture, FS/s, or FS for a displacement."""
        totals = [0.0] * self._count
        for owner, amount in zip(self._owners, self._amount.tolist(), strict=True):
            totals[owner] += amount
        return totals

    def are_too_large(self) -> list[bool]:
        """Return for each gesture whether its doubt is so large that it counts as bad."""
        return [doubt < largest for doubt, largest in zip(self.of_gestures(), self.largest, strict=True)]
