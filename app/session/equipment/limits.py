"""What the clinic's owner allows: kept in the database, held by the control process."""

import asyncio
from collections.abc import Callable
from contextlib import suppress

from app.refusals import Refusal
from app.session.control_link import ControlLink
from app.speeds import HIGHEST_SPEEDS, Speeds
from app.store.chairs import limits_of
from app.store.database import Database
from app.store.log import write_log
from app.store.people import the_clinic


class ClinicLimits:
    """The middle one of three levels: nobody here drives faster, whatever a parameter set or a chair would allow."""

    def __init__(self, database: Database, control: ControlLink, tell: Callable[[str], None]) -> None:
        self._database = database
        self._control = control
        self._tell = tell
        self.speeds = HIGHEST_SPEEDS

    async def open(self) -> None:
        """Hold what the owner set last."""
        self.speeds = await asyncio.to_thread(self._read)
        with suppress(Refusal):
            await self._hold(self.speeds)

    async def set(self, speeds: Speeds, person: str) -> None:
        """Hold other limits; refused while the chair moves when one of them is higher. Nothing changes then."""
        await self._hold(speeds)
        before, self.speeds = self.speeds, speeds
        await asyncio.to_thread(self._write, before, person)
        self._tell("controls")

    async def _hold(self, speeds: Speeds) -> None:
        await self._control.load("limits", clinic=speeds.model_dump(mode="json"))

    def _read(self) -> Speeds:
        with self._database.transaction() as db:
            return limits_of(the_clinic(db))

    def _write(self, before: Speeds, person: str) -> None:
        with self._database.transaction() as db:
            clinic = the_clinic(db)
            if clinic is not None:
                clinic.limits = self.speeds.model_dump(mode="json")
                write_log(db, person, "limits set", before=before.model_dump(), now=self.speeds.model_dump())
