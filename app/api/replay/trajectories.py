"""Trajectories for the screen: read from recordings, thinned to one point every 5 cm."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.computing_process import ComputingProcess
from app.derived_results import DerivedResults
from app.quantities import Document
from app.recording.recorded_trajectory import read_trajectory, thinned

MOST_TRAJECTORIES = 30  # of one picture, the newest; more could not be told apart
KEPT = 200  # trajectories in memory: the recording of an ended trial never changes


class Trajectory(NamedTuple):
    """Where the chair went."""

    t: list[float]  # s
    x: list[float]  # m
    y: list[float]  # m


class TrialLine(Document):
    """The trajectory of one trial."""

    number: int
    x: list[float]
    y: list[float]


class Trajectories:
    """Reads the trajectory of each recording once and caches it."""

    def __init__(self, computing: ComputingProcess) -> None:
        self._computing = computing
        self._trajectories: DerivedResults[Path, Trajectory] = DerivedResults(KEPT)

    def of(self, folder: Path) -> Trajectory | None:
        """Return the trajectory of an ended trial, None when its recording cannot be read."""
        return self.all([folder])[0]

    def all(self, folders: Sequence[Path]) -> list[Trajectory | None]:
        """Return the trajectory of each ended trial; those that are not known yet are read in one go."""
        remembered = self._trajectories.find(folders)
        unread = [folder for folder in folders if folder not in remembered]
        answers = self._computing.ask(shown_trajectories, unread) if unread else []
        read = {
            folder: trajectory for folder, trajectory in zip(unread, answers, strict=True) if trajectory is not None
        }
        self._trajectories.store(read)
        return [remembered.get(folder) or read.get(folder) for folder in folders]

    def lines(self, trials: Sequence[tuple[int, Path]]) -> list[TrialLine]:
        """Return the lines of ended trials, given by number and folder, without those that cannot be read."""
        read = zip(trials, self.all([folder for _, folder in trials]), strict=True)
        return [TrialLine(number=number, x=line.x, y=line.y) for (number, _), line in read if line is not None]


def shown_trajectories(folders: Sequence[Path]) -> list[Trajectory | None]:
    """Read the trajectories of these recordings, thinned; None for one that cannot be read."""
    shown: list[Trajectory | None] = []
    for folder in folders:
        try:
            rows = read_trajectory(folder)
        except (ValueError, OSError):
            shown.append(None)
            continue
        indices = thinned(rows.x, rows.y)
        shown.append(Trajectory(*(np.round(column[indices], 3).tolist() for column in rows)))
    return shown
