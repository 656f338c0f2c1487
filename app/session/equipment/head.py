"""The head tracker in use: chosen by people, kept in the database, opened by the control process."""

from collections.abc import Callable

from app.json_values import JsonDocument
from app.news import News, Notify
from app.refusals import Refusal, Unavailable
from app.session.control_link import ControlLink
from app.session.equipment.choice import ClinicChoice
from app.store.database import Database, Transaction
from app.store.tables import Clinic
from app.texts import Text, text_of

WithPath = Callable[[JsonDocument], JsonDocument]
"""Return a configuration with the path of its file in place of its name."""


class HeadChoice(ClinicChoice):
    """The head tracker in use; None: the head counts as looking straight ahead."""

    def __init__(self, database: Database, control: ControlLink, with_path: WithPath, notify: Notify) -> None:
        super().__init__(database, control, notify)
        self._with_path = with_path
        self.config: JsonDocument | None = None
        self.failure: Text | str | None = None  # why the chosen one did not open, None when it did

    async def open(self) -> None:
        """Open the tracker that was in use last; when that fails, `failure` says why, and none takes its place."""
        await self._in_clinic(self._read)
        if self.config is not None:
            try:
                await self._control.load("head", config=self._with_path(self.config))
            except Refusal as refusal:
                self.failure = text_of(refusal)

    async def use(self, config: JsonDocument | None) -> None:
        """Use another tracker, or none; when it does not open, none is in use, and the reason is raised."""
        try:
            await self._control.load("head", config=None if config is None else self._with_path(config))
        except Unavailable:
            raise  # the next control process is given what was open before
        except Refusal:
            self._control.forget("head")
            await self._store(None)
            raise
        await self._store(config)

    async def set_ahead(self) -> None:
        """Count where the head looks now as straight ahead."""
        await self._control.call("head_ahead")

    def _read(self, _db: Transaction, clinic: Clinic) -> None:
        self.config = clinic.head

    async def _store(self, config: JsonDocument | None) -> None:
        def _write(_db: Transaction, clinic: Clinic) -> None:
            clinic.head = config

        self.config, self.failure = config, None
        await self._in_clinic(_write)
        self._notify(News(what="equipment"))
