"""The instants at which a shirt makes frames whose sensors send at times of their own."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.clock import Clock
from app.messages import SensorFrame

LONGEST_HOLD_UP: Final = 1.0  # s: after a longer one, the frames meanwhile are lost, as those of a device are


class FrameGrid:
    """Counts the instants of the nominal rate, from now on, and the frames that were made at them.

    Attributes
    ----------
    lost : int
        Instants without a frame since the first frame.
    """

    __slots__ = ("_clock", "_first", "_next", "_number", "_rate", "_start", "lost")

    def __init__(self, clock: Clock, sample_rate: float) -> None:
        self.lost = 0
        self._clock = clock
        self._rate = sample_rate
        self._start = clock.now()
        self._number = 0  # of the next instant
        self._first = -1  # number of the first frame's instant, -1 before it
        self._next = 0  # seq of the frame that would follow the last one

    @property
    def due(self) -> float:
        """The next instant, monotonic s."""
        return self._start + self._number / self._rate

    def advance(self) -> float:
        """Go on to the instant after the next one, and return the one that has passed (monotonic s)."""
        behind = self._clock.now() - self.due
        if behind > LONGEST_HOLD_UP:
            self._number += int(behind * self._rate)
        passed = self.due
        self._number += 1
        return passed

    def frame(self, values: NDArray[np.float32]) -> SensorFrame:
        """Return the frame of the instant that has passed."""
        number = self._number - 1
        if self._first < 0:
            self._first = number
        seq = number - self._first
        self.lost += seq - self._next
        self._next = seq + 1
        return SensorFrame(seq & 0xFFFFFFFF, seq / self._rate, self._clock.now(), values)
