"""The ramp of one axis: how fast a speed may change within acceleration, deceleration, jerk and the speed limits.

The gate limits every requested twist with ramps; the shaper reaches its target speeds with them.
"""

# Compiled in a wheel (hatch_build.py).

import math
from dataclasses import dataclass
from typing import Final

SLACK: Final = 1e-9  # of a limit: a rounding error is no violation


@dataclass(frozen=True, slots=True)
class Ramp:
    """The limits of one axis, all positive: m/s, m/s2, m/s3, or rad."""

    top: float
    bottom: float  # largest speed in the opposite direction
    acceleration: float  # away from standstill
    deceleration: float  # towards standstill
    jerk: float

    def bounded(self, speed: float, rate: float, asked: float, dt: float) -> float:
        """Return the speed nearest to `asked` that may follow `speed` after `dt` (s).

        `rate` is the change of speed in the step before (m/s2 or rad/s2). A permitted speed is returned as it was
        asked, bit for bit. A speed beyond a limit that has been lowered comes down to the limit, and never rises.
        """
        if not dt > 0.0:
            return speed
        if asked == speed and rate == 0.0 and -self.bottom <= speed <= self.top:
            return speed  # the usual case: a constant speed, or standstill
        # Comparisons, because the functions min and max take several times as long.
        wanted = (asked - speed) / dt
        change = self.jerk * dt
        softest, hardest = rate - change, rate + change
        highest, lowest = self.top, -self.bottom
        if not lowest <= speed <= highest:
            low = -self._at_most(math.inf, -speed, self.bottom, dt)
            high = self._at_most(math.inf, speed, self.top, dt)
            permitted = min(high, max(low, wanted))
            highest, lowest = max(highest, speed), min(lowest, speed)
        elif wanted >= 0.0:  # within the limits, the rate 0 is permitted: only one side needs to be looked at
            permitted = self._at_most(wanted, speed, self.top, dt)
        else:
            permitted = -self._at_most(-wanted, -speed, self.bottom, dt)
        if not permitted > softest:
            permitted = softest
        if not permitted < hardest:
            permitted = hardest
        is_permitted = abs(permitted - wanted) <= SLACK * self.acceleration
        following = asked if is_permitted else speed + permitted * dt
        if not following > lowest:
            return lowest
        return following if following < highest else highest

    def towards(self, speed: float, rate: float, target: float, dt: float) -> float:
        """Return the speed that follows `speed` on the way to `target`, without overshoot."""
        if not dt > 0.0:
            return speed
        away = target - speed
        change = self.jerk * dt
        if abs(away) <= change * dt and abs(away / dt - rate) <= change:
            return target  # one step reaches the target, and the rate can be 0 in the next
        limit = self.acceleration if abs(target) > abs(speed) else self.deceleration
        wanted = reach(away, self.jerk, dt)
        if not wanted > -limit:
            wanted = -limit
        elif not wanted < limit:
            wanted = limit
        if not wanted > rate - change:
            wanted = rate - change
        elif not wanted < rate + change:
            wanted = rate + change
        return speed + wanted * dt

    def _at_most(self, wanted: float, speed: float, top: float, dt: float) -> float:
        """Return `wanted`, not negative, or the largest rate permitted at `speed` where that is smaller.

        The smallest rate follows with the signs reversed. A root is computed only where it decides.
        """
        if speed >= 0.0:
            rate = self.acceleration if self.acceleration < wanted else wanted
        else:
            rate = self.deceleration if self.deceleration < wanted else wanted
            if rate > self.acceleration:
                # Slowing down from a backward speed: beyond standstill this is acceleration, with its own limit.
                crossing = self.acceleration * self.acceleration / (2.0 * self.jerk) - speed
                if not is_reached(rate, crossing, self.jerk, dt):
                    rate = min(rate, max(self.acceleration, reach(crossing, self.jerk, dt)))
        if is_reached(rate, top - speed, self.jerk, dt):
            return rate
        return min(rate, max(-self.deceleration, reach(top - speed, self.jerk, dt)))


def reach(headroom: float, jerk: float, dt: float) -> float:
    """Return the largest rate that, held for one step, can then fall to 0 within `headroom` of speed.

    A rate r adds r dt in this step. While it falls at `jerk` it adds at most r^2 / (2 jerk) more, however long the
    later steps are: their sum lies below the falling line. A negative headroom gives a negative rate.
    """
    rate = jerk * (math.sqrt(dt * dt + 2.0 * abs(headroom) / jerk) - dt)
    return rate if headroom >= 0.0 else -rate


def is_reached(rate: float, headroom: float, jerk: float, dt: float) -> bool:
    """Return whether `rate`, not negative, is not above `reach`, to within the rounding error of its root."""
    return (rate * dt + rate * rate / (2.0 * jerk)) * (1.0 + SLACK) <= headroom
