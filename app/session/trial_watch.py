"""Where a trial stands, from its ticks: covered path, deviation so far, and whether it is over."""

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.session.watching import FaultPatience
from app.world.path import Path
from app.world.progress import Progress

End = Literal["goal", "time-out", "by hand", "fault"]


class TrialPlace(NamedTuple):
    """Where the chair is along the path."""

    t: float  # s since motion was first permitted
    done: float  # m along the path
    length: float  # m
    cross_track: float  # m, left positive
    e_diff: float  # m2, area between the driven line and the path so far


class TrialWatch:
    """Takes the ticks of one trial, in order, and says when it is over.

    The running area is the sum of |cross-track| over what was covered of the path, in both directions: for people to
    look at. The trial's own E_diff is measured afterwards, from the recording.
    """

    def __init__(self, path: Path, goal_radius: float, time_limit: float) -> None:
        self._progress = Progress(path, goal_radius)
        self._time_limit = time_limit
        self._began: float | None = None
        self._patience = FaultPatience()
        self.place = TrialPlace(0.0, 0.0, path.length, 0.0, 0.0)

    def take(self, ticks: NDArray[np.void]) -> End | None:
        """Take the newest ticks (`app.messages.TICK`) of the run; return how the trial ended, None while it goes on."""
        for tick in ticks:
            end = self._take_one(float(tick["t"]), float(tick["x"]), float(tick["y"]), State(int(tick["state"])))
            if end is not None:
                return end
        return None

    def _take_one(self, t: float, x: float, y: float, state: State) -> End | None:
        if self._patience.ends(t, state):
            return "fault"
        if self._began is None:
            if state is not State.ARMED:
                return None
            self._began = t
        before = self.place
        self._progress.update(x, y)
        done, cross_track = self._progress.s, self._progress.cross_track
        area = 0.5 * (abs(cross_track) + abs(before.cross_track)) * abs(done - before.done)
        self.place = TrialPlace(t - self._began, done, before.length, cross_track, before.e_diff + area)
        if self._progress.reached:
            return "goal"
        return "time-out" if self.place.t > self._time_limit else None
