"""A simulated body that follows cues: rests, moves freely, makes the prompted movement and returns."""

# Compiled in a wheel (hatch_build.py).

import random
from collections.abc import Sequence

from app.cues import Cue
from app.hardware.body.joints import second_way
from app.hardware.body.minimum_jerk import Reach

REACTION = (0.25, 0.04)  # s, mean and standard deviation
PROMPTED_TIME = 0.65  # of a cue's duration: people finish a movement before the next cue
TIME_NOISE = 0.08  # standard deviation of a duration over the duration
PROMPTED_SIZE = (0.9, 0.05)  # of the range
COMPANION = 0.10  # of the range, at most: movement of the other joints of the same arm
SETTLE = 0.9  # s back to rest after free movement
FREE_TIME = (0.7, 1.4)  # s for one free movement
FREE_PAUSE = (0.0, 0.35)  # s between two free movements
FREE_HIGH, FREE_LOW = (0.65, 1.0), (0.0, 0.2)  # of the range
FREE_ASIDE = (0.35, 0.65)  # of the range, in both directions, in a joint's second degree of freedom
TREMOR = 0.0025  # of the range, standard deviation
TREMOR_TIME = 0.12  # s, time constant of the tremor
SHORTEST = 0.2  # s, of any movement


class CuedBody:
    """A body that follows cues, joint by joint; the seed determines the movements."""

    def __init__(self, joints: Sequence[str], seed: int) -> None:
        self.joints = tuple(joints)
        self._seed = seed
        self._seconds = {name for joint in joints if (name := second_way(joint)) is not None}
        self.reset()

    def reset(self) -> None:
        """Return to rest and restart the random numbers."""
        self._random = random.Random(self._seed)
        self._cue: Cue | None = None
        self._t = 0.0
        self._place = [0.0] * len(self.joints)
        self._speed = [0.0] * len(self.joints)
        self._tremor = [0.0] * len(self.joints)
        self._reaches: list[Reach | None] = [None] * len(self.joints)
        self._begins = [0.0] * len(self.joints)  # s: when the current or planned reach begins
        self._high = [False] * len(self.joints)  # whether the next free movement goes back

    @property
    def is_at_rest(self) -> bool:
        """Whether every joint is at rest, apart from tremor."""
        return all(abs(place) < 0.01 for place in self._place)

    def follow(self, dt: float, cue: Cue | None) -> list[float]:
        """Advance by `dt` (s) under `cue` (None: rest) and return the posture (n_joints,)."""
        if cue is not self._cue and cue != self._cue:
            self._begin_cue(cue)
        self._cue = cue
        self._t += dt
        free = cue is not None and cue.kind == "free"
        calm = dt / (TREMOR_TIME + dt)
        shake = TREMOR * (2.0 * calm) ** 0.5
        gauss = self._random.gauss
        places, tremors = self._place, self._tremor
        posture = []
        for i, reach in enumerate(self._reaches):
            if reach is not None:
                elapsed = self._t - self._begins[i]
                place = reach.at(elapsed)
                self._speed[i] = (place - places[i]) / dt if dt > 0 else 0.0
                places[i] = place
                if reach.is_over(elapsed):
                    self._reaches[i] = None
                    self._speed[i] = 0.0
            elif free:
                self._wander(i)
            tremor = tremors[i]
            tremors[i] = tremor = tremor + (gauss(0.0, shake) - calm * tremor)
            posture.append(places[i] + tremor)
        return posture

    def _begin_cue(self, cue: Cue | None) -> None:
        """Plan the movements of a new cue."""
        kind = "rest" if cue is None else cue.kind
        duration = SETTLE if cue is None else cue.end - cue.start
        delay = max(0.1, self._random.gauss(*REACTION))
        if kind == "free":
            for i in range(len(self.joints)):
                self._wander(i)
        elif kind == "move" and cue is not None and cue.joint in self.joints:
            prompted = self.joints.index(cue.joint)
            self._plan(prompted, self._random.gauss(*PROMPTED_SIZE), delay, PROMPTED_TIME * duration)
            side = cue.joint.partition("_")[0]
            for i, joint in enumerate(self.joints):
                if i != prompted and joint.partition("_")[0] == side:
                    share = self._random.uniform(-0.3, 1.0) * COMPANION
                    self._plan(i, share, delay, PROMPTED_TIME * duration)
        else:
            back = PROMPTED_TIME * duration if kind == "return" else SETTLE
            for i in range(len(self.joints)):
                if self._place[i] != 0.0 or self._reaches[i] is not None:
                    self._plan(i, 0.0, delay, back)

    def _plan(self, i: int, target: float, delay: float, duration: float) -> None:
        """Begin a movement of one joint `delay` seconds from now; it starts with the joint's present speed."""
        duration = max(SHORTEST, duration * self._random.gauss(1.0, TIME_NOISE))
        if self._speed[i] != 0.0:
            delay, duration = 0.0, duration + delay  # a moving limb turns at once
        self._reaches[i] = Reach(self._place[i], self._speed[i], target, duration)
        self._begins[i] = self._t + delay

    def _wander(self, i: int) -> None:
        """Plan the next free movement of one joint, in turn away from rest and back."""
        draw = self._random.uniform
        self._high[i] = not self._high[i]
        if self.joints[i] in self._seconds:
            target = draw(*FREE_ASIDE) * (1.0 if self._high[i] else -1.0)
        else:
            target = draw(*(FREE_HIGH if self._high[i] else FREE_LOW))
        self._plan(i, target, draw(*FREE_PAUSE), draw(*FREE_TIME))
