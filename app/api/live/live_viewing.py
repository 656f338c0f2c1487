"""The rows of the log for an open live socket: one for each patient whom its person begins to see."""

import asyncio
import logging

from fastapi import WebSocket

from app.api.sockets import OpenSockets
from app.session.open_session import SessionFlow
from app.store.database import Database
from app.store.log import log_viewing

logger = logging.getLogger("bodydrive")


class LiveViewing:
    """Decides whether a live socket shows the patient who is here, and logs each patient whom it begins to show."""

    def __init__(
        self, database: Database, sockets: OpenSockets, session: SessionFlow, websocket: WebSocket, person: str
    ) -> None:
        self._database = database
        self._sockets = sockets
        self._session = session
        self._websocket = websocket
        self._person = person
        self._shown: int | None = None  # the id of the patient
        self._rows: set[asyncio.Task[None]] = set()

    def may_see(self) -> bool:
        """Return whether the person may see the patient who is here now; called for every picture."""
        patient = self._session.patient_id
        sees = self._sockets.may_see(self._websocket, patient)
        shown = patient if sees else None
        if shown is not None and shown != self._shown:
            # Beside the pictures: the page of a chair that drives must not wait for the database.
            row = asyncio.create_task(asyncio.to_thread(self._log, shown))
            self._rows.add(row)
            row.add_done_callback(self._rows.discard)
        self._shown = shown
        return sees

    async def close(self) -> None:
        """Wait until the last row is written."""
        await asyncio.gather(*self._rows)

    def _log(self, patient: int) -> None:
        try:
            with self._database.transaction(closing=True) as db:
                log_viewing(db, self._person, patient)
        except Exception:  # go on: the page needs the pictures of a chair that may drive
            logger.exception("The viewing of the patient %d by a live socket could not be logged", patient)
