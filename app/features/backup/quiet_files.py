"""Read and write files so that a chair that drives meanwhile does not notice: with rests, and little page cache.

Written bytes go to the disk in small parts: a large part would delay the recorder, which waits for its own bytes.
"""

import os
from collections.abc import Iterator
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from typing import Final, Protocol

from app.clock import MonotonicClock
from app.file_modes import OWNER_FILE, OWNER_FOLDER
from app.files import sync_folder

PART: Final = 1 << 16  # bytes read or written at once: the system call is short, and a core is free again soon
SYNC_EVERY: Final = 8 << 20  # bytes
WORKING: Final = 0.3  # share of the time
SPELL: Final = 0.002  # s of work between two rests, at least


class Writer(Protocol):
    """Something that bytes are written to, one part after the other."""

    def write(self, part: bytes, /) -> int:
        """Write bytes and return how many."""
        ...


class Reader(Protocol):
    """Something that bytes are read from, one part after the other."""

    def read(self, size: int, /) -> bytes:
        """Return the next bytes, `size` at most, none at the end."""
        ...


class QuietReader:
    """Reads a file at its leisure, and lets the system forget its pages.

    Between two reads it sleeps, so that all that is done with the bytes takes `WORKING` of the time.
    """

    def __init__(self, file: Path) -> None:
        self._file = file.open("rb", buffering=0)
        self._forgotten = 0
        self._clock = MonotonicClock()
        self._rested = self._clock.now()

    def read(self, size: int, /) -> bytes:
        """Return the next bytes."""
        now = self._clock.now()
        if now - self._rested >= SPELL:
            self._clock.sleep_until(now + (now - self._rested) * (1 / WORKING - 1))
            self._rested = self._clock.now()
        part = self._file.read(size)
        at = self._file.tell()
        if at - self._forgotten >= SYNC_EVERY or not part:
            _forget_pages(self._file.fileno(), self._forgotten, at - self._forgotten)
            self._forgotten = at
        return part

    def size(self) -> int:
        """Return how many bytes the file has now."""
        return os.fstat(self._file.fileno()).st_size

    def __enter__(self) -> "QuietReader":
        """Return the reader."""
        return self

    def __exit__(self, *_error: object) -> None:
        """Close the file."""
        self._file.close()


class QuietWriter:
    """Writes a file in parts that are on the disk before the next; it has its name only when `keep` was called."""

    def __init__(self, target: Path) -> None:
        self._target = target
        self._part = target.with_name(f".{target.name}.part")
        for folder in reversed([each for each in target.parents if not each.exists()]):
            folder.mkdir(mode=OWNER_FOLDER, exist_ok=True)  # `parents=True` would give the outer ones other rights
        descriptor = os.open(self._part, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, OWNER_FILE)
        self._file = os.fdopen(descriptor, "wb", buffering=0)
        self._synced = self._at = 0

    def write(self, part: bytes, /) -> int:
        """Write bytes; raise OSError when there is no room."""
        rest = memoryview(part)
        while rest:
            rest = rest[self._file.write(rest[:PART]) :]
        self._at += len(part)
        if self._at - self._synced >= SYNC_EVERY:
            self._sync()
        return len(part)

    @property
    def written(self) -> int:
        """How many bytes were written."""
        return self._at

    def overwrite(self, at: int, part: bytes) -> None:
        """Write other bytes in place of those at `at`."""
        self._file.seek(at)
        self._file.write(part)
        self._file.seek(self._at)

    def keep(self) -> None:
        """Give the file its name; it is on the disk then."""
        self._sync()
        self._file.close()
        self._part.replace(self._target)
        sync_folder(self._target.parent)

    def __enter__(self) -> "QuietWriter":
        """Return the writer."""
        return self

    def __exit__(self, *_error: object) -> None:
        """Close the file, and remove it when it was not kept."""
        self._file.close()
        self._part.unlink(missing_ok=True)

    def _sync(self) -> None:
        os.fsync(self._file.fileno())
        _forget_pages(self._file.fileno(), self._synced, self._at - self._synced)
        self._synced = self._at


def parts_of(reader: Reader) -> Iterator[bytes]:
    """Yield all bytes of a reader in parts."""
    while part := reader.read(PART):
        yield part


def copy_hashed(reader: Reader, writer: Writer) -> tuple[int, str]:
    """Copy all bytes; return their number and their SHA-256 (hexadecimal)."""
    digest, size = sha256(), 0
    for part in parts_of(reader):
        digest.update(part)
        writer.write(part)
        size += len(part)
    return size, digest.hexdigest()


def hash_of(reader: Reader) -> tuple[int, str]:
    """Read all bytes; return their number and their SHA-256 (hexadecimal)."""
    digest, size = sha256(), 0
    for part in parts_of(reader):
        digest.update(part)
        size += len(part)
    return size, digest.hexdigest()


def _forget_pages(descriptor: int, start: int, size: int) -> None:
    if hasattr(os, "posix_fadvise"):
        with suppress(OSError):  # an advice only
            os.posix_fadvise(descriptor, start, size, os.POSIX_FADV_DONTNEED)
