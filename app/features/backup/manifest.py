"""The manifest of a backup: every file with its size and SHA-256, what was left out, and a hash of all of it."""

import json
import re
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from hashlib import sha256
from pathlib import PurePosixPath
from typing import Any, Final

from app.refusals import Refusal
from app.texts import Text

FORMAT: Final = 2
NAME: Final = "manifest.json"
DATABASE: Final = "bodydrive.sqlite"  # the name of the database's copy within a backup
MOST_BYTES: Final = 256 << 20  # of a manifest
HEX: Final = frozenset("0123456789abcdef")
PART_NAME: Final = re.compile(r"[0-9A-Za-z-]*")
DAMAGED: Final = Text("backups-damaged")


@dataclass(frozen=True, slots=True)
class StoredFile:
    """A file of a backup."""

    path: str  # relative to the state folder, with /
    size: int
    sha256: str
    changed: int  # ns since 1970: a file with equal size and time is not copied again
    part: str = ""  # the part that holds it, in a folder of backups; empty: it is in the backup's own file


@dataclass(frozen=True, slots=True)
class Manifest:
    """What a backup holds."""

    made: str  # ISO 8601, UTC
    version: str  # of the program
    rows: dict[str, int]  # of each table of the database
    with_keys: bool  # whether the chairs' keys, the authority's and the signing key are in it
    left_out: tuple[str, ...]  # recordings that were going on
    files: tuple[StoredFile, ...]

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the names of the parts that lie beside the backup."""
        return tuple(dict.fromkeys(file.part for file in self.files if file.part))

    @property
    def size(self) -> int:
        """Return the size of all files."""
        return sum(file.size for file in self.files)

    def encoded(self) -> bytes:
        """Return the manifest as JSON, with the hash of all on its last line."""
        text = json.dumps({"format": FORMAT, **asdict(self)}, sort_keys=True).encode()
        return text + b"\n" + sha256(text).hexdigest().encode() + b"\n"

    @property
    def hash(self) -> str:
        """Return the hash of all: it covers the hash of every file."""
        return self.encoded().splitlines()[-1].decode()


def read_manifest(content: bytes) -> Manifest:
    """Return a manifest; Refusal in one sentence when it was changed, or is of a newer program."""
    text, _, rest = content.partition(b"\n")
    try:
        if rest.decode().strip() != sha256(text).hexdigest():
            raise ValueError
        document = json.loads(text)
        if document.pop("format") != FORMAT:
            raise Refusal(Text("backups-other-version"))
        files = tuple(StoredFile(**file) for file in document.pop("files"))
        left_out = tuple(map(str, document.pop("left_out")))
        manifest = Manifest(**document, left_out=left_out, files=files)
        if not all(map(_is_right, files)):
            raise ValueError
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise Refusal(Text("backups-none")) from error
    return manifest


def _is_right(file: StoredFile) -> bool:
    is_hash = set(file.sha256) <= HEX and len(file.sha256) == 64
    return is_safe(file.path) and is_hash and PART_NAME.fullmatch(file.part) is not None


def is_safe(path: Any) -> bool:
    """Return whether a path of a backup stays within the folder into which it is restored."""
    if not isinstance(path, str) or not path or "\\" in path or "\0" in path:
        return False
    pure = PurePosixPath(path)
    return not pure.is_absolute() and ".." not in pure.parts and str(pure) == path


def left_out_text(left_out: Sequence[str]) -> Text | None:
    """Return in one sentence how many recordings are not in a backup; None when all are."""
    return Text("backups-left-out", recordings=len(left_out)) if left_out else None
