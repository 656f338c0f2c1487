"""The manifest of a backup: every file with its size and SHA-256, what was left out, and a hash of all of it."""

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from hashlib import sha256
from pathlib import PurePosixPath
from typing import Any, Final

from app.refusals import Refusal

FORMAT: Final = 1
NAME: Final = "manifest.json"
DATABASE: Final = "bodydrive.sqlite"  # the name of the database's copy within a backup
MOST_BYTES: Final = 256 << 20  # of a manifest
HEX = frozenset("0123456789abcdef")


@dataclass(frozen=True, slots=True)
class StoredFile:
    """A file of a backup."""

    path: str  # relative to the state folder, with /
    size: int
    sha256: str
    changed: int  # ns since 1970: a file with equal size and time is not hashed again


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
            raise Refusal("This backup was made by a newer bodydrive: restore it with that version.")
        files = tuple(StoredFile(**file) for file in document.pop("files"))
        left_out = tuple(map(str, document.pop("left_out")))
        manifest = Manifest(**document, left_out=left_out, files=files)
        if not all(is_safe(file.path) and set(file.sha256) <= HEX and len(file.sha256) == 64 for file in files):
            raise ValueError
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise Refusal("This is no backup of bodydrive, or it was changed: take another one.") from error
    return manifest


def is_safe(path: Any) -> bool:
    """Return whether a path of a backup stays within the folder into which it is restored."""
    if not isinstance(path, str) or not path or "\\" in path or "\0" in path:
        return False
    pure = PurePosixPath(path)
    return not pure.is_absolute() and ".." not in pure.parts and str(pure) == path


def left_out_words(left_out: Sequence[str]) -> str:
    """Return in one sentence which recordings are not in a backup; empty when all are."""
    if not left_out:
        return ""
    many = "One recording was" if len(left_out) == 1 else f"{len(left_out)} recordings were"
    return f"{many} going on and left out: the next backup holds them."
