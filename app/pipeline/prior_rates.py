"""The rates of all maps from other people, frame by frame: one matrix product gives them and the state after the frame.

A map reads 7 projections of a frame and their past. All of that is linear, so that the usual frame costs one matrix
product for all gestures. Its input are the frame, earlier projections and the state; its output are the rates and the
new state. Frames after a gap take a longer way to the same numbers.
"""

import math

import numpy as np
from numpy.typing import NDArray

from app.butterworth import Coefficients
from app.calibration.profile import AVERAGING_TIMES, RATE_LAGS

EARLIER = len(RATE_LAGS) - 1  # projections of a gesture of which earlier values count
SHORT, LONG = EARLIER + 1, EARLIER + 2  # the projections whose level counts
STATES = 5  # of a gesture: sum of its moving projections, two slow averages, two numbers of the low-pass

Array = NDArray[np.float64]


class PriorRates:
    """The rates of g gestures.

    Keeps a ring with one row per frame: the products of other weights, the rates, the state, the earlier projections.

    Parameters
    ----------
    others : (n, n_channels) array
        Weights of other projections, which are computed along with the rates.
    parts : (g, 7, n_channels) array
        The parts of each gesture's map, FS and FS/s per signal unit.
    coefficients : Coefficients
        Of the low-pass.
    sample_rate : float
        Hz.
    """

    def __init__(self, others: Array, parts: Array, coefficients: Coefficients, sample_rate: float) -> None:
        self._others, self._parts = others, parts
        self._filter, self._sample_rate = coefficients, sample_rate
        count, _, channels = parts.shape
        lags = [round(lag * sample_rate, 6) for lag in RATE_LAGS[1:]]
        self._lags = np.repeat(lags, count)  # sample periods, one per earlier projection: sorted by lag, then gesture
        self._size = int(lags[-1]) + 2
        between = any(lag % 1.0 for lag in lags)  # whether a lag lies between two frames
        self._taps = EARLIER * count * (2 if between else 1)
        self._per_frame = np.array([1.0 / (sample_rate * memory) for memory in AVERAGING_TIMES])
        self._usual_share = 1.0 - np.exp(-self._per_frame)
        self._head = len(others) + count
        self._state = slice(self._head, self._head + STATES * count)
        self._earlier = slice(self._state.stop, self._state.stop + EARLIER * count)
        self._usual = self._usual_matrix()
        self._input = np.zeros(self._usual.shape[1])
        self._frame, self._memory = self._input[:channels], self._input[channels:]
        self._ring = np.zeros((self._size, self._earlier.stop))
        self._flat = self._ring.ravel()
        self._rows = list(self._ring)
        self._heads = [row[: self._head] for row in self._rows]
        self._places = list(self._memory_places())
        self.reset()

    def reset(self) -> None:
        """Reset all state; the next frame settles the filters."""
        self._fresh = True
        self._newest = 0
        self._even = 0  # frames since one was missing
        self.is_even = False
        """Whether a frame without a gap may take the short way, `step`."""
        self._steps = [1.0] * self._size  # sample periods from the row before to each row of the ring

    def step(self, frame: Array) -> list[float]:
        """Return the other products and the rates (FS/s) after a usual frame (n_channels,), one period after the last.

        Usual is every frame when `is_even`.
        """
        self._frame[:] = frame
        newest = self._newest + 1
        if newest == self._size:
            newest = 0
        row = self._rows[newest]
        self._usual.dot(self._input, row)
        values: list[float] = self._heads[newest].tolist()
        if not math.isfinite(sum(values)):  # a channel that no gesture reads is NaN or infinite
            self._frame[:] = np.nan_to_num(frame, posinf=0.0, neginf=0.0)
            self._usual.dot(self._input, row)
            values = self._heads[newest].tolist()
        self._flat.take(self._places[newest], None, self._memory, "clip")
        self._newest = newest
        self._steps[newest] = 1.0
        return values

    def step_slowly(self, frame: Array, periods: float) -> list[float]:
        """Return what `step` does after any frame, `periods` sample periods after the last."""
        clean = np.nan_to_num(frame, posinf=0.0, neginf=0.0)
        count = len(self._parts)
        seen = self._parts @ clean
        if self._fresh:
            self._settle(seen)
        total, short, long, first, second = self._ring[self._newest, self._state].reshape(STATES, count)
        newest = (self._newest + 1) % self._size
        self._steps[newest] = periods
        share = self._usual_share if periods == 1.0 else 1.0 - np.exp(-periods * self._per_frame)
        moved = seen[:, 0] + self._earlier_sum(seen, newest) - total
        averages = np.stack((short + share[0] * (seen[:, SHORT] - short), long + share[1] * (seen[:, LONG] - long)))
        drive = moved * self._sample_rate / periods + (seen[:, SHORT] - averages[0]) + (seen[:, LONG] - averages[1])
        c = self._filter
        rate = c.b0 * drive + first
        state = (total + moved, *averages, c.b1 * drive - c.a1 * rate + second, c.b2 * drive - c.a2 * rate)
        row = self._rows[newest]
        row[: len(self._others)] = self._others @ clean
        row[len(self._others) : self._head] = rate
        row[self._state] = np.concatenate(state)
        row[self._earlier] = seen[:, 1 : EARLIER + 1].T.ravel()
        self._flat.take(self._places[newest], None, self._memory, "clip")
        self._frame[:] = clean
        self._newest, self._fresh = newest, False
        self._even = self._even + 1 if periods == 1.0 else 0
        self.is_even = self._even >= self._size
        values: list[float] = self._heads[newest].tolist()
        return values

    def _settle(self, seen: Array) -> None:
        """Let the past be as if these projections (g, 7) had been seen for ever."""
        zero = np.zeros(len(seen))
        past = (seen[:, : EARLIER + 1].sum(axis=1), seen[:, SHORT], seen[:, LONG], zero, zero)
        self._ring[:, self._state] = np.concatenate(past)
        self._ring[:, self._earlier] = seen[:, 1 : EARLIER + 1].T.ravel()
        self._even = self._size

    def _earlier_sum(self, seen: Array, newest: int) -> Array:
        """Return the sum (g,) of the projections as they were RATE_LAGS ago, each found by its time."""
        order = (newest - np.arange(self._size)) % self._size
        values = self._ring[order, self._earlier]
        values[0] = seen[:, 1 : EARLIER + 1].T.ravel()
        ages = np.concatenate(([0.0], np.cumsum(np.array(self._steps)[order[:-1]])))
        older = np.clip(np.searchsorted(ages, self._lags), 1, self._size - 1)
        share = np.clip((self._lags - ages[older - 1]) / (ages[older] - ages[older - 1]), 0.0, 1.0)
        columns = np.arange(len(self._lags))
        then = (1.0 - share) * values[older - 1, columns] + share * values[older, columns]
        total: Array = then.reshape(EARLIER, -1).sum(axis=0)
        return total

    def _usual_matrix(self) -> Array:
        """Return the matrix (row of the ring, input) of a usual frame."""
        count, _, channels = self._parts.shape
        near, far = channels, channels + EARLIER * count  # columns of the projections after and before the lag
        states = channels + self._taps
        size = states + STATES * count
        rows = np.zeros((self._earlier.stop, size))
        rows[: len(self._others), :channels] = self._others
        for gesture, parts in enumerate(self._parts):
            seen = np.zeros((len(parts), size))
            seen[:, :channels] = parts
            total, short, long, first, second = (
                np.eye(1, size, states + state * count + gesture)[0] for state in range(STATES)
            )
            new_total = seen[0].copy()
            for lag in range(EARLIER):
                column = lag * count + gesture
                whole = int(self._lags[column])
                part = self._lags[column] - whole
                new_total += (1.0 - part) * (np.eye(1, size, near + column)[0] if whole else seen[1 + lag])
                if part:
                    new_total[far + column] = part
                rows[self._earlier.start + column] = seen[1 + lag]
            new_short = short + self._usual_share[0] * (seen[SHORT] - short)
            new_long = long + self._usual_share[1] * (seen[LONG] - long)
            drive = self._sample_rate * (new_total - total) + (seen[SHORT] - new_short) + (seen[LONG] - new_long)
            c = self._filter
            rate = c.b0 * drive + first
            rows[len(self._others) + gesture] = rate
            state = (new_total, new_short, new_long, c.b1 * drive - c.a1 * rate + second, c.b2 * drive - c.a2 * rate)
            rows[self._head + gesture : self._state.stop : count] = state
        return rows

    def _memory_places(self) -> NDArray[np.int_]:
        """Return (rows of the ring, memory): where in the flat ring the next frame's memory lies, by the newest row."""
        count, width = len(self._parts), self._earlier.stop
        newest = np.arange(self._size)[:, np.newaxis]
        column = np.arange(EARLIER * count)
        whole = self._lags.astype(np.int_)
        near = (newest + 1 - whole) % self._size * width + self._earlier.start + column
        far = (newest - whole) % self._size * width + self._earlier.start + column
        state = newest * width + np.arange(self._state.start, self._state.stop)
        return np.concatenate((np.concatenate((near, far), axis=1)[:, : self._taps], state), axis=1)
