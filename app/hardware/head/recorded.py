"""A head that repeats a recorded movement."""

import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.clock import Clock
from app.hardware.base import HardwareError
from app.hardware.configs import RecordedHeadConfig
from app.messages import HeadPose
from app.signals.timed_table import read_timed
from app.texts import Text, text_of

COLUMNS = ("yaw_deg", "pitch_deg", "roll_deg")  # left, up and right positive
BLEND = 1.0  # s from the end of a looped recording to its beginning
SHORTEST = 2.0  # s of recording


class RecordedHead:
    """Plays `t, yaw_deg, pitch_deg, roll_deg` (s, degrees), once or in a loop."""

    def __init__(self, config: RecordedHeadConfig, clock: Clock) -> None:
        self._config = config
        self._clock = clock
        self._began: float | None = None
        self._t: NDArray[np.float64] = np.empty(0)
        self._angles: NDArray[np.float64] = np.empty((0, 3))

    def open(self) -> None:
        """Read the file; HardwareError when it cannot be read or holds no head movement."""
        self._t, self._angles = _read(Path(self._config.file))
        if self._config.loop:
            self._t, self._angles = _looped(self._t, self._angles)
        self._began = self._clock.now()

    def newest(self) -> HeadPose | None:
        """Return the pose at this moment; after the end without a loop, the last pose with its time."""
        if self._began is None:
            return None
        now = self._clock.now()
        played, duration = now - self._began, float(self._t[-1])
        if played > duration:
            if not self._config.loop:
                return HeadPose(self._began + duration, *map(float, self._angles[-1]))
            played %= duration
        return HeadPose(now, *(float(np.interp(played, self._t, self._angles[:, axis])) for axis in range(3)))

    def description(self) -> Text:
        """Return the tracker's state in words."""
        name = Path(self._config.file).name
        return (
            Text("headdev-recorded-rests", file=name)
            if self._began is None
            else Text("headdev-recorded-plays", file=name)
        )

    def close(self) -> None:
        """End the playback."""
        self._began = None


def _read(file: Path) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return times from 0 (n,) s and angles (n, 3) rad."""
    try:
        t, table = read_timed(file, COLUMNS)
        angles = np.radians(np.column_stack([table.numbers(name) for name in COLUMNS]))
    except ValueError as error:
        raise HardwareError(text_of(error)) from error
    if len(t) < 2 or np.any(np.diff(t) <= 0) or t[-1] - t[0] < SHORTEST:
        raise HardwareError(Text("headdev-recorded-short", file=str(file), least=SHORTEST))
    angles = np.unwrap(angles, axis=0)
    return t - t[0], angles


def _looped(t: NDArray[np.float64], angles: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the recording with its first pose appended, the shortest way round from its last."""
    turns = np.round((angles[-1] - angles[0]) / math.tau) * math.tau
    return np.append(t, t[-1] + BLEND), np.vstack([angles, angles[0] + turns])
