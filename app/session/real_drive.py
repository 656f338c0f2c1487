"""A drive of the real chair: a recorded run, armed, watched to its end."""

import asyncio
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.recording.recorded_trajectory import read_trajectory
from app.session.run_flow import CurrentRun, FlowMessages, RunFigures, RunFlow
from app.session.run_watch import Halt, Starter
from app.session.runs import SessionRun
from app.store.drives import add_drive, finish_drive
from app.store.log import write_log
from app.store.tables import Drive, DriveEnding, PairedChair, PatientSession, Run
from app.texts import Text


class DriveWatch:
    """Watches the ticks of one drive, in order."""

    def __init__(self) -> None:
        self.halt = Halt()
        self._began: float | None = None
        self.t = 0.0  # s since motion was first permitted

    def update(self, ticks: NDArray[np.void]) -> DriveEnding | None:
        """Follow the newest ticks (`app.messages.TICK`) of the run; return how it ended, None while it goes on."""
        for tick in ticks:
            t, state = float(tick["t"]), State(int(tick["state"]))
            if self._began is None and state is State.ARMED:
                self._began = t
            if self._began is not None:
                self.t = t - self._began
            if self.halt.update(t, state is State.FAULT):
                return "fault"
        return None


@dataclass(frozen=True, slots=True)
class RunningDrive(CurrentRun):
    """The drive that is going on."""

    watch: DriveWatch


class RealDriveFlow(RunFlow[RunningDrive]):
    """Starts one drive of the real chair at a time and follows it to its end."""

    messages = FlowMessages(
        event="drive",
        not_running=Text("visit-no-drive"),
        still_closing=Text("visit-drive-still-closing"),
    )

    async def start(
        self,
        session: PatientSession,
        starter: Starter,
        chair: PairedChair,
        parameters_id: int,
        digest: str,
        document: str,
    ) -> int:
        """Begin a drive and return its id: recorded, armed with the set and the chair document of this hash."""
        async with self._alone():
            armed_with = {"hash": digest, "document": document} if document else {"hash": digest}
            meta = {"chair": chair.name, "key_id": chair.key_id, **armed_with}
            add = partial(self._add, session, starter, chair, parameters_id, armed_with)
            return await self._arm(session.id, meta, digest, add)

    def _add(
        self,
        session: PatientSession,
        starter: Starter,
        chair: PairedChair,
        parameters_id: int,
        armed_with: Mapping[str, str],
        run: SessionRun,
    ) -> RunningDrive:
        with self._database.transaction() as db:
            drive = add_drive(
                db,
                run=db.get_one(Run, run.id),
                patient_id=session.patient_id,
                chair_id=chair.id,
                parameters_id=parameters_id,
                digest=armed_with["hash"],
            )
            what = {"drive": drive.id, "chair": chair.id, "parameters": parameters_id}
            write_log(db, starter.name, "armed", **what, **armed_with)
            return RunningDrive(
                drive.id, session.patient_id, session.id, starter.person_id, starter.screen, run, DriveWatch()
            )

    async def _measure(self, current: RunningDrive, figures: RunFigures) -> None:
        """Read the length (m) of the line that the chair drove by its own report."""
        line = await asyncio.to_thread(self._computing.ask, read_trajectory, current.run.folder)
        figures["distance"] = float(np.hypot(np.diff(line.x), np.diff(line.y)).sum())

    def _delete(self, current_id: int) -> None:
        with self._database.transaction(closing=True) as db:
            db.delete(db.get_one(Drive, current_id))
            write_log(db, None, "arming refused", drive=current_id)

    def _save(self, current_id: int, end: str, figures: RunFigures) -> None:
        with self._database.transaction(closing=True) as db:
            finish_drive(db, current_id, end, figures.get("distance"))
            write_log(db, None, "drive ended", drive=current_id, end=end)
