"""The chair's own stop switch and its battery, as files that a board keeps up to date. Standard library only."""

import math
import os
from pathlib import Path

MOST_BYTES = 32  # read of such a file


class Inputs:
    """The inputs of a chair; None in place of a file: the chair does not have this input."""

    def __init__(self, stop: Path | None, battery: Path | None) -> None:
        self._stop, self._battery = stop, battery

    @property
    def stop_pressed(self) -> bool:
        """Whether the switch is pressed: any content that does not begin with 0 is, so that a torn wire is too."""
        if self._stop is None:
            return False
        try:
            return not _content(self._stop).startswith(b"0")
        except OSError:
            return True

    @property
    def battery(self) -> float:
        """Charge, 0..1, NaN when unknown."""
        if self._battery is None:
            return math.nan
        try:
            charge = float(_content(self._battery))
        except (OSError, ValueError):
            return math.nan
        return charge if 0.0 <= charge <= 1.0 else math.nan


def _content(file: Path) -> bytes:
    """Return the first bytes of a file; a pipe without a writer counts as empty and does not block."""
    handle = os.open(file, os.O_RDONLY | os.O_NONBLOCK)
    try:
        return os.read(handle, MOST_BYTES)
    finally:
        os.close(handle)
