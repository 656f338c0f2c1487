"""The orientation of a tablet or phone, reported by its page."""

import math

from app.clock import Clock
from app.hardware.configs import TabletHeadConfig
from app.messages import ALIVE, HeadPose
from app.texts import Text


class TabletHead:
    """Keeps the newest orientation reported."""

    def __init__(self, _config: TabletHeadConfig, clock: Clock) -> None:
        self._clock = clock
        self._is_open = False
        self._pose: HeadPose | None = None

    def open(self) -> None:
        """Accept reports from now on."""
        self._is_open, self._pose = True, None

    def look(self, yaw: float, pitch: float, roll: float) -> None:
        """Take a reported orientation (rad); ignore one that is not finite."""
        if self._is_open and all(map(math.isfinite, (yaw, pitch, roll))):
            self._pose = HeadPose(self._clock.now(), yaw, pitch, roll)

    def newest(self) -> HeadPose | None:
        """Return the newest pose, None before the first."""
        return self._pose

    def description(self) -> Text:
        """Return the tracker's state in words."""
        if not self._is_open:
            return Text("headdev-tablet-unused")
        if self._pose is None or self._clock.now() - self._pose.t > ALIVE:
            return Text("headdev-tablet-silent")
        return Text("headdev-tablet")

    def close(self) -> None:
        """Accept no more reports."""
        self._is_open, self._pose = False, None
