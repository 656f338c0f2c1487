"""The head tracker in use: chosen by people, kept in the database, opened by the control process."""

import asyncio
from collections.abc import Callable
from typing import Any

from app.refusals import Refusal, Unavailable
from app.session.control_link import ControlLink
from app.store.database import Database
from app.store.people import the_clinic

Located = Callable[[dict[str, Any]], dict[str, Any]]
"""A configuration with a file's name in it: the same with its place."""


class HeadChoice:
    """Which head tracker looks; None: straight ahead."""

    def __init__(self, database: Database, control: ControlLink, located: Located, tell: Callable[[str], None]) -> None:
        self._database = database
        self._control = control
        self._located = located
        self._tell = tell
        self.config: dict[str, Any] | None = None
        self.words = ""  # why the chosen one does not look, empty when nothing is known against it

    async def open(self) -> None:
        """Open what was in use last; what does not open is said in words, and nothing takes its place."""
        self.config = await asyncio.to_thread(self._read)
        if self.config is not None:
            try:
                await self._control.load("head", config=self._located(self.config))
            except Refusal as refusal:
                self.words = str(refusal)

    async def use(self, config: dict[str, Any] | None) -> None:
        """Look with another tracker, or with none; when it does not open, there is none, and the reason is raised."""
        try:
            await self._control.load("head", config=None if config is None else self._located(config))
        except Unavailable:
            raise  # the next control process is given what was open before
        except Refusal:
            self._control.forget("head")
            await self._keep(None)
            raise
        await self._keep(config)

    async def set_ahead(self) -> None:
        """Count where the head looks now as straight ahead."""
        await self._control.call("head_ahead")

    def _read(self) -> dict[str, Any] | None:
        with self._database.transaction() as db:
            clinic = the_clinic(db)
            return None if clinic is None else clinic.head

    async def _keep(self, config: dict[str, Any] | None) -> None:
        def _write() -> None:
            with self._database.transaction() as db:
                clinic = the_clinic(db)
                if clinic is not None:
                    clinic.head = config

        self.config, self.words = config, ""
        await asyncio.to_thread(_write)
        self._tell("equipment")
