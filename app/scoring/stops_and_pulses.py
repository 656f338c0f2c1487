"""Counts of a trial: stops of the chair, pulses of the commands, changes of the turning direction."""

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]

MOVING = 0.10  # m/s; at this speed or above, the chair moves
STANDING = 0.05  # m/s; below, the chair stands; between the two limits its state does not change
SHORTEST_STOP = 0.5  # s; a shorter standstill is not a stop
ON = 0.10  # of a control; at this value or above, it is a command
OFF = 0.05  # of a control; below, it is no command; between the two limits its state does not change


def standstills(speed: Numbers, sample_rate: float) -> int:
    """Return how often the chair stood for at least half a second between two movements.

    `speed` (n,) in m/s, evenly sampled at `sample_rate` (Hz). Standing before the first movement or after the last one
    is no stop.
    """
    moving = _hysteresis(speed, MOVING, STANDING)
    edges = np.flatnonzero(np.diff(moving.astype(np.int8)))
    if not len(edges):
        return 0
    if not moving[0]:
        edges = edges[1:]  # leave out the beginning of the first movement
    pauses = edges[1 : len(edges) // 2 * 2 : 2] - edges[0 : len(edges) // 2 * 2 : 2]
    return int(np.count_nonzero(pauses >= SHORTEST_STOP * sample_rate))


def onsets(control: Numbers) -> int:
    """Return how many command pulses begin in a control (n,), in both directions together."""
    return sum(_rises(_hysteresis(side, ON, OFF)) for side in (control, -control))


def reversals(control: Numbers) -> int:
    """Return how often the commands of a control (n,) change from one direction to the other."""
    left, right = _hysteresis(control, ON, OFF), _hysteresis(-control, ON, OFF)
    direction = left.astype(np.int8) - right.astype(np.int8)
    direction = direction[direction != 0]
    return int(np.count_nonzero(np.diff(direction)))


def _rises(on: NDArray[np.bool_]) -> int:
    return int(np.count_nonzero(np.diff(on.astype(np.int8), prepend=0) == 1))


def _hysteresis(values: Numbers, on: float, off: float) -> NDArray[np.bool_]:
    """Return (n,) whether a switch with hysteresis is on: from a value of `on` or more until one below `off`."""
    decided = np.where(values >= on, 1, np.where(values < off, 0, -1))
    last = np.maximum.accumulate(np.where(decided >= 0, np.arange(len(values)), -1))
    return np.asarray((last >= 0) & (decided[last] == 1))
