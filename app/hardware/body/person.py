"""A simulated person, who follows cues and drives along a path by himself."""

import numpy as np
from numpy.typing import NDArray

from app.hardware.base import BodyView
from app.hardware.body.cued_body import CuedBody
from app.hardware.body.driver import Driver
from app.hardware.body.joints import ARM_DEGREES_OF_FREEDOM, second_way
from app.hardware.body.person_parameters import PARAMETERS, PersonParameters, Skill
from app.hardware.body.pointer import Pointer
from app.hardware.body.tremor import Tremor
from app.world.floorplan import FloorPlan, PrescribedPath


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
        posture = self._posture
        posture[:] = self._cued.follow(dt, None if view.driving else view.cue)
        for limb, along, aside in self._limbs:
            if not limb.is_resting(self._t):
                level = limb.level(self._t)
                posture[along] += level
                if aside is not None:
                    posture[aside] += level * limb.aside
        posture *= self._range
        if self._tremor.size > 0.0:
            posture += self._tremor.at(self._t)
        return posture
