"""A simulated person, who follows cues, drives along a path, and moves a cursor into targets."""

# Compiled in a wheel (hatch_build.py).

import math
import random
from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.cues import Cue
from app.hardware.base import BodyView
from app.hardware.body.cursor_view import CursorView
from app.hardware.body.driver import Driver
from app.hardware.body.joints import ARM_DEGREES_OF_FREEDOM, second_way
from app.hardware.body.minimum_jerk import Reach
from app.hardware.body.person_parameters import PARAMETERS, PersonParameters, Skill
from app.hardware.body.stroke_estimate import StrokeEstimate
from app.hardware.body.stroke_maker import PerformedStroke, StrokeMaker
from app.world.floorplan import FloorPlan, PrescribedPath

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
SMALL_TREMOR = 0.0025  # of the range, standard deviation; everybody has it
SMALL_TREMOR_TIME = 0.12  # s, time constant of the tremor
SHORTEST = 0.2  # s, of any movement


class CuedBody:
    """A body that follows cues, joint by joint; the seed determines the movements.

    It rests, moves freely, makes the prompted movement and returns.
    """

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
        calm = dt / (SMALL_TREMOR_TIME + dt)
        shake = SMALL_TREMOR * (2.0 * calm) ** 0.5
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


LIMB_TOWARDS = {
    ("ahead", True): "right_elbow",
    ("ahead", False): "left_elbow",
    ("left", True): "right_shoulder",
    ("left", False): "left_shoulder",
}
AXIS_OF = {limb: axis for (axis, _), limb in LIMB_TOWARDS.items()}
SIGN_OF = {limb: 1.0 if towards else -1.0 for (_, towards), limb in LIMB_TOWARDS.items()}
USUAL_EFFECT = 0.375  # arms of the cross, of a full stroke under the standard parameters
USUAL_LOSS = 0.08  # of the range, lost in the dead-zone
LARGEST_FIRST_ERROR = 1.5  # of a first estimate, in standard deviations
LOOK_PERIOD = 0.05  # s between two decisions
SETTLING = 0.12  # s until the effect of a finished stroke has passed the low-pass filter
AIM = 0.6  # of the target's radius: nearer to the middle nothing is corrected
# Hz: rest tremor 4 to 6, most action tremor 4 to 8 (Deuschl, Bain and Brin, Mov Disord 13 S3, 1998).
TREMOR_BAND = (4.0, 8.0)
TREMOR_SINES = 5  # for each joint; their beats make the tremor grow and fade
SEED_APART = 7_919  # the strokes of driving do not depend on whether the test was done


class PointingStroke(NamedTuple):
    """A stroke whose outcome is not yet seen."""

    performed: PerformedStroke
    end: float  # s
    before: float  # place of the cursor along the stroke's axis, arms
    missed: int  # targets missed before it


class Pointer:
    """Moves the cursor into the target: first along the longer of the two ways that are left, then the other.

    The strokes are those of the driver, whose practice, fatigue and errors they share; what a stroke does to the
    cursor is learnt apart from what it does to the chair.
    """

    def __init__(self, strokes: StrokeMaker, seed: int) -> None:
        self._strokes = strokes
        rng = random.Random(seed + SEED_APART)
        spread = strokes.parameters.estimate_error.after(strokes.practice)
        self.estimates = {
            limb: StrokeEstimate(
                USUAL_EFFECT
                * math.exp(spread * min(LARGEST_FIRST_ERROR, max(-LARGEST_FIRST_ERROR, rng.gauss(0.0, 1.0)))),
                USUAL_LOSS,
            )
            for limb in AXIS_OF
        }
        self._seen: deque[tuple[float, CursorView]] = deque()
        self._open: PointingStroke | None = None  # whose outcome is not yet seen
        self._free_at = self._look_at = -math.inf

    def rest(self) -> None:
        """Stop pointing; moving limbs return to rest."""
        self._seen.clear()
        self._open = None

    def point(self, t: float, view: CursorView) -> None:
        """Look at `t` (s) at the cursor and the target; begin a stroke when one is due."""
        seen = self._seen
        if not seen:
            self._free_at = self._look_at = t + self._strokes.parameters.reaction_time
        seen.append((t, view))
        while len(seen) > 1 and seen[1][0] <= t - self._strokes.parameters.reaction_time:
            seen.popleft()
        if t < self._look_at:
            return
        self._look_at = t + LOOK_PERIOD
        self._look(t, *seen[0])

    def _look(self, t: float, seen_t: float, view: CursorView) -> None:
        self._learn(seen_t, view)
        if view.target is None or self._open is not None or t < self._free_at or self._strokes.is_moving(t):
            return
        error = {"ahead": view.target[0] - view.place[0], "left": view.target[1] - view.place[1]}
        axis = max(error, key=lambda name: abs(error[name]))
        if abs(error[axis]) <= AIM * view.radius:
            return
        limb = LIMB_TOWARDS[axis, error[axis] > 0.0]
        if not self._strokes.can_move(limb, t):
            return
        performed = self._strokes.make(t, limb, self.estimates[limb].size_for(abs(error[axis])))
        self._open = PointingStroke(performed, t + performed.rise, _along(performed.limb, view), view.missed)
        self._free_at = performed.free_at

    def _learn(self, seen_t: float, view: CursorView) -> None:
        """Compare the seen effect of the last stroke with the expected effect, and correct the estimate."""
        stroke = self._open
        if stroke is None or (seen_t < stroke.end + SETTLING and view.missed == stroke.missed):
            return
        self._open = None
        limb, after = stroke.performed.limb, _along(stroke.performed.limb, view)
        was_moved = view.missed != stroke.missed or abs(after) >= 1.0  # put back, or kept back by the edge
        if self._strokes.parameters.learns and not was_moved:
            effect = SIGN_OF[limb] * (after - stroke.before)
            self.estimates[limb].learn(stroke.performed.size, effect, self._strokes.parameters.correction)


class Tremor:
    """A sum of sines for each joint, with random frequencies in the band; the seed determines the tremor."""

    def __init__(self, joints: int, seed: int) -> None:
        """Draw frequencies and phases for `joints` degrees of freedom; no tremor until `size` is set."""
        random = np.random.default_rng((seed, 48))
        self.size = 0.0  # standard deviation, of a joint's range
        self._turn_rate = math.tau * random.uniform(*TREMOR_BAND, (joints, TREMOR_SINES))  # rad/s
        self._phase = random.uniform(0.0, math.tau, (joints, TREMOR_SINES))

    def at(self, t: float) -> NDArray[np.float64]:
        """Return the tremor of each joint at `t` (s), (n_joints,), of its range."""
        shaken: NDArray[np.float64] = np.sin(self._turn_rate * t + self._phase).sum(axis=1)
        return shaken * (self.size * math.sqrt(2.0 / TREMOR_SINES))  # the sum's variance is TREMOR_SINES / 2


class SimulatedPerson:
    """A simulated body that follows cues, and drives with the paper's vocabulary while it may drive.

    The seed determines the person and the errors. Practice lasts from run to run; only `reset` removes it.
    """

    def __init__(self, skill: Skill | PersonParameters, seed: int) -> None:
        self.parameters = skill if isinstance(skill, PersonParameters) else PARAMETERS[skill]
        self.joints = ARM_DEGREES_OF_FREEDOM
        self._seed = seed
        self._task: tuple[FloorPlan, PrescribedPath] | None = None
        self._posture = np.zeros(len(self.joints))
        self.reset()

    def reset(self) -> None:
        """Return to rest and to the first session: remove all practice and restart the random numbers."""
        self._t = 0.0
        self._cued = CuedBody(self.joints, self._seed)
        self.driver = Driver(self.parameters, self._seed)
        self.pointer = Pointer(self.driver.strokes, self._seed)
        self._tremor = Tremor(len(self.joints), self._seed)
        self.begin_session(1)
        self._limbs = []
        for name, limb in self.driver.strokes.limbs.items():
            aside = second_way(name)
            self._limbs.append((limb, self.joints.index(name), None if aside is None else self.joints.index(aside)))
        if self._task is not None:
            self.driver.show_task(*self._task)

    def begin_session(self, number: int) -> None:
        """Begin a session (counted from 1) without fatigue, with its range and tremor; practice is kept.

        Raises
        ------
        ValueError
            When `number` is below 1.
        """
        if number < 1:
            raise ValueError(f"there is no session {number}: sessions are counted from 1")
        self.session = number
        self.driver.strokes.session_strokes = 0
        self._range = self.parameters.range_in(number)
        self._tremor.size = self.parameters.tremor_in(number)

    def show_task(self, plan: FloorPlan, path: PrescribedPath) -> None:
        """Take the floor plan and the path to drive."""
        self._task = plan, path
        self.driver.show_task(plan, path)

    def step(self, dt: float, view: BodyView) -> NDArray[np.float64]:
        """Advance by `dt` (s) and return the posture (n_joints,): 0 at rest, 1 fully towards the gesture."""
        self._t += dt
        if view.driving:
            self.driver.drive(self._t, view.pose, view.v, view.in_contact, view.leader)
        else:
            self.driver.rest()
        if view.cursor is not None:
            self.pointer.point(self._t, view.cursor)
        else:
            self.pointer.rest()
        levels = self._cued.follow(dt, None if view.driving else view.cue)
        for limb, along, aside in self._limbs:
            if not limb.is_resting(self._t):
                level = limb.level(self._t)
                levels[along] += level
                if aside is not None:
                    levels[aside] += level * limb.aside
        posture = self._posture
        posture[:] = levels
        posture *= self._range
        if self._tremor.size > 0.0:
            posture += self._tremor.at(self._t)
        return posture


def _along(limb: str, view: CursorView) -> float:
    return view.place[0 if AXIS_OF[limb] == "ahead" else 1]
