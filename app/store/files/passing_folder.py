"""The folders in which imports and exports keep recordings for a while; what a killed one has left goes."""

import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Final, Literal

Use = Literal["import", "export"]
PATTERNS: Final = (".import-*", ".export-*")


@contextmanager
def passing_folder(state: Path, use: Use) -> Iterator[Path]:
    """Make an empty folder in the clinic's folder, yield it, and remove it afterwards.

    A lock tells it from the folder of a killed process: the system releases the lock when the process ends.
    """
    with ExitStack() as stack:
        with _locked(state):
            _remove_left(state)
            name = stack.enter_context(tempfile.TemporaryDirectory(dir=state, prefix=f".{use}-"))
            stack.enter_context(_locked(Path(name)))
        yield Path(name)


def bytes_in(folder: Path) -> int:
    """Return the bytes of all files in a folder, which grow while an export or import goes on."""
    total = 0
    for place, _, files in os.walk(folder):
        for name in files:
            with suppress(FileNotFoundError):  # a part that is packed already
                total += (Path(place) / name).stat().st_size
    return total


def remove_passing_folders(state: Path) -> None:
    """Remove what killed imports and exports have left in the clinic's folder; those that go on keep theirs."""
    with _locked(state):
        _remove_left(state)


def _remove_left(state: Path) -> None:
    for folder in (found for pattern in PATTERNS for found in state.glob(pattern)):
        with suppress(BlockingIOError, FileNotFoundError), _locked(folder, fcntl.LOCK_NB):
            shutil.rmtree(folder)


@contextmanager
def _locked(folder: Path, also: int = 0) -> Iterator[None]:
    opened = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(opened, fcntl.LOCK_EX | also)
        yield
    finally:
        os.close(opened)
