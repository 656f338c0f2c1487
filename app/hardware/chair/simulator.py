"""The virtual chair: the unicycle on a floor plan, stopped by walls, with the verbs of a chair."""

import math
from dataclasses import dataclass

from app.geometry import Pose, Twist
from app.world.collision import Collision
from app.world.floorplan import FloorPlan
from app.world.kinematics import step

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


class VirtualChair:
    """A chair that is a program; without a floor plan the floor has no end."""

    __slots__ = ("_collision", "_contacts", "_free_for", "_pose", "state")

    def __init__(self, floorplan: FloorPlan | None, start: Pose) -> None:
        self._collision = Collision(floorplan)
        self.place(start)

    def place(self, pose: Pose) -> None:
        """Put the chair on `pose`, at a standstill, with no contacts yet.

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
        self._pose = pose
        self._contacts = 0
        self._free_for = FREE_AGAIN
        self.state = ChairState(pose.x, pose.y, pose.theta, 0.0, 0.0, False, 0)

    def drive(self, twist: Twist, dt: float) -> ChairState:
        """Drive `twist` for `dt` seconds (at most 0.1) and return the new state.

        A step of no or negative duration moves nothing; a twist that is no command of a wheelchair is a standstill.
        """
        v, omega = twist
        if not (-FASTEST <= v <= FASTEST and -FASTEST <= omega <= FASTEST):
            v = omega = 0.0
            twist = Twist(0.0, 0.0)
        if not dt > 0.0:
            return self.state
        dt = min(dt, LONGEST_STEP)
        pose = self._pose
        wanted = step(pose, twist, dt)
        x, y, touching = self._collision.slide(pose.x, pose.y, wanted.x, wanted.y)
        if touching:
            if self._free_for >= FREE_AGAIN:
                self._contacts += 1
            self._free_for = 0.0
            v = ((x - pose.x) * math.cos(pose.theta) + (y - pose.y) * math.sin(pose.theta)) / dt
        else:
            self._free_for += dt
        self._pose = Pose(x, y, wanted.theta)
        self.state = ChairState(x, y, wanted.theta, v, omega, touching, self._contacts)
        return self.state
