"""The chair in use: the virtual one or one of the paired ones; opened by the control process."""

from pathlib import Path
from typing import Literal

from app.json_values import JsonDocument
from app.news import News, Notify
from app.refusals import Conflict, Refusal, Unavailable
from app.session.control_link import ControlLink
from app.session.equipment.choice import ClinicChoice, without_folders
from app.session.equipment.pairing import key_file
from app.store.chairs import find_chair
from app.store.database import Database, Transaction
from app.store.tables import Clinic, PairedChair
from app.texts import Text, from_document, text_of

Dynamics = Literal["unicycle", "wheelchair"]

VIRTUAL_CHAIR = Text("visit-chair-virtual")


class Chairs(ClinicChoice):
    """The chair in use, virtual or real; a real chair that does not open is never replaced by another."""

    def __init__(self, database: Database, control: ControlLink, keys: Path, notify: Notify) -> None:
        super().__init__(database, control, notify)
        self._keys = keys
        self.chosen: PairedChair | None = None  # None: the virtual chair
        self.dynamics: Dynamics = "unicycle"  # of the virtual chair
        self.failure: Text | str | None = None  # why the chosen chair is not open, None when it is

    async def open(self) -> None:
        """Open the chair that was driven last; when it does not open, `failure` says why, and none takes its place."""
        try:
            await self._in_clinic(self._read)
            await self._open(self.chosen, self.dynamics)
        except Refusal as refusal:
            self.failure = without_folders(text_of(refusal), self._keys)

    async def choose(self, chair: PairedChair | None, dynamics: Dynamics) -> None:
        """Drive another chair; when it does not open, the one before stays and the reason is raised."""
        try:
            await self._open(chair, dynamics)
        except Unavailable:
            raise  # the next control process is given the chair that was open before
        except Conflict as refusal:
            raise Conflict(without_folders(text_of(refusal), self._keys)) from refusal
        self.chosen, self.dynamics, self.failure = chair, dynamics, None
        await self._in_clinic(self._write)
        self._notify(News(what="equipment"))

    async def state(self) -> Text | str:
        """Return the state of the chosen chair in a sentence."""
        if self.chosen is None:
            return VIRTUAL_CHAIR
        if self.failure is not None:
            return self.failure
        try:
            chair = (await self._control.call("status"))["chair"]
        except Refusal as refusal:
            return text_of(refusal)
        return from_document(chair["words"]) if chair["kind"] == "udp" else self.not_open

    @property
    def not_open(self) -> Text | str:
        """Return a sentence for a chair that is chosen and not open."""
        if self.failure is not None:
            return self.failure
        if self.chosen is None:
            return Text("visit-chair-not-open")
        return Text("visit-chair-not-open-named", name=self.chosen.name)

    async def _open(self, chair: PairedChair | None, dynamics: Dynamics) -> None:
        await self._control.load("chair", config=self._config(chair, dynamics))

    def _config(self, chair: PairedChair | None, dynamics: Dynamics) -> JsonDocument:
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

    def _read(self, db: Transaction, clinic: Clinic) -> None:
        stored = clinic.chair or {}
        self.dynamics = stored.get("dynamics", "unicycle")
        chair_id = stored.get("id")
        self.chosen = None if chair_id is None else find_chair(db, chair_id)

    def _write(self, _db: Transaction, clinic: Clinic) -> None:
        clinic.chair = {"id": self.chosen.id if self.chosen else None, "dynamics": self.dynamics}
