"""The folder in which an import unpacks recordings, and the removal of what a killed import has left."""

import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Final

PREFIX: Final = ".import-"


@contextmanager
def import_folder(state: Path) -> Iterator[Path]:
    """Make an empty folder for one import in the clinic's folder, yield it, and remove it afterwards.

    A lock tells it from the folder of a killed import: the system releases the lock when the process ends.
    """
    with ExitStack() as stack:
        with _locked(state):
            _remove_left(state)
            name = stack.enter_context(tempfile.TemporaryDirectory(dir=state, prefix=PREFIX))
            stack.enter_context(_locked(Path(name)))
        yield Path(name)


def remove_left_imports(state: Path) -> None:
    """Remove the recordings that killed imports have unpacked in the clinic's folder; imports that go on stay."""
    with _locked(state):
        _remove_left(state)


def _remove_left(state: Path) -> None:
    for folder in state.glob(f"{PREFIX}*"):
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
