"""Begin and end a run: in the control process, which records it, and in the database. One run at a time."""

import asyncio
import uuid
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from app.cues import Cue
from app.recording.reader import kept_rows
from app.refusals import Conflict, Refusal
from app.session.control_link import ControlLink
from app.source import Source
from app.store.consent import require_consent
from app.store.database import Database
from app.store.log import log_once
from app.store.runs import add_run, close_run, open_runs, run_folders
from app.store.tables import PatientSession
from app.texts import Text
from app.world.cursor_task import CursorPlan

NAMELESS: Final = "recordings without a row"


@dataclass(frozen=True, slots=True)
class SessionRun:
    """A run that is being recorded."""

    id: str
    number: int  # of the run in the ticks
    after: int  # number of the last tick before it; the ring may hold 160 s of older ticks, which nobody needs
    folder: Path
    kind: str
    cues: tuple[Cue, ...]


class SessionRuns:
    """Begins and ends runs; a run's folder is named by its random id, never by a patient."""

    def __init__(
        self, database: Database, control: ControlLink, folder: Path, is_simulated: Callable[[], bool | None]
    ) -> None:
        self._database = database
        self._control = control
        self._folder = folder
        self._is_simulated = is_simulated  # whether nobody wears the shirt in use; None: there is none
        self.open: SessionRun | None = None
        self._beginning = False

    def folder_of(self, run: str) -> Path:
        """Return the folder of the recording of a run."""
        return self._folder / run

    async def begin(
        self,
        session_id: int,
        kind: str,
        cues: Sequence[Cue],
        meta: Mapping[str, object],
        test: CursorPlan | None = None,
    ) -> SessionRun:
        """Start recording; store the run in the database once the control process has begun it.

        Conflict when somebody wears the shirt and the patient has not consented to recording.
        """
        if self.open is not None or self._beginning:
            raise Conflict(Text("visit-recording"))
        self._beginning = True
        try:
            if self._is_simulated() is False:
                await asyncio.to_thread(self._require_consent, session_id)
            return await self._begin(session_id, kind, cues, meta, test)
        finally:
            self._beginning = False

    async def _begin(
        self, session_id: int, kind: str, cues: Sequence[Cue], meta: Mapping[str, object], test: CursorPlan | None
    ) -> SessionRun:
        run_id = uuid.uuid4().hex
        folder = self.folder_of(run_id)
        before = self._last_tick()
        answer = await self._control.call(
            "run",
            run_id=run_id,
            folder=str(folder),
            kind=kind,
            cues=[cue.model_dump(mode="json") for cue in cues],
            meta=meta,
            test=None if test is None else test.model_dump(mode="json"),
        )
        try:
            await asyncio.to_thread(self._store, run_id, session_id, kind, Source.model_validate(answer["source"]))
        except BaseException:
            with suppress(Refusal):  # otherwise a run without a row would never be ended
                await self._control.call("end_run")
            raise
        after = min(before, self._last_tick())  # a control process that was replaced meanwhile counts its ticks from 1
        self.open = SessionRun(run_id, int(answer["run"]), after, folder, kind, tuple(cues))
        return self.open

    def _last_tick(self) -> int:
        tick = self._control.newest()
        return 0 if tick is None else int(tick["number"])

    async def end(self) -> SessionRun | None:
        """Close the recording and return its run, also when the recording was cut; None when nothing is recorded."""
        run = self.open
        if run is None:
            return None
        rows = dropped = None
        try:
            answer = await self._control.call("end_run")
            rows, dropped = answer.get("rows"), answer.get("dropped")
        except Refusal:
            pass  # the control process has ended; the recording holds what was written until then
        self.open = None
        await asyncio.to_thread(self._close, run.id, rows, dropped)
        return run

    def _require_consent(self, session_id: int) -> None:
        with self._database.reading() as db:
            require_consent(db, db.get_one(PatientSession, session_id).patient_id, "recording")

    def _store(self, run_id: str, session_id: int, kind: str, source: Source) -> None:
        with self._database.transaction() as db:
            add_run(db, run_id, session_id, kind, run_id, source)

    def _close(self, run_id: str, rows: int | None, dropped: int | None) -> None:
        if rows is None:
            rows = kept_rows(self.folder_of(run_id))
        with self._database.transaction(closing=True) as db:
            close_run(db, run_id, rows, dropped)

    def close_interrupted(self) -> list[str]:
        """Store how many rows are on the disk of each run that an ended program left open.

        Returns
        -------
        list of str
            Names of recordings that no row of the database names: a program was killed before it could store one. They
            are kept; the start that finds them names them in the log.
        """
        with self._database.reading() as db:
            interrupted, named = open_runs(db), run_folders(db)
        rows = {run: kept_rows(self.folder_of(folder)) for run, folder in interrupted.items()}
        nameless = sorted(place.name for place in self._folder.glob("*") if place.is_dir() and place.name not in named)
        with self._database.transaction(closing=True) as db:
            for run, count in rows.items():
                close_run(db, run, count, None)
            if nameless:
                log_once(db, NAMELESS, recordings=nameless)
        return nameless
