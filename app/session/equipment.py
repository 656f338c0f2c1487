"""The shirt in use, what moves inside it when it is simulated, and which of its channels are left alone."""

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

from pydantic import ValidationError

from app.layout import ShirtLayout
from app.session.control import Control
from app.session.database import Database
from app.session.refusals import Conflict, NotFound, Refusal, Unavailable
from app.session.store_people import the_clinic

STANDARD_SHIRT: dict[str, Any] = {
    "kind": "simulator",
    "sample_rate": 100.0,
    "seed": 1,
    "layout": None,
    "dead_channels": [],
}
STANDARD_BODY: dict[str, Any] = {"kind": "person", "skill": "practised", "seed": 1}


class Equipment:
    """What is connected; chosen by people, kept in the database, opened by the control process."""

    def __init__(self, database: Database, control: Control, files: Path, tell: Callable[[str], None]) -> None:
        self._database = database
        self._control = control
        self._files = files
        self._tell = tell
        self.shirt: dict[str, Any] = STANDARD_SHIRT
        self.body: dict[str, Any] | None = STANDARD_BODY
        self.unused: list[str] = []
        self.layout: ShirtLayout | None = None
        self.sample_rate = 0.0
        self.words = ""  # why there is no shirt, empty when there is one

    async def open(self) -> None:
        """Open what was in use last; what does not open is said in words, and nothing takes its place."""
        await asyncio.to_thread(self._read)
        try:
            await self._open_shirt(self.shirt)
            if self.body is not None and self.shirt["kind"] == "simulator":
                await self._open_body(self.body)
        except Refusal as refusal:
            self.words = str(refusal)

    async def use_shirt(self, config: dict[str, Any]) -> None:
        """Open another shirt; when it does not open, the one before is opened again and the reason is raised."""
        self.located(config)  # a file that is not here is refused before the shirt in use is closed
        before, body = self.shirt, self.body
        wanted = (body or STANDARD_BODY) if config["kind"] == "simulator" else None
        try:
            await self._open_shirt(config)
            if wanted is not None:
                await self._open_body(wanted)
        except Unavailable:
            raise  # nothing was opened, and the next control process is given what was open before
        except Refusal:
            self.shirt, self.body, self.layout = before, body, None
            await self.open()
            raise
        self.body = wanted
        if wanted is None:
            self._control.forget("body")
        if before != config:
            self.unused = []
        await self._keep()

    async def use_body(self, config: dict[str, Any]) -> None:
        """Let somebody else move inside the simulated shirt."""
        if self.shirt["kind"] != "simulator":
            raise Conflict("Only the simulated shirt has a body to choose: choose the simulated shirt first.")
        await self._open_body(config)
        self.body = config
        await self._keep()

    async def leave_unused(self, channels: list[str]) -> None:
        """Mark channels as unused: the next calibration leaves them out."""
        known = self.layout.channel_names if self.layout else []
        for name in channels:
            if name not in known:
                raise NotFound(f"This shirt has no channel '{name}': choose one of its lamps.")
        self.unused = [name for name in known if name in channels]
        await self._keep()

    def needed_layout(self) -> ShirtLayout:
        """Return the layout of the shirt, refusing when there is none."""
        if self.layout is None:
            raise Conflict(self.words or "There is no shirt: choose one on the Shirt page.")
        return self.layout

    async def _open_shirt(self, config: dict[str, Any]) -> None:
        answer = await self._load("shirt", config)
        try:
            self.layout = ShirtLayout.model_validate(answer["layout"])
        except ValidationError as error:
            raise Conflict("The shirt's layout cannot be read: choose another shirt.") from error
        self.sample_rate = float(answer["sample_rate"])
        self.shirt, self.words = config, ""

    async def _open_body(self, config: dict[str, Any]) -> None:
        await self._load("body", config)

    async def _load(self, do: Literal["shirt", "body"], config: dict[str, Any]) -> dict[str, Any]:
        try:
            return await self._control.load(do, config=self.located(config))
        except Conflict as refusal:  # a page knows files by their names, not by their places on this machine
            raise Conflict(str(refusal).replace(f"{self._files}/", "")) from refusal

    def located(self, config: dict[str, Any]) -> dict[str, Any]:
        """Return the configuration with the file's place instead of its name."""
        if "file" not in config:
            return config
        name = str(config["file"])
        for file in self._files.glob("*"):
            if file.name == name:
                return {**config, "file": str(file)}
        raise NotFound(f"There is no file '{name[:80]}' here: bring it with 'Add a file' first.")

    def _read(self) -> None:
        with self._database.transaction() as db:
            clinic = the_clinic(db)
            if clinic is not None and clinic.shirt is not None:
                self.shirt, self.body, self.unused = clinic.shirt, clinic.body, list(clinic.unused)

    async def _keep(self) -> None:
        def _write() -> None:
            with self._database.transaction() as db:
                clinic = the_clinic(db)
                if clinic is not None:
                    clinic.shirt, clinic.body, clinic.unused = self.shirt, self.body, list(self.unused)

        await asyncio.to_thread(_write)
        self._tell("equipment")
