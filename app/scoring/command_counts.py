"""Counts in a trial: standstills, contacts, command pulses, changes of the turn's direction."""

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]

MOVING = 0.10  # m/s, from here a chair moves
STANDING = 0.05  # m/s, below this it stands; between the two it goes on doing what it did
SHORTEST_STOP = 0.5  # s; a shorter standstill is not a stop
ON = 0.10  # of a control, from here it is a command
OFF = 0.05  # below this it is none
FREE_AGAIN = 0.25  # s without touching, after which the next touch is a new contact


def standstills(speed: Numbers, sample_rate: float) -> int:
    """Return how often a chair that moved stood for at least half a second and then moved on.

    `speed` (n,) in m/s, evenly sampled at `sample_rate` (Hz). Waiting at the start or standing at the end is no stop.
    """
    moving = _switched(speed, MOVING, STANDING)
    edges = np.flatnonzero(np.diff(moving.astype(np.int8)))
    if not len(edges):
        return 0
    if not moving[0]:
        edges = edges[1:]  # the beginning of the first movement
    pauses = edges[1 : len(edges) // 2 * 2 : 2] - edges[0 : len(edges) // 2 * 2 : 2]
    return int(np.count_nonzero(pauses >= SHORTEST_STOP * sample_rate))


def onsets(control: Numbers) -> int:
    """Return how many command pulses a control (n,) holds: beginnings, in either direction."""
    return sum(_rises(_switched(side, ON, OFF)) for side in (control, -control))


def reversals(control: Numbers) -> int:
    """Return how often a control (n,) that commanded one direction went on to command the other."""
    left, right = _switched(control, ON, OFF), _switched(-control, ON, OFF)
    direction = left.astype(np.int8) - right.astype(np.int8)
    direction = direction[direction != 0]
    return int(np.count_nonzero(np.diff(direction)))


def contact_beginnings(touching: NDArray[np.bool_], t: Numbers) -> int:
    """Return how many contacts there were; a touch within 0.25 s of the last belongs to the same contact."""
    return len(contact_rows(touching, t))


def contact_rows(touching: NDArray[np.bool_], t: Numbers) -> NDArray[np.intp]:
    """Return the rows in which a contact begins."""
    rows = np.flatnonzero(touching)
    return rows[np.diff(t[rows], prepend=-np.inf) >= FREE_AGAIN]


def _rises(on: NDArray[np.bool_]) -> int:
    return int(np.count_nonzero(np.diff(on.astype(np.int8), prepend=0) == 1))


def _switched(values: Numbers, on: float, off: float) -> NDArray[np.bool_]:
    """Return whether a switch with hysteresis is on: from `on` upwards, until it falls below `off`."""
    decided = np.where(values >= on, 1, np.where(values < off, 0, -1))
    last = np.maximum.accumulate(np.where(decided >= 0, np.arange(len(values)), -1))
    return np.asarray((last >= 0) & (decided[last] == 1))
