"""Where a trial stands, from its ticks: covered path, deviation so far, and whether it is over."""

import math
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.world.path import Path

End = Literal["goal", "time-out", "by hand", "fault"]

LOOK_ALONG = 2.0  # m before and behind the last place: further a chair does not get between two looks
COVERED = 0.8  # share of the path that must have been driven before its end counts as reached
FAULT_LIMIT = 20.0  # s: a latched stop pauses a trial; uncleared for so long, it ends it


class TrialPlace(NamedTuple):
    """Where the chair is along the path."""

    t: float  # s since the start of the run
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
        self._path = path
        self._goal_radius = goal_radius
        self._time_limit = time_limit
        self._fault_since: float | None = None
        self._furthest = 0.0
        self.place = TrialPlace(0.0, 0.0, path.length, 0.0, 0.0)

    def take(self, ticks: NDArray[np.void]) -> End | None:
        """Take the newest ticks of the run; return how the trial ended, None while it goes on."""
        for tick in ticks:
            end = self._take_one(
                float(tick["run_t"]), float(tick["x"]), float(tick["y"]), State(int(tick["state"])), float(tick["t"])
            )
            if end is not None:
                return end
        return None

    def _take_one(self, run_t: float, x: float, y: float, state: State, t: float) -> End | None:
        before = self.place
        done, cross_track = self._path.project_near(x, y, before.done, LOOK_ALONG)
        area = 0.5 * (abs(cross_track) + abs(before.cross_track)) * abs(done - before.done)
        self.place = TrialPlace(run_t, done, self._path.length, cross_track, before.e_diff + area)
        self._furthest = max(self._furthest, done)
        if state is State.FAULT:
            self._fault_since = t if self._fault_since is None else self._fault_since
            if t - self._fault_since >= FAULT_LIMIT:
                return "fault"
        else:
            self._fault_since = None
        goal_x, goal_y = self._path.points[-1]
        near = math.hypot(x - goal_x, y - goal_y) < self._goal_radius
        if near and self._furthest >= COVERED * self._path.length:
            return "goal"
        if run_t > self._time_limit:
            return "time-out"
        return None
