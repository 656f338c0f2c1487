"""A page that is the camera, as far as its driver sees it: samples with the times of a clock of its own."""

import numpy as np
from fake_clock import FakeClock
from numpy.typing import NDArray

from app.hardware.shirt.camera import HEADER, VERSION, CameraShirt

CHANNELS = 19


def message_of(seq: int, picture_t: float, sent_t: float, values: NDArray[np.float32]) -> bytes:
    """Return the bytes of a sample."""
    return HEADER.pack(VERSION, 0, len(values), seq, picture_t, sent_t) + values.astype("<f4").tobytes()


class CameraPage:
    """Sends samples whose first channel holds their number, so that every loss shows.

    Attributes
    ----------
    ahead : float
        By how much (s) the clock of the page is ahead of ours.
    drift : float
        By how much (s per s) it is too fast.
    reading : float
        For how long (s) the page reads a picture.
    """

    def __init__(self, shirt: CameraShirt, clock: FakeClock, number: int = 1) -> None:
        self.ahead, self.drift, self.reading = 1000.0, 0.0, 0.02
        self.seq = 0
        self._shirt, self._clock, self._number = shirt, clock, number
        self._begun = clock.now()

    def values(self) -> NDArray[np.float32]:
        """Return the values of the next sample."""
        return np.full(CHANNELS, self.seq % 1000 / 1000, np.float32)

    def now(self) -> float:
        """Return the time (s) of the page's own clock."""
        return self.ahead + (self._clock.now() - self._begun) * (1 + self.drift)

    def message(self, values: NDArray[np.float32] | None = None) -> bytes:
        """Return the next sample, of a picture that the page has just read."""
        values, seq, now = self.values() if values is None else values, self.seq, self.now()
        self.seq += 1
        return message_of(seq, now - self.reading, now, values)

    def send(self, values: NDArray[np.float32] | None = None, *, underway: float = 0.0) -> None:
        """Send the next sample, which was `underway` for so long (s) when it arrives now."""
        now = self._clock.time
        self._clock.time = now - underway
        message = self.message(values)
        self._clock.time = now
        self.deliver(message)

    def deliver(self, message: bytes) -> None:
        """Let any bytes arrive now."""
        self._shirt.add_sample(self._number, message, self._clock.now())
