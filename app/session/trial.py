"""A trial: the chair on the start, a run, armed, watched to its end, and measured from the recording."""

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from app.refusals import Conflict
from app.scoring.control_quality import ControlQuality
from app.session.control_link import ControlLink
from app.session.readings import Readings
from app.session.run_watch import RunLost, Starter, follow_run
from app.session.runs import OpenRun, Runs
from app.session.trial_watch import End, TrialPlace, TrialWatch
from app.store.control_quality import save_quality
from app.store.database import Database
from app.store.log import write_log
from app.store.parameters import as_document, current_parameters
from app.store.runs import add_trial, finish_trial
from app.store.tables import PatientSession, Run, Trial
from app.world.floorplan import FloorPlan, PrescribedPath

STOP_LIMIT = 1.5  # s for the same when the application ends; then the trial stays without figures
END_LIMIT = 30.0  # s for closing and measuring a trial, before a caller is told to look later


@dataclass(frozen=True, slots=True)
class RunningTrial:
    """The trial that is being driven."""

    id: int
    person_id: int  # who started it
    screen: str  # the word of the screen that did, which must stay in view
    run: OpenRun
    watch: TrialWatch
    plan: FloorPlan
    path: PrescribedPath

    @property
    def place(self) -> TrialPlace:
        """Return where the chair is along the path."""
        return self.watch.place


class TrialOver(NamedTuple):
    """The trial that was driven last, and how it ended."""

    id: int
    end: End


class DriveFlow:
    """Starts one trial at a time and sees it through to its measures."""

    def __init__(
        self, database: Database, control: ControlLink, runs: Runs, tell: Callable[[str], None], readings: Readings
    ) -> None:
        self._database = database
        self._control = control
        self._runs = runs
        self._tell = tell
        self._readings = readings
        self._task: asyncio.Task[None] | None = None
        self._end_asked = asyncio.Event()
        self._starting = False
        self.trial: RunningTrial | None = None
        self.over: TrialOver | None = None  # since the program was started
        self.on_over: Callable[[int], None] = lambda _trial: None  # told the id of each trial that was measured

    @property
    def running(self) -> bool:
        """Whether a trial is being started, driven or measured."""
        return self._starting or self.trial is not None

    async def start(self, session: PatientSession, who: Starter, plan: FloorPlan, path: PrescribedPath) -> int:
        """Begin a trial and return its id: chair on the start, recording, armed."""
        if self.running or self._runs.open is not None:
            raise Conflict("Something is being recorded already: end it first, then start a trial.")
        self._starting = True
        try:
            return await self._start(session, who, plan, path)
        finally:
            self._starting = False

    async def _start(self, session: PatientSession, who: Starter, plan: FloorPlan, path: PrescribedPath) -> int:
        parameters_id, parameters_hash = await asyncio.to_thread(self._parameters, session.patient_id)
        await self._control.call("world", floorplan=plan.model_dump(mode="json"), path=path.name)
        run = await self._runs.begin(
            session.id, "drive", (), {"floorplan": plan.name, "path": path.name, "picture": who.picture}
        )
        try:
            trial_id = await asyncio.to_thread(self._note, session, parameters_id, who, plan, path, run)
        except BaseException:
            await self._runs.end()
            raise
        watch = TrialWatch(plan, path)
        self._end_asked.clear()
        self.trial = RunningTrial(trial_id, who.person_id, who.screen, run, watch, plan, path)
        try:
            await self._control.call("arm", hash=parameters_hash)
        except BaseException:
            # It never began: the recording stays, the trial does not.
            self.trial = None
            await self._runs.end()
            await asyncio.to_thread(self._drop, trial_id)
            raise
        self._task = asyncio.create_task(self._see_through(self.trial))
        self._tell("trial")
        return trial_id

    async def end(self) -> int:
        """End the trial by hand, and return its id when it has been measured."""
        trial, task = self.trial, self._task
        if trial is None or task is None:
            raise Conflict("No trial is running: start one first.")
        self._end_asked.set()
        try:
            await asyncio.wait_for(asyncio.shield(task), END_LIMIT)
        except TimeoutError as late:
            raise Conflict("The trial is still being measured: look at it again in a moment.") from late
        return trial.id

    async def stop(self) -> None:
        """End what runs because the application ends."""
        if self._task is not None:
            self._end_asked.set()
            await asyncio.wait([self._task], timeout=STOP_LIMIT)
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    async def _see_through(self, trial: RunningTrial) -> None:
        end: End = "fault"  # also when watching itself goes wrong: a trial is never left open
        try:
            end = await self._watch(trial)
            self.over = TrialOver(trial.id, end)
        finally:
            await self._finish(trial, end)

    async def _watch(self, trial: RunningTrial) -> End:
        try:
            return await follow_run(self._control, trial.run.number, self._end_asked, trial.watch.take) or "by hand"
        except RunLost:
            return "fault"

    async def _finish(self, trial: RunningTrial, end: End) -> None:
        measures = quality = None
        try:
            await self._runs.end()
            measures = await asyncio.to_thread(self._readings.measure, trial.run.folder, trial.plan, trial.path)
            quality = await asyncio.to_thread(self._readings.quality, trial.run.folder)
        except (ValueError, OSError):
            pass  # too short to measure, or cut: the trial stays in the list without figures
        finally:
            try:
                await asyncio.to_thread(self._save, trial.id, end, measures, quality)
            finally:  # also when the database is gone: the trial is over
                self.trial = None
                self._tell("trial")
        self.on_over(trial.id)

    def _parameters(self, patient_id: int) -> tuple[int, str]:
        with self._database.transaction() as db:
            row, profile = current_parameters(db, patient_id)
            # As the control process reckons it: the stored one may be of an older program, which knew fewer fields.
            return row.id, as_document(row, profile).hash

    def _note(
        self,
        session: PatientSession,
        parameters_id: int,
        who: Starter,
        plan: FloorPlan,
        path: PrescribedPath,
        run: OpenRun,
    ) -> int:
        with self._database.transaction() as db:
            trial = add_trial(
                db,
                run=db.get_one(Run, run.id),
                clinic_id=session.clinic_id,
                patient_id=session.patient_id,
                parameters_id=parameters_id,
                floorplan=plan.name,
                floorplan_title=plan.title,
                path=path.name,
                path_points=[[x, y] for x, y in path.points],
            )
            write_log(db, who.name, "armed", trial=trial.id, parameters=parameters_id, picture=who.picture)
            return trial.id

    def _drop(self, trial_id: int) -> None:
        with self._database.transaction(closing=True) as db:
            db.delete(db.get_one(Trial, trial_id))

    def _save(self, trial_id: int, end: End, measures: dict[str, Any] | None, quality: ControlQuality | None) -> None:
        with self._database.transaction(closing=True) as db:
            finish_trial(db, trial_id, end, measures)
            if quality is not None:
                save_quality(db, trial_id, quality)
            write_log(db, None, "trial ended", trial=trial_id, end=end)
