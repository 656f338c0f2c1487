"""The progress of a trial, from its ticks: distance along the path, area off it, and whether it has ended."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.faults import State, is_pause
from app.geometry import Pose
from app.session.run_watch import Halt
from app.store.tables import TrialEnding
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.movers import Track
from app.world.progress import leader_of, progress_of


class TrialPlace(NamedTuple):
    """The chair's progress in its task."""

    t: float  # s in which motion was permitted
    done: float  # m along the path of the present stage, or rad turned
    length: float  # m, or rad
    cross_track: float  # m, left positive; for a turn, distance to the spot
    e_diff: float  # m2, area between the driven line and the path so far
    stage: int = 0  # from 0
    leader: Pose | None = None  # of the person or chair to follow
    leader_distance: float | None = None  # m, between the two middles


class TrialWatch:
    """Takes the ticks of one trial, in order, and tells when it has ended.

    The running area is the sum of |cross-track error| over the covered length of the path, in both directions, for the
    live picture only. The E_diff of the trial is measured afterwards, from the recording.
    """

    def __init__(self, plan: FloorPlan, path: PrescribedPath) -> None:
        self.progress = progress_of(plan, path)
        self._leader = leader_of(plan, path)
        self._tracks = [Track(mover) for mover in plan.movers]
        self._time_limit = path.time_limit
        self._last: float | None = None  # time of the last tick since motion was first permitted, s
        self.halt = Halt()
        self.pauses = 0  # so far
        self.paused = False
        self.place = TrialPlace(0.0, 0.0, self.progress.length, 0.0, 0.0)

    def movers(self, scene_t: float) -> list[Pose]:
        """Return the poses of the plan's movers at the scene's time (s), in the plan's order."""
        return [track.at(scene_t).pose for track in self._tracks]

    def take(self, ticks: NDArray[np.void]) -> TrialEnding | None:
        """Take the newest ticks (`app.messages.TICK`) of the run; return how the trial ended, None while it goes on."""
        for tick in ticks:
            end = self._take_one(tick, float(tick["t"]), State(int(tick["state"])))
            if end is not None:
                return end
        return None

    def _take_one(self, tick: np.void, t: float, state: State) -> TrialEnding | None:
        was_paused, self.paused = self.paused, is_pause(state, int(tick["fault"]))
        waits = self.paused or state is State.FAULT
        if self.halt.take(t, waits):
            return "fault"
        if self._last is None and state is not State.ARMED:
            return None
        self.pauses += self.paused and not was_paused
        before, progress = self.place, self.progress
        driven = before.t + (t - self._last if self._last is not None and state is State.ARMED else 0.0)
        self._last = t
        pose, scene_t = Pose(float(tick["x"]), float(tick["y"]), float(tick["theta"])), float(tick["scene_t"])
        progress.update(pose, float(tick["driven_v"]), scene_t)
        done, cross_track = progress.s, progress.cross_track
        covered = abs(done - before.done) if progress.stage == before.stage else 0.0
        area = 0.5 * (abs(cross_track) + abs(before.cross_track)) * covered
        leader = None if self._leader is None else self._leader.at(scene_t).pose
        distance = None if leader is None else math.hypot(pose.x - leader.x, pose.y - leader.y)
        e_diff = before.e_diff + area
        self.place = TrialPlace(driven, done, progress.length, cross_track, e_diff, progress.stage, leader, distance)
        if waits:
            return None  # only a person or HALT_LIMIT ends it
        if progress.reached:
            return "goal"
        return "time-out" if driven > self._time_limit else None
