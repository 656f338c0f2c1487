"""What arrives at a shirt and counts, what is left out and why, and at which rate frames come; no device, no clock."""

import math
from typing import Final, NamedTuple

from app.arrivals import ArrivalVerdict
from app.hardware.shirt.sender_choice import Address
from app.messages import ALIVE
from app.texts import Text

PATIENCE: Final = 3.0  # s of silence after which the newest thing that was left out says why
RATE_TIME: Final = 5.0  # s over which a rate is measured: longer than the bursts in which a computer hands frames on
RATE_ERROR: Final = 0.1  # share: the clocks of boards and the bursts of computers are wrong by less
GOOD: Final = Text("arrivals-good")
WAITING: Final = Text("arrivals-waiting")


class LeftOut(NamedTuple):
    """Something that arrived and does not count."""

    t: float  # monotonic s
    reason: ArrivalVerdict
    size: int = 0  # bytes
    sender: Address | None = None  # None: it came by no network


class ArrivalWatch:
    """Watches what arrives at a shirt.

    Attributes
    ----------
    accepted : int
        Frames, or samples, that count.
    accepted_t : float
        When the newest of them came, monotonic s.
    left_out : int
        Packets, messages or pieces of a stream that do not count.
    newest : LeftOut
        The newest of these.
    """

    __slots__ = ("_opened_t", "accepted", "accepted_t", "left_out", "newest")

    def __init__(self, opened_t: float = -math.inf) -> None:
        """`opened_t` is when the shirt was opened, monotonic s."""
        self.accepted = self.left_out = 0
        self.accepted_t = -math.inf
        self.newest = LeftOut(-math.inf, "nothing")
        self._opened_t = opened_t

    def accept(self, t: float, count: int = 1) -> None:
        """Count frames or samples that came at `t` (monotonic s)."""
        self.accepted += count
        self.accepted_t = t

    def leave_out(self, newest: LeftOut, count: int = 1) -> None:
        """Count what does not count as a frame."""
        self.left_out += count
        self.newest = newest

    def verdict(self, t: float) -> ArrivalVerdict:
        """Return the verdict at `t` (monotonic s): "arrives" while frames come, and why none comes after PATIENCE."""
        reason = self.newest.reason if t - self.newest.t < PATIENCE else "nothing"
        if t - self.accepted_t <= ALIVE:
            return "senders" if reason == "senders" else "arrives"
        return "waiting" if t - max(self.accepted_t, self._opened_t) < PATIENCE else reason


class RateMeter:
    """Measures how many frames a second a device makes, by the numbers and the times of frames.

    Attributes
    ----------
    rate : float
        Frames per second (Hz) over the last RATE_TIME, NaN before that.
    newest_t : float
        When the newest frame came, s.
    """

    __slots__ = ("_expected", "_seq", "_t", "newest_t", "rate")

    def __init__(self, expected: float) -> None:
        """`expected` is the rate that is set, Hz."""
        self.rate = math.nan
        self._expected = expected
        self._seq = 0  # of the frame with which the measurement began
        self._t = self.newest_t = -math.inf  # s, of that frame and of the newest one

    @property
    def is_wrong(self) -> bool:
        """Whether the rate is another one than expected."""
        return abs(self.rate / self._expected - 1.0) > RATE_ERROR

    @property
    def is_low(self) -> bool:
        """Whether the rate is lower than expected."""
        return self.rate / self._expected < 1.0 - RATE_ERROR

    def add(self, seq: int, t: float) -> None:
        """Take the number of a frame and its time (s of any one clock); a gap or a step back begins anew."""
        if not 0.0 <= t - self.newest_t <= ALIVE or seq < self._seq:
            self._seq, self._t = seq, t
        self.newest_t = t
        if t - self._t >= RATE_TIME:
            self.rate = (seq - self._seq) / (t - self._t)
            self._seq, self._t = seq, t
