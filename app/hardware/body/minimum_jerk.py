"""The reaching movement with the least jerk (Flash and Hogan, J Neurosci 5, 1985)."""

# Compiled in a wheel (hatch_build.py).


def minimum_jerk(phase: float) -> float:
    """Return the share of the way (0..1) covered after the share `phase` of the time; 0 before, 1 after."""
    if phase <= 0.0:
        return 0.0
    if phase >= 1.0:
        return 1.0
    return phase * phase * phase * (10.0 - 15.0 * phase + 6.0 * phase * phase)


class Reach:
    """A movement of a joint from its present position and speed to a standstill at `target`.

    The quintic polynomial with the given position and velocity and zero acceleration at the start, and zero velocity
    and acceleration at the end; from a standstill it equals `minimum_jerk`.
    """

    __slots__ = ("_a", "_duration", "_start", "_v0", "target")

    def __init__(self, start: float, velocity: float, target: float, duration: float) -> None:
        """Plan it: `velocity` per second, `duration` in s, above 0."""
        self.target = target
        self._start = start
        self._duration = duration
        self._v0 = velocity * duration
        way = target - start
        self._a = (10 * way - 6 * self._v0, -15 * way + 8 * self._v0, 6 * way - 3 * self._v0)

    def at(self, elapsed: float) -> float:
        """Return the position `elapsed` seconds after the start."""
        s = elapsed / self._duration
        if s <= 0.0:
            return self._start
        if s >= 1.0:
            return self.target
        a3, a4, a5 = self._a
        return self._start + s * (self._v0 + s * s * (a3 + s * (a4 + s * a5)))

    def is_over(self, elapsed: float) -> bool:
        """Return whether the target is reached `elapsed` seconds after the start."""
        return elapsed >= self._duration
