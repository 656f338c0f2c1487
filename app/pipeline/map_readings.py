"""The readings of all maps, frame by frame: one matrix product gives them and the state after the frame.

A map reads some projections of a frame and their past. All of that is linear, so that the usual frame costs one matrix
product for all gestures. Its input are the frame, earlier projections and the state; its output are the scores, the
readings and the new state. A frame after a gap takes a longer way to the same numbers.
"""

# Compiled in a wheel (hatch_build.py).

import math

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import AVERAGING_TIMES, KINDS, RATE_LAGS
from app.pipeline.projection import Projections
from app.signals.butterworth import Coefficients

Array = NDArray[np.float64]


class MapReadings:
    """The scores and the readings of g gestures: the rate (FS/s) of the gesture's map, or its smoothed score (FS).

    Keeps a ring with one row per frame: scores, readings, state, and the projections of which earlier values count.
    Kinds of projections that no gesture's map reads are left out. The state of a gesture is the sum of its moving
    projections, two numbers of the low-pass, and the averages from which its levels are counted.

    Parameters
    ----------
    read : Projections
        How the gestures read a frame.
    is_smoothed : list of bool
        Per gesture, whether its smoothed score is read in place of a rate.
    coefficients : Coefficients
        Of the low-pass.
    sample_rate : float
        Hz.
    """

    def __init__(
        self, read: Projections, is_smoothed: list[bool], coefficients: Coefficients, sample_rate: float
    ) -> None:
        self._read = read
        self._score, self._offset = read.score, read.offset
        self._is_smoothed = np.array(is_smoothed, dtype=np.bool_)
        self._centre = np.where(self._is_smoothed, read.offset, 0.0)
        self._filter, self._sample_rate = coefficients, sample_rate
        count, _, channels = read.parts.shape
        is_read = [bool(read.parts[:, kind].any()) for kind in range(KINDS)]
        earlier = [kind for kind in range(1, len(RATE_LAGS)) if is_read[kind]]
        levels = [kind for kind in range(len(RATE_LAGS), KINDS) if is_read[kind]]
        self._moving, self._earlier, self._levels = read.parts[:, 0], read.parts[:, earlier], read.parts[:, levels]
        # Sample periods, one per earlier projection: sorted by lag, then gesture.
        self._lags = np.repeat([round(RATE_LAGS[kind] * sample_rate, 6) for kind in earlier], count)
        self._size = int(self._lags[-1]) + 2 if earlier else 1
        between = bool((self._lags % 1.0).any())  # whether a lag lies between two frames
        self._taps = len(self._lags) * (2 if between else 1)
        self._per_frame = np.array(
            [1.0 / (sample_rate * AVERAGING_TIMES[kind - len(RATE_LAGS)]) for kind in levels]
        ).reshape(-1, 1)
        self._usual_share = 1.0 - np.exp(-self._per_frame)
        self._states = 3 + len(levels)  # of a gesture
        self._head = 2 * count
        self._state = slice(self._head, self._head + self._states * count)
        self._seen = slice(self._state.stop, self._state.stop + len(self._lags))
        self._usual = self._usual_matrix()
        self._input = np.zeros(self._usual.shape[1])
        self._input[channels] = 1.0  # what offsets are taken from
        self._frame, self._memory = self._input[:channels], self._input[channels + 1 :]
        self._ring = np.zeros((self._size, self._seen.stop))
        self._flat = self._ring.ravel()
        self._rows = list(self._ring)
        self._heads = [row[: self._head] for row in self._rows]
        self._places = list(self._memory_places())
        # The memory where no map reads earlier projections: faster to copy than to gather.
        self._only_state = self._rows[0][self._state] if self._size == 1 else None
        self.reset()

    def __deepcopy__(self, _memo: dict[int, object]) -> "MapReadings":
        """Return readings that go on by themselves: rows and memory are views, which a plain copy would part."""
        other = MapReadings(self._read, self._is_smoothed.tolist(), self._filter, self._sample_rate)
        other._ring[:], other._input[:], other._steps[:] = self._ring, self._input, self._steps
        other._newest, other._even = self._newest, self._even
        other.is_even, other._fresh = self.is_even, self._fresh
        return other

    def reset(self) -> None:
        """Reset all state; the next frame settles the filters."""
        self._fresh = True
        self._newest = 0
        self._even = 0  # frames since one was missing
        self.is_even = False
        """Whether a frame without a gap may take the short way, `step`."""
        self._steps = [1.0] * self._size  # sample periods from the row before to each row of the ring

    def step(self, frame: Array) -> list[float]:
        """Return scores and readings (2 g) after a usual frame (n_channels,), one period after the last.

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
        if self._only_state is not None:
            self._memory[:] = self._only_state
        else:
            self._flat.take(self._places[newest], None, self._memory, "clip")
        self._newest = newest
        self._steps[newest] = 1.0
        return values

    def step_slowly(self, frame: Array, periods: float) -> list[float]:
        """Return what `step` does after any frame, `periods` sample periods after the last."""
        clean = np.nan_to_num(frame, posinf=0.0, neginf=0.0)
        moving, seen, levels = self._moving @ clean - self._centre, self._earlier @ clean, (self._levels @ clean).T
        if self._fresh:
            self._settle(moving, seen, levels)
        state = self._ring[self._newest, self._state].reshape(self._states, -1)
        total, first, second, averages = state[0], state[1], state[2], state[3:]
        newest = (self._newest + 1) % self._size
        self._steps[newest] = periods
        share = self._usual_share if periods == 1.0 else 1.0 - np.exp(-periods * self._per_frame)
        new_total = moving + self._earlier_sum(seen, newest)
        new_averages = averages + share * (levels - averages)
        change = (new_total - total) * self._sample_rate / periods
        drive = np.where(self._is_smoothed, new_total, change + (levels - new_averages).sum(axis=0))
        c = self._filter
        reading = c.b0 * drive + first
        low_pass = (c.b1 * drive - c.a1 * reading + second, c.b2 * drive - c.a2 * reading)
        row = self._rows[newest]
        row[: self._head] = np.concatenate((self._score @ clean - self._offset, reading))
        row[self._state] = np.concatenate((new_total, *low_pass, *new_averages))
        row[self._seen] = seen.T.ravel()
        self._flat.take(self._places[newest], None, self._memory, "clip")
        self._frame[:] = clean
        self._newest, self._fresh = newest, False
        self._even = self._even + 1 if periods == 1.0 else 0
        self.is_even = self._size == 1 or self._even >= self._size
        values: list[float] = self._heads[newest].tolist()
        return values

    def _settle(self, moving: Array, seen: Array, levels: Array) -> None:
        """Let the past be as if these projections had been seen for ever."""
        c, total = self._filter, moving + seen.sum(axis=1)
        smoothed = np.where(self._is_smoothed, total, 0.0)
        low_pass = ((1.0 - c.b0) * smoothed, (c.b2 - c.a2) * smoothed)
        self._ring[:, self._state] = np.concatenate((total, *low_pass, *levels))
        self._ring[:, self._seen] = seen.T.ravel()
        self._even = self._size

    def _earlier_sum(self, seen: Array, newest: int) -> Array:
        """Return the sum (g,) of the earlier projections as they were RATE_LAGS ago, each found by its time."""
        if not len(self._lags):
            return np.zeros(len(seen))
        order = (newest - np.arange(self._size)) % self._size
        values = self._ring[order, self._seen]
        values[0] = seen.T.ravel()
        ages = np.concatenate(([0.0], np.cumsum(np.array(self._steps)[order[:-1]])))
        older = np.clip(np.searchsorted(ages, self._lags), 1, self._size - 1)
        share = np.clip((self._lags - ages[older - 1]) / (ages[older] - ages[older - 1]), 0.0, 1.0)
        columns = np.arange(len(self._lags))
        then = (1.0 - share) * values[older - 1, columns] + share * values[older, columns]
        total: Array = then.reshape(-1, len(seen)).sum(axis=0)
        return total

    def _usual_matrix(self) -> Array:
        """Return the matrix (row of the ring, input) of a usual frame."""
        count, channels = self._moving.shape
        near = channels + 1  # column of the first earlier projection, after its lag; those before the lag follow
        far, states = near + len(self._lags), near + self._taps
        size = states + self._states * count
        rows = np.zeros((self._seen.stop, size))
        rows[:count, :channels], rows[:count, channels] = self._score, -self._offset
        for gesture in range(count):
            total, first, second, *averages = (
                np.eye(1, size, states + state * count + gesture)[0] for state in range(self._states)
            )
            new_total = _row(self._moving[gesture], size)
            new_total[channels] = -self._centre[gesture]
            for lag, projection in enumerate(self._earlier[gesture]):
                column = lag * count + gesture
                whole = int(self._lags[column])
                part = self._lags[column] - whole
                seen = _row(projection, size)
                new_total += (1.0 - part) * (np.eye(1, size, near + column)[0] if whole else seen)
                if part:
                    new_total[far + column] = part
                rows[self._seen.start + column] = seen
            drive = self._sample_rate * (new_total - total)
            new_averages = []
            for projection, share, average in zip(self._levels[gesture], self._usual_share, averages, strict=True):
                level = _row(projection, size)
                new_averages.append(average + share * (level - average))
                drive += level - new_averages[-1]
            if self._is_smoothed[gesture]:
                drive = new_total
            c = self._filter
            reading = c.b0 * drive + first
            low_pass = (c.b1 * drive - c.a1 * reading + second, c.b2 * drive - c.a2 * reading)
            rows[count + gesture] = reading
            rows[self._head + gesture : self._state.stop : count] = (new_total, *low_pass, *new_averages)
        return rows

    def _memory_places(self) -> NDArray[np.int_]:
        """Return (rows of the ring, memory): where in the flat ring the next frame's memory lies, by the newest row."""
        width = self._seen.stop
        newest = np.arange(self._size)[:, np.newaxis]
        column = np.arange(len(self._lags))
        whole = self._lags.astype(np.int_)
        near = (newest + 1 - whole) % self._size * width + self._seen.start + column
        far = (newest - whole) % self._size * width + self._seen.start + column
        state = newest * width + np.arange(self._state.start, self._state.stop)
        return np.concatenate((np.concatenate((near, far), axis=1)[:, : self._taps], state), axis=1)


def _row(projection: Array, size: int) -> Array:
    """Return a row of the matrix that is a projection (n_channels,) of the frame."""
    row = np.zeros(size)
    row[: len(projection)] = projection
    return row
