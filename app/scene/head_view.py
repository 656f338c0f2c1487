"""The direction in which the patient's eye looks from the chair, from the head tracker's angles, without jumps."""

import math
from typing import Final, NamedTuple

LOST_AFTER: Final = 0.5  # s; an older head pose counts as lost
EASE_TIME: Final = 1.0  # s for returning to straight ahead after a loss, and to the head's angles after its return
JUMP: Final = 0.5  # rad from one step to the next; a larger change is no movement, and is eased
FASTEST_TURN: Final = 8.0  # rad/s, about the fastest turn of a head
MOST_YAW: Final = math.radians(100)
MOST_PITCH: Final = math.radians(60)
MOST_ROLL: Final = math.radians(60)


class Angles(NamedTuple):
    """The angles of a head from straight ahead, in rad."""

    yaw: float  # left positive
    pitch: float  # up positive
    roll: float  # towards the right shoulder positive


AHEAD: Final = Angles(0.0, 0.0, 0.0)
NO_HEAD: Final = Angles(math.nan, math.nan, math.nan)
LIMITS: Final = Angles(MOST_YAW, MOST_PITCH, MOST_ROLL)


class HeadView:
    """Follows a head's angles without lag while they are known, and eases over losses, returns and jumps.

    The shown angles are the head's angles plus an offset that fades to 0. When the head's angles are lost, return or
    jump, the offset is changed by the opposite amount, so that the shown angles do not change at that moment.

    Attributes
    ----------
    roll_share : float
        Share of the head's roll that is shown, 0..1: a tilting picture makes some people sick.
    shown : Angles
        The angles returned by the last step.
    """

    __slots__ = ("_goal", "_offset", "_since", "_was_known", "roll_share", "shown")

    def __init__(self, roll_share: float = 0.0) -> None:
        self.roll_share = roll_share
        self.shown = AHEAD
        self._goal = AHEAD
        self._offset = AHEAD
        self._since = EASE_TIME  # s since the offset was set
        self._was_known = False

    def step(self, dt: float, yaw: float, pitch: float, roll: float, age: float) -> Angles:
        """Return the angles to be shown `dt` (s) after the last step.

        Parameters
        ----------
        dt
            s; a time that is negative or not finite counts as 0.
        yaw, pitch, roll
            The head's angles in rad; an angle that is not finite means that the head is lost.
        age
            Age of the angles in s; NaN means that the head is lost.
        """
        dt = dt if math.isfinite(dt) and dt > 0 else 0.0
        is_known = age <= LOST_AFTER and all(map(math.isfinite, (yaw, pitch, roll)))
        goal = _limited(Angles(_wrapped(yaw), _wrapped(pitch), self.roll_share * _wrapped(roll))) if is_known else AHEAD
        if is_known != self._was_known or max(abs(a - b) for a, b in zip(goal, self._goal, strict=True)) > JUMP:
            self._offset = Angles(*(shown - to for shown, to in zip(self.shown, goal, strict=True)))
            self._since = 0.0
        self._goal, self._was_known = goal, is_known
        self._since = min(self._since + dt, EASE_TIME)
        left = 1.0 - _smooth_step(self._since / EASE_TIME)
        target = _limited(Angles(*(to + left * offset for to, offset in zip(goal, self._offset, strict=True))))
        self.shown = Angles(*(_toward(a, b, FASTEST_TURN * dt) for a, b in zip(self.shown, target, strict=True)))
        return self.shown


def _wrapped(angle: float) -> float:
    """Return an angle (rad) wrapped to -pi..pi."""
    return math.remainder(angle, math.tau)


def _toward(angle: float, target: float, reach: float) -> float:
    """Return `here` moved towards `there` by at most `reach`."""
    return target if abs(target - angle) <= reach else angle + math.copysign(reach, target - angle)


def _limited(angles: Angles) -> Angles:
    return Angles(*(min(max(angle, -most), most) for angle, most in zip(angles, LIMITS, strict=True)))


def _smooth_step(share: float) -> float:
    """Return the smooth step 0..1 of 0..1, with slope 0 at both ends."""
    return share * share * (3.0 - 2.0 * share)
