"""The virtual chair on a floor plan, stopped by walls: a unicycle, or a wheelchair with lag, castors and slip."""

# Compiled in a wheel (hatch_build.py).

import math
from typing import Final, Literal, get_args

from app.geometry import STANDSTILL, Pose, Twist
from app.messages import ChairState
from app.speed_limits import HIGHEST_SPEEDS
from app.texts import Figure, Text
from app.world import dynamics, kinematics
from app.world.collision import Collision
from app.world.contacts import NEW_CONTACT_AFTER
from app.world.dynamics import Motion, Wheelchair
from app.world.encounter import Encounters
from app.world.floorplan import FloorPlan

Dynamics = Literal["unicycle", "wheelchair"]

LONGEST_STEP: Final = 0.1  # s: during a longer pause the chair does not drive on
FASTEST: Final = 10.0  # m/s or rad/s: a faster twist, or a NaN, is no command of a wheelchair


class VirtualChair:
    """A simulated chair; without a floor plan it stands on an endless floor.

    A unicycle follows its command exactly and at once, as in the paper. A wheelchair lags behind its command, its
    castors swing in and its wheels slip; its state holds the motion that results.
    """

    __slots__ = (
        *("_collision", "_contacts", "_encounters", "_free_for", "_motion", "_wheelchair"),
        *("speeds", "state"),
    )

    def __init__(self, floorplan: FloorPlan | None, start: Pose, dynamics: Dynamics = "unicycle") -> None:
        """Raise ValueError when there are no such `dynamics`, or the chair cannot stand on `start`."""
        if dynamics not in get_args(Dynamics):
            raise ValueError(f"there are no dynamics '{dynamics}': use unicycle or wheelchair")
        self.speeds = HIGHEST_SPEEDS
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
            raise ValueError(Text("chairdev-no-room", x=Figure(pose.x, 2), y=Figure(pose.y, 2)))
        self._motion = Motion(pose)
        self._contacts = 0
        self._free_for = NEW_CONTACT_AFTER
        self.state = ChairState(pose.x, pose.y, pose.theta, 0.0, 0.0, False, 0)

    def drive(self, twist: Twist, dt: float, permitted: bool = False) -> ChairState:
        """Drive `twist` for `dt` seconds (at most 0.1) and return the new state.

        A step of zero or negative duration moves nothing; a twist that is no command of a wheelchair counts as zero.
        While motion is `permitted`, people and objects that move by themselves move on.
        """
        if not (-FASTEST <= twist.v <= FASTEST and -FASTEST <= twist.omega <= FASTEST):
            twist = STANDSTILL
        if not dt > 0.0:
            return self.state
        dt = min(dt, LONGEST_STEP)
        last, motion = self.state, None
        if self._wheelchair is None:
            v, omega = twist
            x, y, theta = kinematics.unicycle(last.x, last.y, last.theta, v, omega, dt)
        else:
            motion = dynamics.step(self._motion, twist, dt, self._wheelchair)
            (x, y, theta), v, omega = motion.pose, motion.v, motion.omega
        scene_t = last.scene_t + dt if permitted else last.scene_t
        x, y, touching = self._collision.slide(last.x, last.y, x, y)
        if self._encounters:
            x, y, met = self._encounters.slide(last.x, last.y, x, y, scene_t)
            if met:
                x, y, _ = self._collision.slide(last.x, last.y, x, y)  # along the person, but not into a wall
                touching = True
        if touching:
            if self._free_for >= NEW_CONTACT_AFTER:
                self._contacts += 1
            self._free_for = 0.0
            v = ((x - last.x) * math.cos(last.theta) + (y - last.y) * math.sin(last.theta)) / dt
        else:
            self._free_for += dt
        if motion is not None:
            self._motion = motion._replace(pose=Pose(x, y, theta), v=v)  # a wall stops the wheels, too
        self.state = ChairState(x, y, theta, v, omega, touching, self._contacts, scene_t)
        return self.state
