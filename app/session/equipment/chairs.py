"""Which chair is driven: the virtual one or one of those that are paired; opened by the control process."""

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

from app.refusals import Conflict, Refusal, Unavailable
from app.session.control_link import ControlLink
from app.session.equipment.pairing import key_file
from app.store.chairs import find_chair
from app.store.database import Database
from app.store.people import the_clinic
from app.store.tables import Chair

Dynamics = Literal["unicycle", "wheelchair"]

VIRTUAL_WORDS = "The virtual chair: nothing moves but the picture."


class Chairs:
    """Chosen by people, kept in the database, opened by the control process; a chair that fails is never replaced."""

    def __init__(self, database: Database, control: ControlLink, keys: Path, tell: Callable[[str], None]) -> None:
        self._database = database
        self._control = control
        self._keys = keys
        self._tell = tell
        self.chosen: Chair | None = None  # None: the virtual chair
        self.dynamics: Dynamics = "unicycle"  # of the virtual chair
        self.words = ""  # why the chosen chair is not open, empty when it is

    async def open(self) -> None:
        """Open what was driven last; what does not open is said in words, and nothing takes its place."""
        try:
            await asyncio.to_thread(self._read)
            await self._open(self.chosen, self.dynamics)
        except Refusal as refusal:
            self.words = self._without_places(str(refusal))

    async def choose(self, chair: Chair | None, dynamics: Dynamics) -> None:
        """Drive another chair; when it does not open, the one before stays and the reason is raised."""
        try:
            await self._open(chair, dynamics)
        except Unavailable:
            raise  # the next control process is given the chair that was open before
        except Conflict as refusal:
            raise Conflict(self._without_places(str(refusal))) from refusal
        self.chosen, self.dynamics, self.words = chair, dynamics, ""
        await asyncio.to_thread(self._write)
        self._tell("equipment")

    async def state(self) -> str:
        """Return in words how the chosen chair is."""
        if self.chosen is None:
            return VIRTUAL_WORDS
        if self.words:
            return self.words
        try:
            chair = (await self._control.call("status"))["chair"]
        except Refusal as refusal:
            return str(refusal)
        return str(chair["words"]) if chair["kind"] == "udp" else self.not_open

    @property
    def not_open(self) -> str:
        """Return what is said of a chair that is chosen and not open."""
        name = "The chair" if self.chosen is None else self.chosen.name
        return self.words or f"{name} is not open: choose it again."

    async def _open(self, chair: Chair | None, dynamics: Dynamics) -> None:
        await self._control.load("chair", config=self._config(chair, dynamics))

    def _config(self, chair: Chair | None, dynamics: Dynamics) -> dict[str, Any]:
        if chair is None:
            return {"kind": "virtual", "dynamics": dynamics}
        return {
            "kind": "udp",
            "name": chair.name,
            "host": chair.host,
            "port": chair.port,
            "key_file": str(key_file(self._keys, chair.key_id)),
            "speeds": chair.speeds,
        }

    def _without_places(self, sentence: str) -> str:
        return sentence.replace(f"{self._keys}/", "")

    def _read(self) -> None:
        with self._database.transaction() as db:
            clinic = the_clinic(db)
            kept = (clinic.chair if clinic is not None else None) or {}
            self.dynamics = kept.get("dynamics", "unicycle")
            chair_id = kept.get("id")
            self.chosen = None if clinic is None or chair_id is None else find_chair(db, clinic, chair_id)

    def _write(self) -> None:
        with self._database.transaction() as db:
            clinic = the_clinic(db)
            if clinic is not None:
                clinic.chair = {"id": self.chosen.id if self.chosen else None, "dynamics": self.dynamics}
