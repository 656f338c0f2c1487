"""Files that a person replaced by another one: kept for 30 days, and restored on request."""

import os
import shutil
from datetime import datetime, timedelta
from pathlib import Path
from threading import RLock
from typing import Final, Literal, NamedTuple, get_args

from app.clock import utc_now
from app.files import write_atomically
from app.refusals import NotFound
from app.settings import Settings
from app.store.files.taken_names import SameName, free_name, name_for

KEPT_FOR: Final = timedelta(days=30)
STAMP: Final = "%Y%m%dT%H%M%S.%fZ"  # UTC, ISO 8601
BETWEEN: Final = "--"  # stands between the time of the replacement and the name

Kind = Literal["file", "model", "floorplan"]
KINDS: Final[tuple[Kind, ...]] = get_args(Kind)


class ReplacedFile(NamedTuple):
    """One file that was replaced; `id` is its name on the shelf."""

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
    """Stores files by kind, each kind in a folder of its own, and keeps what they replace on a shelf."""

    def __init__(self, shelf: Path, folders: dict[Kind, Path]) -> None:
        self._shelf = shelf
        self._folders = folders
        self.lock = RLock()  # two people may bring a file at the same moment; there is one web process

    def check_name(self, kind: Kind, name: str, same_name: SameName) -> None:
        """Raise NameTaken when `put` would, before the work that its content needs."""
        self._name_for(kind, name, same_name)

    def put(self, kind: Kind, name: str, content: bytes, same_name: SameName) -> str:
        """Store a file, whole or not at all, and return the name that it has now; NameTaken when nobody chose."""
        folder = self._folders[kind]
        with self.lock:
            now = self._name_for(kind, name, same_name)
            self.keep(kind, folder / now)
            write_atomically(folder / now, content)
        return now

    def keep(self, kind: Kind, file: Path) -> None:
        """Put a file on the shelf as well, before another is written in its place; without a file, do nothing."""
        if not file.exists():
            return
        self.purge()
        shelf = self._shelf / kind
        shelf.mkdir(parents=True, exist_ok=True)
        place = shelf / f"{utc_now().strftime(STAMP)}{BETWEEN}{file.name}"
        try:
            os.link(file, place)
        except OSError:  # a disk without links
            shutil.copy2(file, place)

    def listed(self) -> list[ReplacedFile]:
        """Return what can be put back, newest first."""
        self.purge()
        return sorted(self._all(), key=lambda one: one.id, reverse=True)

    def content(self, kind: Kind, identity: str) -> tuple[ReplacedFile, bytes]:
        """Return a file of the shelf; NotFound when it is not there, or no longer."""
        for one in self._all():
            if (one.kind, one.id) == (kind, identity):
                return one, (self._shelf / kind / identity).read_bytes()
        raise NotFound("There is no such replaced file, or its 30 days are over: look at the list.")

    def restore(self, kind: Kind, identity: str) -> str:
        """Put a file back, under a free name when its own is taken, and return the name."""
        with self.lock:
            found, content = self.content(kind, identity)
            taken = [file.name for file in self._folders[kind].glob("*")]
            free = found.name.lower() not in map(str.lower, taken)
            name = self.put(kind, found.name if free else free_name(found.name, taken), content, "ask")
            self.drop(found)
        return name

    def drop(self, one: ReplacedFile) -> None:
        """Take a file off the shelf."""
        (self._shelf / one.kind / one.id).unlink(missing_ok=True)

    def purge(self) -> None:
        """Remove for good what was replaced 30 days ago."""
        for one in self._all():
            if one.until <= utc_now():
                self.drop(one)

    def _name_for(self, kind: Kind, name: str, same_name: SameName) -> str:
        taken = {file.name: file for file in self._folders[kind].glob("*")}
        standing = next((file for one, file in taken.items() if one.lower() == name.lower()), None)
        # A folder is a recording of this program: none that is brought takes its place.
        return name_for(name, taken, same_name, may_replace=standing is None or standing.is_file())

    def _all(self) -> list[ReplacedFile]:
        return [
            ReplacedFile(kind, file.name, name, file.stat().st_size, _time_of(stamp))
            for kind in KINDS
            for file in (self._shelf / kind).glob(f"*{BETWEEN}*")
            for stamp, _, name in [file.name.partition(BETWEEN)]
        ]


def replaced_files(settings: Settings) -> ReplacedFiles:
    """Return where a clinic's files lie, and the shelf beside them; what is too old is removed at once."""
    folders: dict[Kind, Path] = {"file": settings.files, "model": settings.models, "floorplan": settings.floorplans}
    found = ReplacedFiles(settings.replaced, folders)
    found.purge()
    return found


def _time_of(stamp: str) -> datetime:
    return datetime.fromisoformat(stamp)
