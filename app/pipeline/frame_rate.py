"""Whether a shirt sends as many frames a second as the chain counts on."""

# Compiled in a wheel (hatch_build.py).

import math
from typing import Final

# Of the rate: a chain whose rate is wrong by less takes a movement for one a quarter faster or slower.
TOLERANCE: Final = 0.25
DEVICE_WINDOW: Final = 0.5  # s by the shirt's own clock
ARRIVAL_WINDOW: Final = 2.0  # s by our clock: frames come in bursts, and later than they were sent


class _Window:
    """Frames counted over one window after the other, by the shirt's own counter: lost frames count as well."""

    __slots__ = ("_begin", "_rate", "_seq", "_size", "differs")

    def __init__(self, rate: float, size: float) -> None:
        self._rate, self._size = rate, size
        self._seq, self._begin = 0, math.nan
        self.differs = False

    def step(self, seq: int, t: float) -> None:
        """Count the frame `seq` of the time `t` (s)."""
        passed = t - self._begin
        if 0.0 <= passed < self._size:
            return
        count = seq - self._seq
        # Otherwise: the first frame, a pause, or the shirt began anew.
        if self._size <= passed < 2.0 * self._size and count > 0:
            self.differs = abs(count / passed - self._rate) > TOLERANCE * self._rate
        self._seq, self._begin = seq, t


class FrameRate:
    """Compares the rate of the frames with that of the chain, by the shirt's clock and by ours."""

    def __init__(self, sample_rate: float) -> None:
        self._sample_rate = sample_rate
        self.reset()

    def reset(self) -> None:
        """Begin to count anew."""
        self._device = _Window(self._sample_rate, DEVICE_WINDOW)
        self._arrival = _Window(self._sample_rate, ARRIVAL_WINDOW)
        self.differs = False
        """Whether the last count was another rate."""

    def step(self, seq: int, t_device: float, t: float) -> None:
        """Count a frame with its number, by the shirt's clock and by ours (s)."""
        self._device.step(seq, t_device)
        self._arrival.step(seq, t)
        self.differs = self._device.differs or self._arrival.differs
