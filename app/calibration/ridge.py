"""The regression that every map but the standard one is learnt by."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def ridge(gram: Array, moment: Array, penalty: Array) -> Array:
    """Return the weights (d,) that minimise |F w - y|^2 + sum of penalty w^2.

    Parameters
    ----------
    gram, moment : (d, d) and (d,) array
        F'F and F'y of the features F and labels y, as sums or means over frames.
    penalty : (d,) array
        Above 0, in the unit of the diagonal of `gram`; infinite for a feature that is not read: its weight is 0.
    """
    # Solved in units in which every penalty is 1, so that the units of the signals do not matter.
    scale = 1.0 / np.sqrt(penalty)
    solved: Array = np.linalg.solve(gram * np.outer(scale, scale) + np.eye(len(scale)), moment * scale) * scale
    return solved
