"""The shirt in use, the simulated body inside it, and the channels that are marked as unused."""

from collections.abc import Iterable
from pathlib import Path
from typing import Literal

from pydantic import ValidationError

from app.arrivals import Arrivals, arrivals_from
from app.hardware.configs import SHIRTS
from app.json_values import JsonDocument
from app.layout import ShirtLayout
from app.news import News, Notify
from app.refusals import Conflict, NotFound, Refusal, Unavailable
from app.session.control_link import ControlLink
from app.session.equipment.choice import ClinicChoice, without_folders
from app.session.equipment.pairing import shirt_key_files
from app.source import UNKNOWN, SourceGroup, source_group
from app.store.database import Database, Transaction
from app.store.tables import Clinic
from app.texts import Text, from_document, text_of

STANDARD_SHIRT: JsonDocument = {
    "kind": "simulator",
    "sample_rate": 100.0,
    "seed": 1,
    "layout": None,
    "dead_channels": [],
}
STANDARD_BODY: JsonDocument = {"kind": "person", "skill": "practised", "seed": 1}
NO_SHIRT = Text("visit-no-shirt")


class Equipment(ClinicChoice):
    """The shirt in use with its simulated body and its unused channels.

    Until somebody has chosen a shirt there is none, except in a demonstration, which starts with the simulated one.
    """

    def __init__(
        self,
        database: Database,
        control: ControlLink,
        files: Path,
        keys: Path,
        notify: Notify,
        *,
        demonstration: bool,
    ) -> None:
        super().__init__(database, control, notify)
        self._files = files
        self._keys = keys
        self.shirt: JsonDocument | None = STANDARD_SHIRT if demonstration else None
        self.body: JsonDocument | None = STANDARD_BODY if demonstration else None
        self.unused: list[str] = []
        self.layout: ShirtLayout | None = None
        self.sample_rate = 0.0
        self.failure: Text | str | None = None  # why there is no shirt, None when there is one
        self.state: Text | str = ""  # of the shirt, in words, as of the last `refresh`
        self.silent = False  # whether there was a shirt then that sent nothing
        self.found: list[str] = []  # names of the sensors that it had found then, and that nobody has placed
        self.arrivals: Arrivals | None = None  # at the shirt, as of the last `refresh`; None: it does not say
        self.mistrust: Text | str | None = NO_SHIRT  # why the shirt arms no real chair, None when it may

    async def open(self) -> None:
        """Open the shirt that was in use last; when it does not open, `failure` says why, and none takes its place."""
        await self._in_clinic(self._read)
        if self.shirt is None:
            self.failure = NO_SHIRT
            return
        try:
            await self._open_shirt(self.shirt)
            if self.body is not None and self.kind == "simulator":
                await self._open_body(self.body)
        except Refusal as refusal:
            self.failure = text_of(refusal)

    @property
    def kind(self) -> str | None:
        """Return the kind of the chosen shirt, None before the first choice."""
        return None if self.shirt is None else str(self.shirt["kind"])

    @property
    def simulated(self) -> bool | None:
        """Return whether nobody wears the chosen shirt, None before the first choice."""
        return None if self.kind is None else SHIRTS[self.kind].simulated

    @property
    def group(self) -> SourceGroup:
        """Return the group of sources that the chosen shirt belongs to, "unknown" before the first choice."""
        return source_group(self.kind or UNKNOWN, self.simulated)

    @property
    def seed(self) -> int | None:
        """Return which simulated shirt is in use, None for any other."""
        return self.shirt.get("seed") if self.shirt is not None and self.kind == "simulator" else None

    @property
    def is_camera(self) -> bool:
        """Return whether the chosen shirt is the camera of a page."""
        return self.kind == "camera"

    def part_of_sensor(self, name: str) -> Text | None:
        """Return the part of the body that a sensor of this name is on, None when it is on none."""
        if self.shirt is None:
            return None
        kind = SHIRTS[str(self.shirt["kind"])]
        return next((kind.title_of(part) for part in kind.fields_of("tracker") if self.shirt.get(part) == name), None)

    @property
    def practice(self) -> str | None:
        """Return the kind of the chosen shirt when nobody wears it: every page then says that this is practice."""
        return self.kind if self.simulated else None

    async def use_shirt(self, config: JsonDocument) -> None:
        """Open another shirt; when it does not open, the one before is opened again and the reason is raised."""
        self.with_paths(config)  # refuse a missing file before the shirt in use is closed
        before, body = self.shirt, self.body
        wanted = (body or STANDARD_BODY) if config["kind"] == "simulator" else None
        try:
            await self._open_shirt(config)
            if wanted is not None:
                await self._open_body(wanted)
        except Unavailable:
            raise  # nothing was opened, and the next control process is given what was open before
        except Refusal:
            self.shirt, self.body, self.layout, self.mistrust = before, body, None, NO_SHIRT
            await self.open()
            raise
        self.body = wanted
        if wanted is None:
            self._control.forget("body")
        if before != config:
            self.unused = []
        await self._store()

    async def refresh(self) -> None:
        """Read the state of the shirt; notify the pages when it falls silent, sends again, or finds other sensors."""
        try:
            shirt = (await self._control.call("status"))["shirt"]
        except Refusal:
            return  # the pages are told of a control process that is being restarted
        before = self.silent, self.found
        self.silent = self.layout is not None and bool(shirt["silent"])
        self.found = list(shirt.get("found") or ())
        self.arrivals = arrivals_from(shirt.get("arrivals"))
        self.state = from_document(shirt["words"])
        if (self.silent, self.found) != before:
            self._notify(News(what="equipment"))

    async def use_body(self, config: JsonDocument) -> None:
        """Choose another simulated body for the simulated shirt."""
        if self.kind != "simulator":
            raise Conflict(Text("drives-no-body"))
        await self._open_body(config)
        self.body = config
        await self._store()

    async def leave_unused(self, channels: list[str]) -> None:
        """Mark channels as unused: the next calibration leaves them out."""
        names = self.layout.channel_names if self.layout else []
        for name in channels:
            if name not in names:
                raise NotFound(Text("visit-no-sensor", name=name))
        self.unused = [name for name in names if name in channels]
        await self._store()

    def needed_layout(self) -> ShirtLayout:
        """Return the layout of the shirt, refusing when there is none."""
        if self.layout is None:
            raise Conflict(self.failure or NO_SHIRT)
        return self.layout

    async def _open_shirt(self, config: JsonDocument) -> None:
        answer = await self._load("shirt", self.with_paths(config))
        try:
            self.layout = ShirtLayout.model_validate(answer["layout"])
        except ValidationError as error:
            raise Conflict(Text("visit-layout-unreadable")) from error
        self.sample_rate = float(answer["sample_rate"])
        self.mistrust = from_document(answer["mistrust"]) if answer["mistrust"] else None
        self.shirt, self.failure = config, None
        await self.refresh()

    async def _open_body(self, config: JsonDocument) -> None:
        await self._load("body", self.with_path(config))

    async def _load(self, do: Literal["shirt", "body"], config: JsonDocument) -> JsonDocument:
        """Open a device in the control process; a refusal names its files as pages do, without their folders."""
        try:
            return await self._control.load(do, config=config)
        except Conflict as refusal:
            raise Conflict(without_folders(text_of(refusal), self._files, self._keys)) from refusal

    @property
    def key_names(self) -> list[str]:
        """Names of the keys of the shirts that are paired."""
        return [file.name for file in shirt_key_files(self._keys)]

    async def use_sender(self, sender: str) -> None:
        """Take another sender (HOST:PORT) as the shirt from now on."""
        await self._control.call("sender", sender=sender)
        self._notify(News(what="equipment"))

    def with_paths(self, config: JsonDocument) -> JsonDocument:
        """Return the configuration of a shirt with the paths of its files and its key in place of their names."""
        kind, complete = SHIRTS[config["kind"]], dict(config)
        for field in kind.fields_of("signal-file"):
            complete[field] = self._path_of_file(str(config[field]))
        for field in kind.fields_of("shirt-key"):
            if config.get(field) is not None:
                keys = shirt_key_files(self._keys)
                complete[field] = _path_of(str(config[field]), keys, "key")
        return complete

    def with_path(self, config: JsonDocument) -> JsonDocument:
        """Return the configuration of a body or a head tracker with the path of its file in place of its name."""
        return {**config, "file": self._path_of_file(str(config["file"]))} if "file" in config else config

    def _path_of_file(self, name: str) -> str:
        """Return the path of a file that people brought, by its name."""
        return _path_of(name, self._files.glob("*"), "file")

    def _read(self, _db: Transaction, clinic: Clinic) -> None:
        if clinic.shirt is not None:
            self.shirt, self.body, self.unused = clinic.shirt, clinic.body, list(clinic.unused)

    async def _store(self) -> None:
        def _write(_db: Transaction, clinic: Clinic) -> None:
            clinic.shirt, clinic.body, clinic.unused = self.shirt, self.body, list(self.unused)

        await self._in_clinic(_write)
        self._notify(News(what="equipment"))


def _path_of(name: str, files: Iterable[Path], kind: Literal["key", "file"]) -> str:
    """Return the path of the file of this name; NotFound, with what to do instead, when there is none."""
    for file in files:
        if file.name == name:
            return str(file)
    raise NotFound(Text("visit-no-file", kind=kind, name=name[:80]))
