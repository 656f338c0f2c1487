"""Where the chair was in a recorded trial, from the moment when motion was first permitted."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.recording.format import Columns
from app.recording.reader import read_run
from app.texts import Text

APART = 0.05  # m between two points that are shown


class RecordedTrajectory(NamedTuple):
    """Where the chair was in a trial."""

    t: NDArray[np.float64]  # (n,) s, from 0
    x: NDArray[np.float64]  # (n,) m
    y: NDArray[np.float64]


def read_trajectory(folder: Path) -> RecordedTrajectory:
    """Return the trajectory in a recording; ValueError when motion was never permitted, or nothing was recorded."""
    rows = since_armed(read_run(folder, ["t", "state", "x", "y"]).columns)
    return RecordedTrajectory(rows["t"] - rows["t"][0], rows["x"], rows["y"])


def since_armed(columns: Columns) -> Columns:
    """Return the rows from the first one in which motion was permitted; ValueError without one."""
    armed = np.flatnonzero(columns["state"] == State.ARMED)
    if len(armed) == 0:
        raise ValueError(Text("recording-never-armed"))
    return {name: column[armed[0] :] for name, column in columns.items()}


def thinned(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.intp]:
    """Return which points (n,) to show: the first, the last, and about one every 5 cm of the way."""
    if len(x) == 0:
        return np.empty(0, dtype=np.intp)
    along = np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))))
    chosen = np.flatnonzero(np.concatenate(([True], np.diff(np.floor(along / APART)) > 0)))
    return chosen if chosen[-1] == len(x) - 1 else np.append(chosen, len(x) - 1)
