"""A trial: the chair on the start, a run, armed, watched to its end, and measured from the recording."""

import asyncio
import math
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.faults import State, is_pause
from app.geometry import Pose
from app.session.recordings import measure_recording, quality_of_recording
from app.session.run_flow import CurrentRun, FlowMessages, RunFigures, RunFlow
from app.session.run_watch import Halt, Starter
from app.session.runs import SessionRun
from app.store.control_quality import save_quality
from app.store.log import write_log
from app.store.parameters import as_document, current_parameters
from app.store.runs import add_trial, finish_trial
from app.store.tables import PatientSession, Run, Trial, TrialEnding
from app.texts import Text
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
    """Follows the ticks of one trial, in order, until it has ended.

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

    def update(self, ticks: NDArray[np.void]) -> TrialEnding | None:
        """Follow the newest ticks (`app.messages.TICK`) of the run; return how it ended, None while it goes on."""
        for tick in ticks:
            end = self._step(tick, float(tick["t"]), State(int(tick["state"])))
            if end is not None:
                return end
        return None

    def _step(self, tick: np.void, t: float, state: State) -> TrialEnding | None:
        was_paused, self.paused = self.paused, is_pause(state, int(tick["fault"]))
        waits = self.paused or state is State.FAULT
        if self.halt.update(t, waits):
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


@dataclass(frozen=True, slots=True)
class RunningTrial(CurrentRun):
    """The trial that is being driven."""

    watch: TrialWatch
    plan: FloorPlan
    path: PrescribedPath

    @property
    def place(self) -> TrialPlace:
        """Return where the chair is along the path."""
        return self.watch.place


class TrialFlow(RunFlow[RunningTrial]):
    """Starts one trial on the virtual chair at a time and follows it to its measures."""

    messages = FlowMessages(
        event="trial",
        not_running=Text("visit-no-trial"),
        still_closing=Text("visit-trial-still-measured"),
    )

    async def start(self, session: PatientSession, starter: Starter, plan: FloorPlan, path: PrescribedPath) -> int:
        """Begin a trial and return its id: chair on the start, recording, armed."""
        async with self._alone():
            parameters_id, parameters_hash = await asyncio.to_thread(self._parameters, session.patient_id)
            await self._control.call("world", floorplan=plan.model_dump(mode="json"), path=path.name)
            meta = {"floorplan": plan.name, "path": path.name, "picture": starter.picture}
            return await self._arm(
                session.id, meta, parameters_hash, partial(self._add, session, parameters_id, starter, plan, path)
            )

    def _parameters(self, patient_id: int) -> tuple[int, str]:
        with self._database.reading() as db:
            row, profile = current_parameters(db, patient_id)
            return row.id, as_document(row, profile).hash  # computed as the control process does

    def _add(
        self,
        session: PatientSession,
        parameters_id: int,
        starter: Starter,
        plan: FloorPlan,
        path: PrescribedPath,
        run: SessionRun,
    ) -> RunningTrial:
        with self._database.transaction() as db:
            trial = add_trial(
                db,
                run=db.get_one(Run, run.id),
                patient_id=session.patient_id,
                parameters_id=parameters_id,
                floorplan=plan.name,
                floorplan_title=plan.title,
                path=path.name,
                path_points=[[x, y] for x, y in path.points],
            )
            write_log(db, starter.name, "armed", trial=trial.id, parameters=parameters_id, picture=starter.picture)
            watch = TrialWatch(plan, path)
            return RunningTrial(
                trial.id, session.patient_id, session.id, starter.person_id, starter.screen, run, watch, plan, path
            )

    async def _measure(self, current: RunningTrial, figures: RunFigures) -> None:
        folder = current.run.folder
        ask = self._computing.ask
        figures["measures"] = await asyncio.to_thread(ask, measure_recording, folder, current.plan, current.path)
        figures["quality"] = await asyncio.to_thread(ask, quality_of_recording, folder)

    def _delete(self, current_id: int) -> None:
        with self._database.transaction(closing=True) as db:
            db.delete(db.get_one(Trial, current_id))

    def _save(self, current_id: int, end: str, figures: RunFigures) -> None:
        with self._database.transaction(closing=True) as db:
            finish_trial(db, current_id, end, figures.get("measures"))
            if "quality" in figures:
                save_quality(db, current_id, figures["quality"])
            write_log(db, None, "trial ended", trial=current_id, end=end)
