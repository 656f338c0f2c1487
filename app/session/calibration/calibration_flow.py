"""The calibration of the open session: its steps are recorded one by one, can be repeated, and survive a restart."""

import asyncio
import math
from typing import NamedTuple

from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step, calibration_script, has_short_script, short_script
from app.clock import monotonic
from app.computing_process import ComputingProcess
from app.json_values import JsonDocument
from app.layout import ShirtLayout
from app.news import News, Notify
from app.refusals import Conflict, Refusal
from app.session.calibration.calibration_fit import CalibrationFit, garment
from app.session.calibration.calibration_progress import Progress
from app.session.calibration.garment import OthersPrior
from app.session.control_link import ControlLink
from app.session.equipment.shirt import Equipment
from app.session.recordings import check_recording
from app.session.runs import SessionRuns
from app.store.calibrations import begin_calibration, calibration_steps, set_step
from app.store.database import Database, Transaction
from app.store.tables import CalibrationStep, PatientSession
from app.texts import Text, text_of

WATCH_EVERY = 0.05  # s
STANDSTILL_LIMIT = 3.0  # s without progress of the run's time, after which the step fails
CHECK_LIMIT = 30.0  # s for checking a closed recording and fitting the map, before a caller is told to look later
RESULT = "result"
SHORT = "short"  # in the script of a calibration: true for the short one


class Outcome(NamedTuple):
    """How a step ended."""

    status: str
    reason: Text | str | None = None  # why it failed


INTERRUPTED = Outcome("failed", Text("visit-step-interrupted"))


class CalibrationFlow:
    """Records the steps of the session's calibration, one at a time, each in a task of its own."""

    def __init__(
        self,
        database: Database,
        control: ControlLink,
        equipment: Equipment,
        runs: SessionRuns,
        notify: Notify,
        computing: ComputingProcess,
        prior: OthersPrior,
        *,
        demonstration: bool,
    ) -> None:
        self._prior = prior
        self._demonstration = demonstration
        self._fit = CalibrationFit(database, runs, equipment, computing, prior)
        self._database = database
        self._control = control
        self._equipment = equipment
        self._runs = runs
        self._notify = notify
        self._computing = computing
        self._task: asyncio.Task[None] | None = None
        self._running: str | None = None
        self._interruption = INTERRUPTED  # the outcome of a step whose task is cancelled

    @property
    def running(self) -> bool:
        """Whether a step is being recorded or the map is being fitted."""
        return self._running is not None

    async def progress(self, session_id: int) -> Progress:
        """Return the state of the session's calibration; before its first step that of one in the shirt in use."""
        return await asyncio.to_thread(self._progress, session_id)

    async def start(self, session_id: int, step_id: str) -> None:
        """Record one step; its earlier recording no longer counts.

        After the first unfinished step the next one is shown; any other step stays shown.
        """
        progress = await self.progress(session_id)
        step = progress.step(step_id)
        needed = self._equipment.needed_layout()
        if progress.layout is None or progress.layout.without_rings != needed.without_rings:
            raise Conflict(Text("visit-shirt-changed"))
        self._refuse_while_running()
        self._running, self._task, self._interruption = step.id, None, INTERRUPTED
        try:
            run = await self._runs.begin(session_id, step.kind, step.cues, {"step": step.id})
        except BaseException:  # do not end the open run: it is not of this step
            self._running = None
            raise
        try:
            await asyncio.to_thread(self._set, session_id, step.id, "running", None, run.id, step.id)
        except BaseException:
            self._running = None
            await self._runs.end()
            raise
        task = asyncio.create_task(
            self._record(session_id, step, run.number, stays=step.id not in progress.missing[:1])
        )
        await asyncio.sleep(0)  # let it begin: a task cancelled before that would never close its recording
        self._task = task
        self._notify(News(what="calibration"))

    async def cancel(self, session_id: int, step_id: str) -> None:
        """Stop recording a step; its status is then "waiting" again.

        A recording that is closed already is checked to its end first, so that nothing runs after the refusal.
        """
        (await self.progress(session_id)).step(step_id)
        task = self._task if self._running == step_id else None
        if task is not None:
            if self._runs.open is not None:
                return await self.stop(Outcome("waiting"))
            await asyncio.wait([task], timeout=CHECK_LIMIT)
        raise Conflict(Text("visit-step-not-recorded"))

    async def skip(self, session_id: int, step_id: str) -> None:
        """Skip a prompted movement that this patient cannot make; the map is fitted from the others."""
        step = (await self.progress(session_id)).step(step_id)
        if step.kind != "prompt":
            raise Conflict(Text("visit-step-needed"))
        self._refuse_while_running()
        await asyncio.to_thread(self._set, session_id, step.id, "skipped", None, None, None)
        try:
            await self._go_on(session_id)
        finally:
            self._ended()

    async def fit_from_others(self, session_id: int) -> None:
        """Fit the map from the steps that are done, with other people in place of those that are not.

        Conflict, in a sentence, when that cannot be done.
        """
        progress = await self.progress(session_id)
        if not progress.may_drive_now:
            raise Conflict(Text("visit-drive-now-too-early"))
        await self.fit_again(session_id)

    async def fit_again(self, session_id: int) -> None:
        """Fit the map from the steps that are done; Conflict, in a sentence, when that cannot be done."""
        self._refuse_while_running()
        try:
            await self.go(session_id, RESULT)
            reason = await self._fit_now(session_id)
        finally:
            self._ended()
        if reason is not None:
            raise Conflict(reason)

    async def fit_earlier(self, session_id: int, person: str) -> None:
        """Fit the patient's earlier calibration to the shirt as it sits today, as the patient's next map.

        Conflict, in a sentence, when that cannot be done.
        """
        progress = await self.progress(session_id)
        if not progress.may_fit_earlier:
            raise Conflict(Text("visit-fit-too-early"))
        self._refuse_while_running()
        await asyncio.to_thread(self._fit.fit_earlier, session_id, progress, person)

    async def learn(self, session_id: int) -> bool:
        """Add an accepted calibration to the clinic's prior; return whether it could be added."""
        return await asyncio.to_thread(self._fit.learn, session_id, await self.progress(session_id))

    async def stop(self, outcome: Outcome = INTERRUPTED) -> None:
        """Stop the step that is being recorded, and give it this outcome."""
        task, self._task = self._task, None
        if task is None:
            return
        self._interruption = outcome
        task.cancel()
        await asyncio.gather(task, return_exceptions=True)

    async def go(self, session_id: int, step_id: str) -> None:
        """Show another step."""
        progress = await self.progress(session_id)
        if step_id != RESULT:
            progress.step(step_id)

        def _write() -> None:
            with self._database.transaction(closing=True) as db:
                self._begin_new(db, session_id)
                db.get_one(PatientSession, session_id).current_step = step_id

        await asyncio.to_thread(_write)
        self._notify(News(what="calibration"))

    async def restart(self, session_id: int, *, is_short: bool | None = None) -> None:
        """Begin the calibration anew, as the short or the whole one; None: as before.

        The recordings made so far stay on disk but no longer count. Conflict when the shirt has no short calibration.
        """
        self._refuse_while_running()
        layout = self._equipment.needed_layout()
        if is_short and not self._may_be_short(layout):
            raise Conflict(Text("visit-no-short-calibration"))
        await asyncio.to_thread(self._begin, session_id, layout, is_short)
        self._notify(News(what="calibration"))

    async def _record(self, session_id: int, step: Step, number: int, *, stays: bool) -> None:
        status = "failed"
        reason: Text | str | None = None
        try:
            reason = await self._wait(number, step.duration)
            run = await self._runs.end()
            if reason is None and run is not None:
                reason = await asyncio.to_thread(self._computing.ask, check_recording, run.folder, step.duration)
            status = "failed" if reason else "done"
        except asyncio.CancelledError:
            status, reason = self._interruption
            raise
        except (Refusal, ValueError, OSError) as error:
            reason = text_of(error)
        finally:
            try:
                await self._runs.end()
                await asyncio.to_thread(self._set, session_id, step.id, status, reason, None, None)
            except BaseException:  # also when the database is gone: the step has ended
                self._ended()
                raise
            if status != "done":
                self._ended()
        if status == "done":
            try:
                is_good = await self._is_good(session_id, step)
                await self._go_on(session_id, None if is_good and not stays else step.id, is_new=not stays)
            finally:
                self._ended()

    async def _is_good(self, session_id: int, step: Step) -> bool:
        """Judge a done step; its words say why it has to be repeated. What cannot be judged yet is left to the fit."""
        try:
            return not await asyncio.to_thread(self._fit.judge, session_id, await self.progress(session_id), step)
        except (Refusal, ValueError, OSError):
            return True

    def _refuse_while_running(self) -> None:
        if self._running is not None:
            raise Conflict(Text("visit-step-recorded"))

    def _ended(self) -> None:
        self._running = None
        self._notify(News(what="calibration"))

    async def _wait(self, number: int, duration: float) -> Text | None:
        """Wait until the run's own time has passed `duration`; return in words why it did not."""
        reached, moved_at = -1.0, monotonic()
        while True:
            await asyncio.sleep(WATCH_EVERY)
            tick = self._control.newest()
            if tick is not None and int(tick["run"]) == number:
                run_t = float(tick["run_t"])
                if run_t >= duration:
                    return None
                if math.isfinite(run_t) and run_t > reached:
                    reached, moved_at = run_t, monotonic()
            if self._control.state != "alive":
                return Text("visit-step-process-ended")
            if monotonic() - moved_at > STANDSTILL_LIMIT:
                return Text("visit-step-nothing-recorded")

    async def _go_on(self, session_id: int, stay: str | None = None, *, is_new: bool = False) -> None:
        """After a step, show the next unfinished one or the one to stay at, and fit the map when all are finished.

        The result is shown then, unless the step was recorded for the first time and has to be repeated.
        """
        missing = (await self.progress(session_id)).missing
        shown = stay if missing or is_new else None
        await self.go(session_id, shown or (missing[0] if missing else RESULT))
        if not missing:
            await self._fit_now(session_id)

    async def _fit_now(self, session_id: int) -> Text | str | None:
        """Fit the map from the recordings, show the status of the fit as that of the result step, return why not."""
        self._running = RESULT
        await asyncio.to_thread(self._set, session_id, RESULT, "running", Text("visit-fitting"), None, None)
        self._notify(News(what="calibration"))
        status = "failed"
        reason: Text | str | None = Text("visit-fit-interrupted")
        try:
            await asyncio.to_thread(self._fit.fit, session_id, await self.progress(session_id))
            status, reason = "done", None
        except (ValueError, OSError, Refusal) as error:
            reason = text_of(error)
        finally:
            await asyncio.to_thread(self._set, session_id, RESULT, status, reason, None, None)
        return reason

    def _progress(self, session_id: int) -> Progress:
        running = self._running  # read before the rows: a step has its last status before it stops running
        started_run = self._runs.open.number if running and self._runs.open else None
        with self._database.reading() as db:
            session = db.get_one(PatientSession, session_id)
            rows = calibration_steps(db, session_id)
            script, current, result = session.script, session.current_step, session.result
            accepted = session.accepted
            status = {step: (row.status, row.words) for step, row in rows.items()}
            new = self._new_layout(session, rows)
            first = None if new is None else _script(new, is_short=self._is_short(session, new))
        if first is not None:
            script, current, result, accepted = first, None, None, False
            status = dict.fromkeys(_step_ids(first), ("waiting", ""))
        layout = None if script is None else ShirtLayout.model_validate(script["layout"])
        steps = () if script is None else _steps(script)
        is_short = script is not None and bool(script.get(SHORT))
        return Progress(
            layout=layout,
            steps=steps,
            current=current or (steps[0].id if steps else RESULT),
            status=status,
            running=running,
            started_run=started_run,
            profile=None if result is None else CalibrationProfile.model_validate(result),
            accepted=accepted,
            others=0 if layout is None else self._prior.people(session_id, garment(layout, self._equipment)),
            earlier=None if layout is None or result is not None else self._fit.earlier(session_id, layout),
            short=is_short if is_short or (layout is not None and self._may_be_short(layout)) else None,
        )

    def _new_layout(self, session: PatientSession, rows: dict[str, CalibrationStep]) -> ShirtLayout | None:
        """Return the layout in which a calibration has to begin; None when one is under way, or without a shirt."""
        in_use = self._equipment.layout
        if in_use is None or any(row.status != "waiting" for row in rows.values()):
            return None
        return None if _began_in(session, in_use) else in_use

    def _may_be_short(self, layout: ShirtLayout) -> bool:
        return self._equipment.is_camera and has_short_script(layout)

    def _is_short(self, session: PatientSession, layout: ShirtLayout) -> bool:
        """Return which calibration was chosen for this layout; before a choice, a demonstration takes the short one."""
        if session.script is not None and _began_in(session, layout):
            return bool(session.script.get(SHORT))
        return self._demonstration and self._may_be_short(layout)

    def _begin_new(self, db: Transaction, session_id: int) -> None:
        """Begin a calibration in the shirt in use unless one is under way."""
        session = db.get_one(PatientSession, session_id)
        layout = self._new_layout(session, calibration_steps(db, session_id))
        if layout is not None:
            script = _script(layout, is_short=self._is_short(session, layout))
            begin_calibration(db, session, script, _step_ids(script))

    def _begin(self, session_id: int, layout: ShirtLayout, is_short: bool | None) -> None:
        with self._database.transaction() as db:
            session = db.get_one(PatientSession, session_id)
            script = _script(layout, is_short=self._is_short(session, layout) if is_short is None else is_short)
            begin_calibration(db, session, script, _step_ids(script))

    def _set(
        self,
        session_id: int,
        step: str,
        status: str,
        reason: Text | str | None,
        run_id: str | None,
        current: str | None,
    ) -> None:
        with self._database.transaction(closing=True) as db:
            self._begin_new(db, session_id)
            set_step(db, session_id, step, status, reason or "", run_id)
            if current is not None:
                db.get_one(PatientSession, session_id).current_step = current


def _script(layout: ShirtLayout, *, is_short: bool) -> JsonDocument:
    script: JsonDocument = {"layout": layout.model_dump(mode="json")}
    return {**script, SHORT: True} if is_short else script


def _began_in(session: PatientSession, layout: ShirtLayout) -> bool:
    """Return whether the session's calibration began in this layout."""
    return session.script is not None and session.script["layout"] == layout.model_dump(mode="json")


def _steps(script: JsonDocument) -> tuple[Step, ...]:
    layout = ShirtLayout.model_validate(script["layout"])
    return short_script(layout) if script.get(SHORT) else calibration_script(layout)


def _step_ids(script: JsonDocument) -> list[str]:
    return [step.id for step in _steps(script)] + [RESULT]
