"""The chair's own stop switch and its battery, as files that a board keeps up to date. Standard library only."""

import math
import os
from pathlib import Path

MOST_BYTES = 32  # of such a file; what stands behind them is not looked at


class Inputs:
    """What the chair knows of itself; a file that is not named is an input that the chair does not have."""

    def __init__(self, stop: Path | None, battery: Path | None) -> None:
        self._stop, self._battery = stop, battery

    @property
    def stop_pressed(self) -> bool:
        """Whether the switch is pressed: everything but a 0 at the beginning is, as a torn wire must be."""
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
    """Return how a file begins; a pipe into which nobody writes is empty, and is not waited for."""
    handle = os.open(file, os.O_RDONLY | os.O_NONBLOCK)
    try:
        return os.read(handle, MOST_BYTES)
    finally:
        os.close(handle)
