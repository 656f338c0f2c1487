"""Write a row into the log for every stop and every fault."""

import asyncio
import logging
from collections.abc import Callable

from app.clock import monotonic
from app.faults import Fault, is_pause
from app.session.control_link import ControlLink, ControlState
from app.store.database import Database
from app.store.log import write_log

WATCH_EVERY = 0.1  # s
REQUEST_EVERY = 1.0  # s

logger = logging.getLogger("bodydrive")


class FaultLog:
    """Watches the newest tick and logs each pause and each new latched fault; a stop during a latched one is no row."""

    def __init__(self, database: Database, control: ControlLink, during: Callable[[], dict[str, int]]) -> None:
        """`during` returns the id of the running trial or drive, to be logged with the fault."""
        self._database = database
        self._control = control
        self._during = during
        self._latched = Fault.NONE
        self._request_logged_at = -REQUEST_EVERY
        self._task: asyncio.Task[None] | None = None
        control.on_change.append(self._changed)

    def start(self) -> None:
        """Begin to watch."""
        self._task = asyncio.create_task(self._watch())

    async def close(self) -> None:
        """Stop watching."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    async def stop_requested(self, person: str) -> None:
        """Log who asked for a stop; at most one row per REQUEST_EVERY, so that a flood of stops writes little."""
        now = monotonic()
        if now - self._request_logged_at < REQUEST_EVERY:
            return
        self._request_logged_at = now
        try:
            await asyncio.to_thread(self._write, "stop requested", person, **self._during())
        except Exception:  # the stop itself was carried out, and is logged as a fault
            logger.exception("Who asked for a stop could not be logged")

    async def _watch(self) -> None:
        while True:
            await asyncio.sleep(WATCH_EVERY)
            tick = self._control.newest()
            if tick is not None:
                await self._log_fault(Fault(int(tick["fault"])), is_pause=is_pause(tick["state"], tick["fault"]))

    async def _changed(self, state: ControlState) -> None:
        if state == "lost":
            await self._log_fault(Fault.CONTROL_LOST)

    async def _log_fault(self, fault: Fault, *, is_pause: bool = False) -> None:
        before, self._latched = self._latched, fault
        if fault in {before, Fault.NONE}:
            return
        what = "pause" if is_pause else "stop" if fault.name.startswith("STOP_") else "fault"
        try:
            await asyncio.to_thread(self._write, what, None, fault=fault.name.lower(), **self._during())
        except Exception:  # keep watching: a full database may have room again later
            logger.exception("A %s could not be logged", what)

    def _write(self, what: str, person: str | None, **details: object) -> None:
        with self._database.transaction(closing=True) as db:
            write_log(db, person, what, **details)
