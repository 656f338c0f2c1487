"""Decimation of long columns for the screen: by even sampling, or by minimum and maximum so that no peak is lost."""

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.intp]
Numbers = NDArray[np.float64]


class Decimation:
    """Reduces columns of `n_rows` rows to at most `most` points.

    The rows are divided into buckets of equal size, and each bucket gives two points. `sampled` returns the values at
    a quarter and at three quarters of the bucket, `peaks` the smallest and the largest value in their order of time.
    Columns that are short enough are returned whole.

    Attributes
    ----------
    rows : ndarray of int (n_points,)
        The sampled rows; their times are the times of all points.
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
        """Return the column (n_rows,) sampled evenly (n_points,)."""
        return column[self.rows]

    def peaks(self, column: NDArray[np.floating]) -> Numbers:
        """Return each bucket's smallest and largest value of a column (n_rows,): (n_points,), NaN where all are NaN."""
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
        # In a bucket without a number, the value at either index is NaN.
        return np.take_along_axis(grid, order, axis=1).reshape(-1)

    def any(self, column: NDArray[np.generic]) -> NDArray[np.bool_]:
        """Return whether the column (n_rows,) is true anywhere in the point's bucket (n_points,)."""
        if self._size == 1:
            return column.astype(np.bool_)
        starts = np.arange(0, self._n_rows, self._size)
        return np.repeat(np.logical_or.reduceat(column.astype(np.bool_), starts), 2)
