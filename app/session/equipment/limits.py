"""The speed limits of the clinic's owner: stored with the clinic, enforced by the control process."""

from contextlib import suppress

from app.news import News, Notify
from app.refusals import Refusal
from app.session.control_link import ControlLink
from app.session.equipment.choice import ClinicChoice
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from app.store.chairs import limits_of
from app.store.database import Database, Transaction
from app.store.log import write_log
from app.store.tables import Clinic


class ClinicLimits(ClinicChoice):
    """The clinic's speed limits: nobody here drives faster, whatever a parameter set or a chair would allow."""

    def __init__(self, database: Database, control: ControlLink, notify: Notify) -> None:
        super().__init__(database, control, notify)
        self.speeds = HIGHEST_SPEEDS

    async def open(self) -> None:
        """Load the limits that the owner set last."""
        await self._in_clinic(self._read)
        with suppress(Refusal):
            await self._load(self.speeds)

    async def set(self, speeds: Speeds, person: str) -> None:
        """Set other limits; a higher one is refused while the chair moves, and then nothing changes."""
        await self._load(speeds)
        before, self.speeds = self.speeds, speeds

        def _write(db: Transaction, clinic: Clinic) -> None:
            clinic.limits = speeds.model_dump(mode="json")
            write_log(db, person, "limits set", before=before.model_dump(), now=speeds.model_dump())

        await self._in_clinic(_write)
        self._notify(News(what="controls"))

    async def _load(self, speeds: Speeds) -> None:
        await self._control.load("limits", clinic=speeds.model_dump(mode="json"))

    def _read(self, _db: Transaction, clinic: Clinic) -> None:
        self.speeds = limits_of(clinic)
