"""How fast a speed may change: within acceleration, deceleration and jerk, and so that no limit is ever passed.

One axis, forwards or turning. The gate bounds with it whatever it is asked, the shaper reaches its targets by it.
"""

import math
from typing import NamedTuple

SLACK = 1e-9  # of a limit: rounding is no violation


class Ramp(NamedTuple):
    """The limits of one axis, all positive: m/s, m/s2, m/s3, or rad."""

    top: float
    bottom: float  # how fast the other way
    acceleration: float  # away from standstill
    deceleration: float  # towards standstill
    jerk: float

    def bounded(self, speed: float, rate: float, asked: float, dt: float) -> float:
        """Return the speed nearest to `asked` that may follow `speed` after `dt` (s).

        `rate` is the change of speed in the step before (m/s2 or rad/s2). What may be done is handed back as it was
        asked, bit for bit. A speed beyond a limit that was lowered meanwhile comes down to it, and never goes up.
        """
        if not dt > 0.0:
            return speed
        if asked == speed and rate == 0.0 and -self.bottom <= speed <= self.top:
            return speed  # most of the time: an even speed, or none
        wanted = (asked - speed) / dt
        low, high = -self._highest(-speed, self.bottom, dt), self._highest(speed, self.top, dt)
        softest, hardest = rate - self.jerk * dt, rate + self.jerk * dt
        permitted = min(hardest, max(softest, min(high, max(low, wanted))))
        is_permitted = abs(permitted - wanted) <= SLACK * self.acceleration
        following = asked if is_permitted else speed + permitted * dt
        return min(max(self.top, speed), max(min(-self.bottom, speed), following))

    def towards(self, speed: float, rate: float, target: float, dt: float) -> float:
        """Return the speed that follows `speed` on the way to `target`, which is reached without passing it."""
        if not dt > 0.0:
            return speed
        away = target - speed
        change = self.jerk * dt
        if abs(away) <= change * dt and abs(away / dt - rate) <= change:
            return target  # from here one step leads there, and the next one can rest
        limit = self.acceleration if abs(target) > abs(speed) else self.deceleration
        wanted = min(limit, max(-limit, reach(away, self.jerk, dt)))
        return speed + min(rate + change, max(rate - change, wanted)) * dt

    def _highest(self, speed: float, top: float, dt: float) -> float:
        """Return the largest rate that may be taken at `speed`; the smallest follows by looking from the other side."""
        within = max(-self.deceleration, reach(top - speed, self.jerk, dt))
        if speed >= 0.0:
            return min(self.acceleration, within)
        # Slowing down from a backward speed: on passing standstill it becomes speeding up, with that limit.
        crossing = reach(self.acceleration * self.acceleration / (2.0 * self.jerk) - speed, self.jerk, dt)
        return min(self.deceleration, max(self.acceleration, crossing), within)


def reach(headroom: float, jerk: float, dt: float) -> float:
    """Return the largest rate that can be taken for one step and then fall to 0 within `headroom` of speed.

    A rate r adds r dt in this step, and while it falls at `jerk` at most r^2 / (2 jerk) more, however wide the later
    steps are: their sum lies below the falling line. A negative headroom gives the rate that leads back.
    """
    rate = jerk * (math.sqrt(dt * dt + 2.0 * abs(headroom) / jerk) - dt)
    return rate if headroom >= 0.0 else -rate
