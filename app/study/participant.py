"""A simulated person in the simulated shirt: one frame at a time, without a clock of the machine."""

import numpy as np

from app.cues import Cue
from app.geometry import Pose
from app.hardware.base import BodyView, LeaderView
from app.hardware.body.person import Person
from app.hardware.chair.simulator import ChairState
from app.hardware.shirt.fabric import Fabric
from app.layout import ShirtLayout
from app.messages import SensorFrame
from app.world.scenery import Place


class Participant:
    """Hands out the shirt's frames as fast as they are asked for; its time is the number of frames over the rate."""

    def __init__(self, person: Person, layout: ShirtLayout, sample_rate: float, seed: int) -> None:
        """Dress `person`; `seed` is the fabric's, `sample_rate` in Hz."""
        self.person = person
        self.layout = layout
        self.sample_rate = sample_rate
        self._fabric = Fabric(layout, seed)
        self._order = np.array([person.joints.index(joint) for joint in self._fabric.joints], dtype=np.intp)
        self._view = BodyView()
        self._dt = 1.0 / sample_rate
        self._seq = 0

    def don_again(self) -> None:
        """Take the shirt off and put it on again."""
        self._fabric.don_again()

    def follow(self, cue: Cue | None, elapsed: float) -> SensorFrame:
        """Return the next frame of somebody who is asked to do `cue`, which came up `elapsed` (s) ago."""
        self._view = BodyView(cue=cue, cue_elapsed=elapsed)
        return self._frame()

    def rest(self) -> SensorFrame:
        """Return the next frame of somebody who has nothing to do."""
        self._view = BodyView()
        return self._frame()

    def drive(self, permitted: bool, chair: ChairState, leader: Place | None = None) -> SensorFrame:
        """Return the next frame of somebody who sees what chair and leader do, and whether motion is `permitted`."""
        view = self._view
        view.cue = None
        view.driving = permitted
        view.pose = Pose(chair.x, chair.y, chair.theta)
        view.v, view.omega = chair.v, chair.omega
        view.in_contact = chair.in_contact
        view.leader = None if leader is None else LeaderView(*leader)
        return self._frame()

    def _frame(self) -> SensorFrame:
        values = self._fabric.step(self.person.step(self._dt, self._view)[self._order], self._dt)
        self._seq += 1
        t = self._seq * self._dt
        return SensorFrame(self._seq, t, t, values)
