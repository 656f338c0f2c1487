"""Where the patient's eye looks from the chair, out of a head tracker's angles: never a jump, never more than asked."""

import math
from typing import Final, NamedTuple

OLD: Final = 0.5  # s; an older head pose says nothing any more
EASE: Final = 1.0  # s for going back to straight ahead, and for taking up a head that comes back
JUMP: Final = 0.5  # rad from one step to the next; more is no movement, and is eased
FASTEST: Final = 8.0  # rad/s, about as fast as a head can turn
MOST_YAW: Final = math.radians(100)
MOST_PITCH: Final = math.radians(60)
MOST_ROLL: Final = math.radians(60)


class Angles(NamedTuple):
    """Where a head looks, from straight ahead, in rad."""

    yaw: float  # left positive
    pitch: float  # up positive
    roll: float  # towards the right shoulder positive


AHEAD: Final = Angles(0.0, 0.0, 0.0)
NO_HEAD: Final = Angles(math.nan, math.nan, math.nan)
LIMITS: Final = Angles(MOST_YAW, MOST_PITCH, MOST_ROLL)


class HeadView:
    """Follows a head without lag as long as it is known, and eases over whatever is not a movement.

    What is shown is the head's angles plus an offset that fades away. A loss, a return or a jump changes the angles
    at once and the offset by the opposite, so that nothing shown changes at that moment.

    Attributes
    ----------
    roll_share : float
        How much of the head's roll is shown, 0..1: a tilting picture makes some people sick.
    shown : Angles
        What was shown last.
    """

    __slots__ = ("_goal", "_offset", "_since", "_was_known", "roll_share", "shown")

    def __init__(self, roll_share: float = 0.0) -> None:
        self.roll_share = roll_share
        self.shown = AHEAD
        self._goal = AHEAD
        self._offset = AHEAD
        self._since = EASE  # s since the offset was taken
        self._was_known = False

    def step(self, dt: float, yaw: float, pitch: float, roll: float, age: float) -> Angles:
        """Return where to look `dt` (s) after the last step.

        Parameters
        ----------
        dt
            A time that is not positive and finite counts as none.
        yaw, pitch, roll
            The head's angles in rad; whatever is not finite is a loss.
        age
            Time since they came, s; NaN is a loss too.
        """
        dt = dt if math.isfinite(dt) and dt > 0 else 0.0
        is_known = age <= OLD and all(map(math.isfinite, (yaw, pitch, roll)))
        goal = _within(Angles(_turn(yaw), _turn(pitch), self.roll_share * _turn(roll))) if is_known else AHEAD
        if is_known != self._was_known or max(abs(a - b) for a, b in zip(goal, self._goal, strict=True)) > JUMP:
            self._offset = Angles(*(shown - to for shown, to in zip(self.shown, goal, strict=True)))
            self._since = 0.0
        self._goal, self._was_known = goal, is_known
        self._since = min(self._since + dt, EASE)
        left = 1.0 - _smooth(self._since / EASE)
        asked = _within(Angles(*(to + left * offset for to, offset in zip(goal, self._offset, strict=True))))
        self.shown = Angles(*(_toward(a, b, FASTEST * dt) for a, b in zip(self.shown, asked, strict=True)))
        return self.shown


def _turn(angle: float) -> float:
    """Return the same direction from -pi to pi."""
    return math.remainder(angle, math.tau)


def _toward(here: float, there: float, reach: float) -> float:
    return there if abs(there - here) <= reach else here + math.copysign(reach, there - here)


def _within(angles: Angles) -> Angles:
    return Angles(*(min(max(angle, -most), most) for angle, most in zip(angles, LIMITS, strict=True)))


def _smooth(share: float) -> float:
    """Return 0..1 for 0..1, beginning and ending at rest."""
    return share * share * (3.0 - 2.0 * share)
