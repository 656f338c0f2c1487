"""Joins samples of several streams into rows of all their channels. No device, no thread.

A row has the newest sample of each stream, never a value between two samples. All times are seconds of one clock.
"""

import math
from collections import deque
from collections.abc import Iterable, Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from app.messages import ALIVE, FRESH_PERIODS

ROUNDING = 1e-6  # s by which times that should be equal differ
PATIENCE = 0.03  # s for which a row waits for other streams: the chair takes a frame older than 0.05 s for none (S4)
FALL = 1e-3  # share of a sample's earliness by which even times follow it
LONGEST_LAG = 1.0  # s: rows of a grid that are later than this are left out; a step back in time begins anew
RESTART_AHEAD = 1 << 20  # samples: a larger gap is another clock, not a loss
MOST_WAITING = 4096  # samples of a stream, while rows come of no other


class Row(NamedTuple):
    """All channels at one time."""

    seq: int  # from 0; a gap is a loss
    t: float  # s
    values: NDArray[np.float32]  # (n_channels,)


class StreamSample(NamedTuple):
    """A sample of one stream."""

    t: float  # s, when it was measured
    values: Sequence[float]  # (n_channels of the stream,)
    arrived: float  # s


class StreamSamples:
    """The samples of one stream that no row has passed yet, and the newest sample before them."""

    def __init__(self, channels: int, rate: float, *, is_regular: bool) -> None:
        """`rate` (Hz) is the stream's own when it `is_regular`, otherwise the one that is expected of it."""
        self.period = 1.0 / rate
        self.is_regular = is_regular
        self.waiting: deque[StreamSample] = deque(maxlen=MOST_WAITING)
        self.newest = -math.inf  # s, the time of the newest sample
        self._arrived: float | None = None  # s, when the newest sample arrived
        self._held_t = -math.inf
        self._missing: Sequence[float] = [math.nan] * channels
        self._held: Sequence[float] = self._missing

    def add(self, sample: StreamSample) -> None:
        """Add the next sample; a time far behind the newest is another clock's, whose samples alone count."""
        if sample.t < self.newest - LONGEST_LAG:
            self.waiting.clear()
            self._held_t, self._held = -math.inf, self._missing
        self.newest, self._arrived = sample.t, sample.arrived
        self.waiting.append(sample)

    def at(self, t: float, ahead: float = 0.0) -> Sequence[float]:
        """Return the values of the newest sample up to `ahead` (s) after `t` (s); NaN when it is too old at `t`."""
        while self.waiting and self.waiting[0].t <= t + ahead + ROUNDING:
            self._held_t, self._held, _ = self.waiting.popleft()
        return self._missing if self._is_stale(t, self._held_t) else self._held

    def is_complete(self, t: float, ahead: float, now: float) -> bool:
        """Return whether no sample up to `ahead` (s) after `t` (s) is still to come at `now` (s).

        It is here, or the stream has brought nothing for `ALIVE`. How far its newest sample lies behind says nothing:
        some senders send many samples at once, and those of one stream come before those of the other.
        """
        is_here = self.newest + self.period > t + ahead + ROUNDING
        is_silent = self._arrived is not None and now - self._arrived > ALIVE
        return is_here or not self.is_regular or is_silent

    def _is_stale(self, t: float, newest: float) -> bool:
        return t - newest > FRESH_PERIODS * self.period + ROUNDING


class Rows(Protocol):
    """Makes rows of the samples of all streams.

    Attributes
    ----------
    lost : int
        Rows that never came.
    """

    lost: int

    def next(self, now: float) -> Row | None:
        """Return the next row at `now` (s), None while there is none."""
        ...

    def wait(self, now: float) -> tuple[int | None, float]:
        """Return whose next sample to wait for, and for how long (s); None: the next row comes without one."""
        ...


class EvenTimes:
    """The even times of a regular stream's samples, and how many are missing between two.

    A time step is rounded to whole periods, at least one (decision 3). Time stamps jitter, and some senders give one
    time to several samples: even times go on by a period at a sample that is early, and follow one that is late at
    once, so that they keep to the latest of the sender's times.
    """

    def __init__(self, period: float) -> None:
        self._period = period
        self.t = math.nan  # s, of the newest sample

    def step(self, t: float) -> int:
        """Take the time `t` (s) of the next sample; return how many periods later it is: more than 1 after a gap."""
        expected = self.t + self._period
        late = t - expected
        missing = round(late / self._period) if 0.0 < late < RESTART_AHEAD * self._period else 0
        if -LONGEST_LAG <= late <= 0.0:
            self.t = expected + FALL * late
        else:  # late, the first sample, or one of another clock
            self.t = t
        return 1 + missing


class LedRows:
    """Makes a row of each sample of one regular stream, the leader, with the newest samples of the others.

    Of another stream the sample counts that is at most half a period of the leader later: streams that are sampled
    together differ by less. A row waits at most PATIENCE for regular streams whose sample has not come yet.
    """

    def __init__(self, streams: Sequence[StreamSamples], leader: int) -> None:
        """`leader` is the index of the leading stream in `streams`."""
        self.lost = 0
        self._streams = streams
        self._leader = leader
        self._half = streams[leader].period / 2.0 - 2.0 * ROUNDING
        self._times = EvenTimes(streams[leader].period)
        self._seq = -1

    def next(self, now: float) -> Row | None:
        """Return the row of the leader's next sample at `now` (s), None while it has not come or waits."""
        leader = self._streams[self._leader]
        if not leader.waiting:
            return None
        sample = leader.waiting[0]
        if now < sample.arrived + PATIENCE - ROUNDING and self._awaited(sample, now) is not None:
            return None
        leader.waiting.popleft()
        steps = self._times.step(sample.t)
        self.lost += steps - 1
        self._seq += steps if self._seq >= 0 else 1
        parts = (
            sample.values if i == self._leader else stream.at(sample.t, self._half)
            for i, stream in enumerate(self._streams)
        )
        return Row(self._seq, self._times.t, _values(parts))

    def wait(self, now: float) -> tuple[int | None, float]:
        """Return whose next sample to wait for, and for how long (s)."""
        leader = self._streams[self._leader]
        if not leader.waiting:
            return self._leader, math.inf
        sample = leader.waiting[0]
        awaited = self._awaited(sample, now)
        return awaited, 0.0 if awaited is None else max(0.0, sample.arrived + PATIENCE - now)

    def _awaited(self, sample: StreamSample, now: float) -> int | None:
        """Return another stream that the row of a sample of the leader waits for at `now` (s), None when none."""
        for i, stream in enumerate(self._streams):
            if i != self._leader and not stream.is_complete(sample.t, self._half, now):
                return i
        return None


class GridRows:
    """Makes rows at an even rate of streams that have none: a grid that begins with the first sample.

    Without a single fresh sample there is no row: the streams are silent.
    """

    def __init__(self, streams: Sequence[StreamSamples], rate: float) -> None:
        """`rate` in Hz."""
        self.lost = 0
        self._streams = streams
        self._period = 1.0 / rate
        self._start = math.nan  # s
        self._seq = 0  # of the next row

    def next(self, now: float) -> Row | None:
        """Return the row of the next point of the grid that has passed at `now` (s), None while there is none."""
        if math.isnan(self._start):
            begun = [stream.waiting[0].arrived for stream in self._streams if stream.waiting]
            if not begun:
                return None
            self._start = min(begun)
        behind = int((now - self._due - LONGEST_LAG) / self._period)
        if behind > 0:
            self._seq += behind
            self.lost += behind
        while (t := self._due) <= now + ROUNDING:
            seq, self._seq = self._seq, self._seq + 1
            values = _values(stream.at(t) for stream in self._streams)
            if not np.isnan(values).all():
                return Row(seq, t, values)
            self.lost += 1
        return None

    def wait(self, now: float) -> tuple[int | None, float]:
        """Return None, and for how long (s) to wait for the next point of the grid."""
        return None, self._period if math.isnan(self._start) else max(0.0, self._due - now)

    @property
    def _due(self) -> float:
        return self._start + self._seq * self._period


def _values(parts: Iterable[Sequence[float]]) -> NDArray[np.float32]:
    with np.errstate(over="ignore"):  # too large for a float32: infinite, which the gate judges
        return np.array([value for part in parts for value in part], dtype=np.float32)
