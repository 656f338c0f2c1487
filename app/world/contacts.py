"""When a touch of the chair with a wall, an obstacle or a person is a new contact."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

NEW_CONTACT_AFTER: Final = 0.25  # s without touching, after which the next touch is a new contact


def contact_rows(touching: NDArray[np.bool_], t: NDArray[np.float64]) -> NDArray[np.intp]:
    """Return the rows in which a contact begins, of `touching` (n,) at the times `t` (n,) in s.

    The virtual chair counts its contacts by the same rule; this is for trajectories without its count.
    """
    rows = np.flatnonzero(touching)
    touched = np.insert(t[rows[:-1]], 0, -np.inf)[: len(rows)]  # the time of the touch before
    return rows[t[rows - 1] - touched >= NEW_CONTACT_AFTER]
