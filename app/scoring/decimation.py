"""Long columns made short for the screen: taken at an even rate, or so that no peak is lost."""

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.intp]
Numbers = NDArray[np.float64]


class Decimation:
    """Short columns of one length out of long ones.

    The rows are dealt into buckets of one size, and each bucket gives two points. A column that is taken gives its
    rows at a quarter and at three quarters of the bucket, a column of which no peak may be lost its smallest and its
    largest value in the order in which they came. A column that is short enough stays as it is.

    Attributes
    ----------
    rows : ndarray of int (n_points,)
        The rows that are taken; their times are the times of all points.
    """

    def __init__(self, n_rows: int, most: int) -> None:
        """Plan for columns of `n_rows` rows and at most `most` points (an even number of at least 2)."""
        self._size = 1
        if n_rows > most:
            self._size = -(-2 * n_rows // most)  # rows in a bucket, rounded up
        starts = np.arange(0, n_rows, self._size)
        if self._size == 1:
            self.rows: Rows = starts
        else:
            ends = np.minimum(starts + self._size, n_rows)
            quarters = np.stack([starts + (ends - starts) // 4, starts + 3 * (ends - starts) // 4], axis=1)
            self.rows = quarters.reshape(-1)
        self._n_rows = n_rows

    def sampled(self, column: NDArray[np.generic]) -> NDArray[np.generic]:
        """Return the column (n_rows,) at an even rate (n_points,)."""
        return column[self.rows]

    def peaks(self, column: NDArray[np.floating]) -> Numbers:
        """Return the column (n_rows,) with its smallest and largest values (n_points,); NaN only where all are NaN."""
        if self._size == 1:
            return np.asarray(column, dtype=np.float64)
        buckets = -(-self._n_rows // self._size)
        padded = np.empty(buckets * self._size)
        padded[: self._n_rows] = column
        padded[self._n_rows :] = column[-1]
        grid = padded.reshape(buckets, self._size)
        unknown = np.isnan(grid)
        some = bool(unknown.any())
        lowest = (np.where(unknown, np.inf, grid) if some else grid).argmin(axis=1)
        highest = (np.where(unknown, -np.inf, grid) if some else grid).argmax(axis=1)
        order = np.stack([np.minimum(lowest, highest), np.maximum(lowest, highest)], axis=1)
        # A bucket in which nothing is known has NaN at every place.
        return np.take_along_axis(grid, order, axis=1).reshape(-1)

    def any(self, column: NDArray[np.generic]) -> NDArray[np.bool_]:
        """Return where the column (n_rows,) is true anywhere in the bucket (n_points,)."""
        if self._size == 1:
            return column.astype(np.bool_)
        starts = np.arange(0, self._n_rows, self._size)
        return np.repeat(np.logical_or.reduceat(column.astype(np.bool_), starts), 2)
