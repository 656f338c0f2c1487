"""The visitor's body: keys, pads or a gamepad set targets for the joints, which follow like limbs."""

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from app.hardware.base import BodyView
from app.hardware.body.joints import ARM_DEGREES_OF_FREEDOM, second_way
from app.texts import Text

THERE_RATE = 11.0  # 1/s: 90 % of the movement in 0.35 s, all in about 0.5 s
BACK_RATE = 6.0  # 1/s: the return to rest is slower
FASTEST_THERE, FASTEST_BACK = 4.0, 2.0  # of the range per second
ASIDE = 0.12  # of the range: movement of a joint's second degree of freedom with the first
LONGEST_STEP = 0.02  # s


class Visitor:
    """A body whose joints follow targets 0..1, critically damped and no faster than a limb."""

    def __init__(self, joints: Sequence[str] = ARM_DEGREES_OF_FREEDOM) -> None:
        self.joints = tuple(joints)
        self._companion = [
            (self.joints.index(name), i)
            for i, joint in enumerate(self.joints)
            if (name := second_way(joint)) is not None and name in self.joints
        ]
        self.reset()

    def reset(self) -> None:
        """Set every joint and target to rest."""
        self._target = [0.0] * len(self.joints)
        self._place = [0.0] * len(self.joints)
        self._speed = [0.0] * len(self.joints)
        self._posture = np.zeros(len(self.joints))

    def move(self, joints: Mapping[str, float]) -> None:
        """Set the targets of joints, 0 (rest) to 1 (full movement); the other joints keep their targets.

        Raises
        ------
        ValueError
            When a joint is not of this body, or a target is not between 0 and 1; nothing changes then.
        """
        for name, place in joints.items():
            if name not in self.joints:
                raise ValueError(Text("bodydev-no-joint", joint=name, joints=", ".join(self.joints)))
            if not 0.0 <= place <= 1.0:  # also refuses NaN
                raise ValueError(Text("bodydev-no-place", joint=name, place=place))
        for name, place in joints.items():
            self._target[self.joints.index(name)] = float(place)

    def step(self, dt: float, _view: BodyView) -> NDArray[np.float64]:
        """Advance by `dt` (s) and return the posture (n_joints,)."""
        count = max(1, math.ceil(dt / LONGEST_STEP))
        for i, target in enumerate(self._target):
            for _ in range(count):
                self._approach(i, target, dt / count)
            self._posture[i] = self._place[i]
        for second, first in self._companion:
            self._posture[second] += ASIDE * self._place[first]
        return self._posture

    def _approach(self, i: int, target: float, dt: float) -> None:
        """Advance joint `i` by the exact solution of a critically damped spring with limited speed."""
        off, speed = self._place[i] - target, self._speed[i]
        if off == 0.0 and speed == 0.0:
            return
        rate = THERE_RATE if off < 0.0 else BACK_RATE
        keep = math.exp(-rate * dt)
        pull = speed + rate * off
        place = target + (off + pull * dt) * keep
        speed = (speed - rate * pull * dt) * keep
        most = FASTEST_THERE * dt
        least = -FASTEST_BACK * dt
        way = place - self._place[i]
        if not least <= way <= most:
            way = min(most, max(least, way))
            speed = way / dt
        self._place[i] += way
        self._speed[i] = speed
        if abs(self._place[i] - target) < 1e-5 and abs(speed) < 1e-4:
            self._place[i], self._speed[i] = target, 0.0
