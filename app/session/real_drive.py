"""A drive of the real chair: a recorded run, armed, watched to its end."""

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.refusals import Conflict
from app.session.control_link import ControlLink
from app.session.readings import Readings
from app.session.run_watch import Halt, RunLost, Starter, follow_run
from app.session.runs import OpenRun, Runs
from app.store.database import Database
from app.store.drives import add_drive, finish_drive
from app.store.log import write_log
from app.store.tables import Chair, Drive, PatientSession, Run

STOP_LIMIT = 1.5  # s for closing a drive when the application ends
END_LIMIT = 30.0  # s for closing the recording, before a caller is told to look later

End = Literal["by hand", "fault"]


class DriveWatch:
    """Takes the ticks of one drive, in order."""

    def __init__(self) -> None:
        self.halt = Halt()
        self._began: float | None = None
        self.t = 0.0  # s since motion was first permitted

    def take(self, ticks: NDArray[np.void]) -> End | None:
        """Take the newest ticks (`app.messages.TICK`) of the run; return how the drive ended, None while it goes on."""
        for tick in ticks:
            t, state = float(tick["t"]), State(int(tick["state"]))
            if self._began is None and state is State.ARMED:
                self._began = t
            if self._began is not None:
                self.t = t - self._began
            if self.halt.take(t, state):
                return "fault"
        return None


@dataclass(frozen=True, slots=True)
class RunningDrive:
    """The drive that is going on."""

    id: int
    person_id: int  # who armed it
    screen: str  # the word of the screen that did, which must stay in view
    run: OpenRun
    watch: DriveWatch


class RealDriveFlow:
    """Starts one drive at a time and sees it through to its end."""

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
        self.drive: RunningDrive | None = None

    @property
    def running(self) -> bool:
        """Whether a drive is being started or driven."""
        return self._starting or self.drive is not None

    async def start(self, session: PatientSession, who: Starter, chair: Chair, parameters_id: int, digest: str) -> int:
        """Begin a drive and return its id: recorded, armed with the parameter set of this hash."""
        if self.running or self._runs.open is not None:
            raise Conflict("Something is being recorded already: end it first, then arm the chair.")
        self._starting = True
        try:
            return await self._start(session, who, chair, parameters_id, digest)
        finally:
            self._starting = False

    async def _start(self, session: PatientSession, who: Starter, chair: Chair, parameters_id: int, digest: str) -> int:
        meta = {"chair": chair.name, "key_id": chair.key_id, "hash": digest}
        run = await self._runs.begin(session.id, "drive", (), meta)
        try:
            drive_id = await asyncio.to_thread(self._note, session, who.name, chair, parameters_id, digest, run)
        except BaseException:
            await self._runs.end()
            raise
        self._end_asked.clear()
        self.drive = RunningDrive(drive_id, who.person_id, who.screen, run, DriveWatch())
        try:
            await self._control.call("arm", hash=digest)
        except BaseException:
            # It never began: the recording stays, the drive does not.
            self.drive = None
            await self._runs.end()
            await asyncio.to_thread(self._drop, drive_id)
            raise
        self._task = asyncio.create_task(self._see_through(self.drive))
        self._tell("drive")
        return drive_id

    async def end(self) -> int:
        """End the drive by hand, and return its id when its recording is closed."""
        drive, task = self.drive, self._task
        if drive is None or task is None:
            raise Conflict("The chair is not being driven: arm it first.")
        self._end_asked.set()
        try:
            await asyncio.wait_for(asyncio.shield(task), END_LIMIT)
        except TimeoutError as late:
            raise Conflict("The recording is still being closed: look at the drive again in a moment.") from late
        return drive.id

    async def stop(self) -> None:
        """End what runs because the application ends."""
        if self._task is not None:
            self._end_asked.set()
            await asyncio.wait([self._task], timeout=STOP_LIMIT)
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    async def _see_through(self, drive: RunningDrive) -> None:
        end: End = "fault"  # also when watching itself goes wrong: a drive is never left open
        try:
            end = await follow_run(self._control, drive.run.number, self._end_asked, drive.watch.take) or "by hand"
        except RunLost:
            pass
        finally:
            await self._finish(drive, end)

    async def _finish(self, drive: RunningDrive, end: End) -> None:
        distance = None
        try:
            await self._runs.end()
            distance = await asyncio.to_thread(self._distance, drive)
        except (ValueError, OSError):
            distance = None  # never permitted to move, or a recording that was cut
        finally:
            try:
                await asyncio.to_thread(self._save, drive.id, end, distance)
            finally:  # also when the database is gone: the drive is over
                self.drive = None
                self._tell("drive")

    def _distance(self, drive: RunningDrive) -> float:
        """Return the length (m) of the line that the chair drove by its own account, from the recording."""
        line = self._readings.trajectory(drive.run.folder)
        return float(np.hypot(np.diff(line.x), np.diff(line.y)).sum())

    def _note(
        self, session: PatientSession, person: str, chair: Chair, parameters_id: int, digest: str, run: OpenRun
    ) -> int:
        with self._database.transaction() as db:
            drive = add_drive(
                db,
                run=db.get_one(Run, run.id),
                clinic_id=session.clinic_id,
                patient_id=session.patient_id,
                chair_id=chair.id,
                parameters_id=parameters_id,
                digest=digest,
            )
            write_log(db, person, "armed", drive=drive.id, chair=chair.id, parameters=parameters_id, hash=digest)
            return drive.id

    def _drop(self, drive_id: int) -> None:
        with self._database.transaction(closing=True) as db:
            db.delete(db.get_one(Drive, drive_id))
            write_log(db, None, "arming refused", drive=drive_id)

    def _save(self, drive_id: int, end: End, distance: float | None) -> None:
        with self._database.transaction(closing=True) as db:
            finish_drive(db, drive_id, end, distance)
            write_log(db, None, "drive ended", drive=drive_id, end=end)
