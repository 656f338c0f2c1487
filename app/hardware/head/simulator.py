"""A simulated head that looks around slowly and smoothly."""

import math
import random

from app.clock import Clock
from app.hardware.configs import SimulatedHeadConfig
from app.messages import HeadPose
from app.texts import Text

WAVES = {
    "yaw": (0.5, 0.3),
    "pitch": (0.12, 0.25),
    "roll": (0.06, 0.2),
}  # largest angle (rad), typical frequency (Hz)


class SimulatedHead:
    """Looks left and right, a little up and down: sums of two slow waves. The seed determines the movement."""

    def __init__(self, config: SimulatedHeadConfig, clock: Clock) -> None:
        rng = random.Random(config.seed)
        self._clock = clock
        self._began: float | None = None
        self._waves = {
            name: [(most / 2, about * rng.uniform(0.5, 1.0), rng.uniform(0, math.tau)) for _ in range(2)]
            for name, (most, about) in WAVES.items()
        }

    def open(self) -> None:
        """Begin the movement."""
        self._began = self._clock.now()

    def newest(self) -> HeadPose | None:
        """Return the pose at this moment, None while the tracker is not open."""
        if self._began is None:
            return None
        now = self._clock.now()
        return HeadPose(now, *(self._angle(name, now - self._began) for name in WAVES))

    def description(self) -> Text:
        """Return the tracker's state in words."""
        return Text("headdev-simulated-rests") if self._began is None else Text("headdev-simulated-looks")

    def close(self) -> None:
        """End the movement."""
        self._began = None

    def _angle(self, name: str, t: float) -> float:
        # The movement grows from straight ahead, so that it begins without a jump.
        grown = 1.0 - math.exp(-t)
        return grown * sum(size * math.sin(math.tau * rate * t + phase) for size, rate, phase in self._waves[name])
