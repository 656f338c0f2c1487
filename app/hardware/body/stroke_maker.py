"""The strokes of a simulated person: which limb moves how far and for how long, with the errors of the person."""

# Compiled in a wheel (hatch_build.py).

import random
from typing import NamedTuple

from app.hardware.body.minimum_jerk import minimum_jerk
from app.hardware.body.person_parameters import PersonParameters

LIMBS = ("right_elbow", "left_elbow", "right_shoulder", "left_shoulder")
OTHER_ELBOW = {"right_elbow": "left_elbow", "left_elbow": "right_elbow"}
"""Both elbows together are the stop gesture, which the simulated driver never makes."""
REUSABLE = 0.12  # of the range: below it a limb can make its next stroke


class Limb:
    """A limb between rest (0) and the end of its range (1): strokes are minimum-jerk curves, the return is slower."""

    __slots__ = ("_back", "_low", "_rise", "_start", "_top", "aside")

    def __init__(self) -> None:
        self._start = -1e9  # s
        self._rise = self._back = 1.0  # s
        self._low = self._top = 0.0
        self.aside = 0.0  # share of the level in the limb's second degree of freedom

    def stroke(self, t: float, size: float, rise: float, back: float) -> float:
        """Begin a stroke at `t` (s), there in `rise` and back in `back` s; return the size that the range allows."""
        self._low = self.level(t)
        self._top = min(1.0, self._low + size)
        self._start, self._rise, self._back = t, rise, back
        return self._top - self._low

    def level(self, t: float) -> float:
        """Return the position of the limb at `t` (s), 0 to 1."""
        since = t - self._start
        if since < self._rise:
            return min(1.0, self._low + (self._top - self._low) * minimum_jerk(since / self._rise))
        since -= self._rise
        if since < self._back:
            return max(0.0, self._top * (1.0 - minimum_jerk(since / self._back)))
        return 0.0

    def is_rising(self, t: float) -> bool:
        """Return whether the limb still moves into the gesture."""
        return t - self._start < self._rise

    def is_resting(self, t: float) -> bool:
        """Return whether the limb has returned to rest."""
        return t - self._start >= self._rise + self._back

    def is_ready(self, t: float) -> bool:
        """Return whether the limb is close enough to rest for another stroke."""
        return not self.is_rising(t) and self.level(t) < REUSABLE


class PerformedStroke(NamedTuple):
    """A stroke as it is performed: another limb or size than was meant, by the person's errors."""

    limb: str
    size: float  # of the joint's range
    rise: float  # s
    free_at: float  # s, when the person can decide on the next stroke


class StrokeMaker:
    """Moves four limbs in strokes; practice makes them more exact and follow each other faster.

    `rng` is shared with the person who decides on the strokes, so that one seed determines everything.
    """

    def __init__(self, parameters: PersonParameters, rng: random.Random) -> None:
        self.parameters = parameters
        self.practice = parameters.practice  # strokes
        self.session_strokes = 0  # in this session; they cause fatigue
        self.limbs = {limb: Limb() for limb in LIMBS}
        self._random = rng

    def is_moving(self, t: float) -> bool:
        """Return whether a limb still moves into its gesture."""
        return any(limb.is_rising(t) for limb in self.limbs.values())

    def can_move(self, limb: str, t: float) -> bool:
        """Return whether a limb is back at rest, and for an elbow, the other elbow too."""
        other = OTHER_ELBOW.get(limb)
        return self.limbs[limb].is_ready(t) and (other is None or self.limbs[other].is_resting(t))

    def make(self, t: float, limb: str, size: float) -> PerformedStroke:
        """Begin a stroke of a limb at `t` (s); chance may choose another limb, and changes size and duration."""
        p, rng = self.parameters, self._random
        if rng.random() < p.wrong_limb.after(self.practice):
            wrong = rng.choice([name for name in self.limbs if name != limb])
            limb = wrong if self.can_move(wrong, t) else limb
        size = min(p.largest, max(p.smallest, size))
        fatigue = p.fatigue(p.fatigue_noise, self.session_strokes)
        size *= 1 + rng.gauss(0, p.stroke_noise.after(self.practice) * fatigue)
        size = min(1.0, max(p.smallest / 2, size + rng.gauss(0, p.constant_noise)))
        rise = (p.rise_base + p.rise_slope * size) * max(0.6, 1 + rng.gauss(0, p.timing_noise))
        self.limbs[limb].aside = rng.uniform(-p.shrug, p.shrug)
        done = self.limbs[limb].stroke(t, size, rise, rise * p.return_factor)
        free_at = t + rise + self.pause()
        self.session_strokes += 1
        if p.learns:
            self.practice += 1
        return PerformedStroke(limb, done, rise, free_at)

    def pause(self) -> float:
        """Return the hesitation before the next stroke, s."""
        p = self.parameters
        fatigue = p.fatigue(p.fatigue_hesitation, self.session_strokes)
        return p.hesitation.after(self.practice) * fatigue * self._random.uniform(0.5, 1.5)
