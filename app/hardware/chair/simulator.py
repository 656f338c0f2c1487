"""The virtual chair on a floor plan, stopped by walls, with the verbs of a chair: the unicycle, or a wheelchair."""

import math
from dataclasses import dataclass
from typing import Literal, get_args

from app.geometry import STANDSTILL, Pose, Twist
from app.speeds import HIGHEST_SPEEDS
from app.world import dynamics, kinematics
from app.world.collision import Collision
from app.world.dynamics import Motion, Wheelchair
from app.world.encounter import Encounters
from app.world.floorplan import FloorPlan

Dynamics = Literal["unicycle", "wheelchair"]

LONGEST_STEP = 0.1  # s; after a longer silence the chair has not driven on by itself
FREE_AGAIN = 0.25  # s without touching after which the next touch is a new contact
FASTEST = 10.0  # m/s or rad/s; nothing beyond is a command of a wheelchair (nor is NaN)


@dataclass(slots=True)
class ChairState:
    """Where the chair is and how it moves."""

    x: float  # m
    y: float  # m
    theta: float  # rad
    v: float  # m/s, forwards; less than told when a wall holds the chair
    omega: float  # rad/s
    in_contact: bool
    contacts: int  # beginnings of contact since it was placed
    scene_t: float = 0.0  # s of permitted motion since it was placed: the time of what moves by itself


class VirtualChair:
    """A chair that is a program; without a floor plan the floor has no end.

    As a unicycle it does what it is told, exactly and at once, as in the paper; as a wheelchair it lags, its castors
    swing in and its wheels slip, and the state tells what it really does.
    """

    is_real = False
    speeds = HIGHEST_SPEEDS

    __slots__ = ("_collision", "_contacts", "_encounters", "_free_for", "_motion", "_wheelchair", "state")

    def __init__(self, floorplan: FloorPlan | None, start: Pose, dynamics: Dynamics = "unicycle") -> None:
        """Raise ValueError when there are no such `dynamics`, or the chair cannot stand on `start`."""
        if dynamics not in get_args(Dynamics):
            raise ValueError(f"there are no dynamics '{dynamics}': use unicycle or wheelchair")
        self._collision = Collision(floorplan)
        self._encounters = Encounters(floorplan.movers if floorplan else ())
        self._wheelchair = Wheelchair() if dynamics == "wheelchair" else None
        self.place(start)

    def place(self, pose: Pose) -> None:
        """Put the chair on `pose`, at a standstill, castors in line, with no contacts yet.

        Raises
        ------
        ValueError
            When a wall or an obstacle stands there, or the pose is not finite.
        """
        if not all(map(math.isfinite, pose)):
            raise ValueError("the chair's place is not a number: give x and y in m and the heading in rad")
        if not self._collision.is_free(pose.x, pose.y):
            raise ValueError(
                f"the chair cannot stand at ({pose.x:.2f}, {pose.y:.2f}): something is in the way, choose a free place"
            )
        self._motion = Motion(pose)
        self._contacts = 0
        self._free_for = FREE_AGAIN
        self.state = ChairState(pose.x, pose.y, pose.theta, 0.0, 0.0, False, 0)

    def drive(self, twist: Twist, dt: float, permitted: bool = False) -> ChairState:
        """Drive `twist` for `dt` seconds (at most 0.1) and return the new state.

        A step of no or negative duration moves nothing; a twist that is no command of a wheelchair is a standstill.
        While motion is `permitted`, what moves by itself goes on, too.
        """
        if not (-FASTEST <= twist.v <= FASTEST and -FASTEST <= twist.omega <= FASTEST):
            twist = STANDSTILL
        if not dt > 0.0:
            return self.state
        dt = min(dt, LONGEST_STEP)
        pose = self._motion.pose
        if self._wheelchair is None:
            wanted = Motion(kinematics.step(pose, twist, dt), *twist)
        else:
            wanted = dynamics.step(self._motion, twist, dt, self._wheelchair)
        v, theta = wanted.v, wanted.pose.theta
        scene_t = self.state.scene_t + dt if permitted else self.state.scene_t
        x, y, touching = self._collision.slide(pose.x, pose.y, wanted.pose.x, wanted.pose.y)
        if self._encounters:
            x, y, met = self._encounters.slide(pose.x, pose.y, x, y, scene_t)
            if met:
                x, y, _ = self._collision.slide(pose.x, pose.y, x, y)  # along somebody, but not into a wall
                touching = True
        if touching:
            if self._free_for >= FREE_AGAIN:
                self._contacts += 1
            self._free_for = 0.0
            v = ((x - pose.x) * math.cos(pose.theta) + (y - pose.y) * math.sin(pose.theta)) / dt
            wanted = wanted._replace(pose=Pose(x, y, theta), v=v)  # the wall holds the wheels, too
        else:
            self._free_for += dt
        self._motion = wanted
        self.state = ChairState(x, y, theta, v, wanted.omega, touching, self._contacts, scene_t)
        return self.state
