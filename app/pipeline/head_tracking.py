"""The head tracker in use: its newest pose goes into every tick; the loop never waits for it or ends by it."""

import math

from app.clock import Clock
from app.geometry import wrap_angle
from app.hardware.base import HeadTracker
from app.hardware.configs import HeadConfig
from app.hardware.registry import make_head
from app.messages import HeadPose, Tick
from app.pipeline.opening import DeviceChange, close_quietly, one_line, open_device

NO_TRACKER = "No head tracker is connected: the view looks straight ahead."


class HeadTracking:
    """Opens, reads and closes one head tracker at a time."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._tracker: HeadTracker | None = None
        self._ahead = (0.0, 0.0, 0.0)  # yaw, pitch, roll (rad) of the pose that counts as straight ahead
        self._failed = ""
        self.kind = ""

    @property
    def description(self) -> str:
        """The tracker's state in words."""
        return self._failed or (self._tracker.description() if self._tracker else NO_TRACKER)

    def change(self, config: HeadConfig | None) -> DeviceChange:
        """Release the head tracker in use, and return the change that opens another one."""
        before = self._release_tracker()

        def opened() -> HeadTracker | None:
            close_quietly(before)
            return None if config is None else open_device(make_head(config, self._clock))

        def use(tracker: HeadTracker | None) -> None:
            self._tracker, self.kind = tracker, config.kind if config else ""

        return DeviceChange("head tracker", opened, use)

    def close(self) -> None:
        """Close the head tracker in use."""
        close_quietly(self._release_tracker())

    def look(self, yaw: float, pitch: float, roll: float) -> bool:
        """Pass on the orientation (rad) that a tablet reports; False when the tracker in use is no tablet."""
        look = getattr(self._tracker, "look", None)
        if look is not None:
            look(yaw, pitch, roll)
        return look is not None

    def set_ahead(self) -> bool:
        """Make the newest pose straight ahead; False when there is no pose."""
        pose = self._newest()
        if pose is None:
            return False
        self._ahead = pose.yaw, pose.pitch, pose.roll
        return True

    def note(self, tick: Tick, t: float) -> None:
        """Write the newest head pose and its age at `t` (s) into a tick."""
        pose = self._newest()
        if pose is None:
            tick.head_yaw = tick.head_pitch = tick.head_roll = tick.head_age = math.nan
            return
        yaw, pitch, roll = self._ahead
        tick.head_yaw = wrap_angle(pose.yaw - yaw)
        tick.head_pitch, tick.head_roll = wrap_angle(pose.pitch - pitch), wrap_angle(pose.roll - roll)
        tick.head_age = max(0.0, t - pose.t)

    def _release_tracker(self) -> HeadTracker | None:
        """Release the head tracker in use and return it, still open."""
        before, self._tracker = self._tracker, None
        self.kind = self._failed = ""
        self._ahead = (0.0, 0.0, 0.0)
        return before

    def _newest(self) -> HeadPose | None:
        if self._tracker is None:
            return None
        try:
            return self._tracker.newest()
        except Exception as error:  # whatever a device does, the loop turns on
            tracker, self._tracker = self._tracker, None
            self._failed = f"The head tracker failed ({one_line(str(error)) or type(error).__name__}): choose it again."
            close_quietly(tracker)
            return None
