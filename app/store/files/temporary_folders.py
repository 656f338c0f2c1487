"""Temporary folders of imports and exports; folders of killed processes are removed."""

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
def temporary_folder(state: Path, use: Use) -> Iterator[Path]:
    """Make an empty folder in the clinic's folder, yield it, and remove it afterwards.

    The folder is locked while it is in use. The system releases the lock when the process ends, so that a folder
    without a lock is one of a killed process.
    """
    with ExitStack() as stack:
        with _locked(state):
            _remove_unlocked(state)
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


def remove_temporary_folders(state: Path) -> None:
    """Remove the temporary folders of killed imports and exports from the clinic's folder."""
    with _locked(state):
        _remove_unlocked(state)


def _remove_unlocked(state: Path) -> None:
    for folder in (folder for pattern in PATTERNS for folder in state.glob(pattern)):
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
