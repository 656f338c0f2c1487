"""Replaced files: kept for 30 days, and restored on request."""

import os
import shutil
from datetime import UTC, datetime, timedelta
from pathlib import Path
from threading import RLock
from typing import Final, Literal, NamedTuple, get_args

from app.clock import utc_now
from app.files import write_atomically
from app.refusals import NotFound
from app.settings import Settings
from app.store.files.name_conflicts import SameName, free_name, name_for
from app.texts import Text

KEPT_FOR: Final = timedelta(days=30)
STAMP: Final = "%Y%m%dT%H%M%S.%fZ"  # UTC, ISO 8601
BETWEEN: Final = "--"  # stands between the time of the replacement and the name
PATIENTS: Final = "patient"  # the folder of the archives of replaced patients, which are imported to restore them

Kind = Literal["file", "model", "floorplan"]
KINDS: Final[tuple[Kind, ...]] = get_args(Kind)


class ReplacedFile(NamedTuple):
    """A replaced file; `id` is its name on the shelf."""

    kind: Kind
    id: str
    name: str
    bytes: int
    replaced: datetime

    @property
    def until(self) -> datetime:
        """Return when it is removed for good."""
        return self.replaced + KEPT_FOR


class ReplacedFiles:
    """Stores files by kind, each kind in its own folder, and puts the files that they replace on a shelf (a folder)."""

    def __init__(self, shelf: Path, folders: dict[Kind, Path]) -> None:
        self._shelf = shelf
        self._folders = folders
        self.lock = RLock()  # two people may upload at the same time, in threads of the one web process

    def check_name(self, kind: Kind, name: str, same_name: SameName) -> None:
        """Raise NameTaken when `put` would raise it; call it before the content is checked, which takes long."""
        self._name_for(kind, name, same_name)

    def put(self, kind: Kind, name: str, content: bytes, same_name: SameName) -> str:
        """Store a file atomically and return its name; NameTaken when the name is taken and nobody chose."""
        folder = self._folders[kind]
        with self.lock:
            now = self._name_for(kind, name, same_name)
            self.shelve(kind, folder / now)
            write_atomically(folder / now, content)
        return now

    def shelve(self, kind: Kind, file: Path) -> None:
        """Put a copy of a file on the shelf, before another replaces it; do nothing when there is no file."""
        if not file.exists():
            return
        shelf = self._shelf / kind
        shelf.mkdir(parents=True, exist_ok=True)
        place = shelf / f"{utc_now().strftime(STAMP)}{BETWEEN}{file.name}"
        try:
            os.link(file, place)
        except OSError:  # a file system without hard links
            shutil.copy2(file, place)

    def listed(self) -> list[ReplacedFile]:
        """Return the replaced files, newest first."""
        return sorted(self._all(), key=lambda file: file.id, reverse=True)

    def content(self, kind: Kind, identity: str) -> tuple[ReplacedFile, bytes]:
        """Return a file of the shelf with its content; NotFound when there is none."""
        for file in self._all():
            if (file.kind, file.id) == (kind, identity):
                return file, (self._shelf / kind / identity).read_bytes()
        raise NotFound(Text("store-no-replaced-file"))

    def restore(self, kind: Kind, identity: str) -> str:
        """Restore a file, under a free name when its own is taken, and return the name."""
        with self.lock:
            file, content = self.content(kind, identity)
            taken = [other.name for other in self._folders[kind].glob("*")]
            free = file.name.lower() not in map(str.lower, taken)
            name = self.put(kind, file.name if free else free_name(file.name, taken), content, "ask")
            self.discard(file)
        return name

    def discard(self, file: ReplacedFile) -> None:
        """Take a file off the shelf."""
        (self._shelf / file.kind / file.id).unlink(missing_ok=True)

    def purge(self, now: datetime) -> None:
        """Remove for good what was replaced 30 days before `now`, the time up to which time has really passed."""
        for file in self._all():
            if file.until <= now:
                self.discard(file)
        for archive in (self._shelf / PATIENTS).glob(f"*{BETWEEN}*"):
            if _time_of(archive.name.partition(BETWEEN)[0]) + KEPT_FOR <= now:
                archive.unlink(missing_ok=True)

    def _name_for(self, kind: Kind, name: str, same_name: SameName) -> str:
        taken = {file.name: file for file in self._folders[kind].glob("*")}
        standing = next((file for other, file in taken.items() if other.lower() == name.lower()), None)
        # A folder is a recording of this program: an uploaded file never replaces it.
        return name_for(name, taken, same_name, may_replace=standing is None or standing.is_file())

    def _all(self) -> list[ReplacedFile]:
        return [
            ReplacedFile(kind, file.name, name, file.stat().st_size, _time_of(stamp))
            for kind in KINDS
            for file in (self._shelf / kind).glob(f"*{BETWEEN}*")
            for stamp, _, name in [file.name.partition(BETWEEN)]
        ]


def archive_on_shelf(replaced: datetime | None, created: datetime) -> str:
    """Return the place of a replaced patient's archive on the shelf; None: a pattern for each time of a replacement.

    The patient is named by the moment at which the first clinic added the patient.
    """
    stamp = "*" if replaced is None else replaced.strftime(STAMP)
    return f"{PATIENTS}/{stamp}{BETWEEN}{created.astimezone(UTC).strftime(STAMP)}.zip"


def replaced_files(settings: Settings) -> ReplacedFiles:
    """Return the stores of a clinic's files with their shelf."""
    folders: dict[Kind, Path] = {"file": settings.files, "model": settings.models, "floorplan": settings.floorplans}
    return ReplacedFiles(settings.replaced, folders)


def _time_of(stamp: str) -> datetime:
    return datetime.fromisoformat(stamp)
