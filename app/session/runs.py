"""One run at a time: begun in the control process and noted in the database, and ended in both."""

import asyncio
import uuid
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from app.cues import Cue
from app.refusals import Conflict, Refusal
from app.session.control_link import ControlLink
from app.source import Source
from app.store.database import Database
from app.store.runs import add_run, close_run


@dataclass(frozen=True, slots=True)
class OpenRun:
    """A run that is being recorded."""

    id: str
    number: int  # as it stands in the ticks
    folder: Path
    kind: str
    cues: tuple[Cue, ...]


class Runs:
    """Begins and ends runs; their folders bear no name but the run's own."""

    def __init__(self, database: Database, control: ControlLink, folder: Path) -> None:
        self._database = database
        self._control = control
        self._folder = folder
        self.open: OpenRun | None = None
        self._beginning = False

    def folder_of(self, run: str) -> Path:
        """Return where the recording of a run lies."""
        return self._folder / run

    async def begin(self, session_id: int, kind: str, cues: Sequence[Cue], meta: dict[str, Any]) -> OpenRun:
        """Start recording; the run is in the database only when the control process has begun it."""
        if self.open is not None or self._beginning:
            raise Conflict("Something is being recorded already: wait for its end, or stop it first.")
        self._beginning = True
        try:
            return await self._begin(session_id, kind, cues, meta)
        finally:
            self._beginning = False

    async def _begin(self, session_id: int, kind: str, cues: Sequence[Cue], meta: dict[str, Any]) -> OpenRun:
        run_id = uuid.uuid4().hex
        folder = self.folder_of(run_id)
        answer = await self._control.call(
            "run",
            run_id=run_id,
            folder=str(folder),
            kind=kind,
            cues=[cue.model_dump(mode="json") for cue in cues],
            meta=meta,
        )
        try:
            await asyncio.to_thread(self._note, run_id, session_id, kind, Source.model_validate(answer["source"]))
        except BaseException:
            with suppress(Refusal):  # nobody would know of this run, so nobody would ever end it
                await self._control.call("end_run")
            raise
        self.open = OpenRun(run_id, int(answer["run"]), folder, kind, tuple(cues))
        return self.open

    async def end(self) -> OpenRun | None:
        """Close the recording and return its run, None when there is none; a recording that was cut counts too."""
        run = self.open
        if run is None:
            return None
        rows = dropped = None
        try:
            answer = await self._control.call("end_run")
            rows, dropped = answer.get("rows"), answer.get("dropped")
        except Refusal:
            pass  # the control process has gone; the recording holds what it had written by then
        self.open = None
        await asyncio.to_thread(self._close, run.id, rows, dropped)
        return run

    def _note(self, run_id: str, session_id: int, kind: str, source: Source) -> None:
        with self._database.transaction() as db:
            add_run(db, run_id, session_id, kind, run_id, source)

    def _close(self, run_id: str, rows: int | None, dropped: int | None) -> None:
        with self._database.transaction(closing=True) as db:
            close_run(db, run_id, rows, dropped)
