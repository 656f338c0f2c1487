"""A clinic that is made once for all tests of a process, and copied into the folder of each."""

import atexit
import shutil
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

from app.settings import Settings

Make = Callable[[Settings], list[int]]
"""Makes a clinic, and returns the ids of its trials."""


def copied_clinic(make: Make, settings: Settings) -> list[int]:
    """Copy the clinic that `make` makes, and return the ids of its trials."""
    folder, trials = _made(make)
    shutil.copytree(folder, settings.state, dirs_exist_ok=True)
    return list(trials)


@cache
def _made(make: Make) -> tuple[Path, list[int]]:
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder)
    return folder, make(Settings(state=folder))
