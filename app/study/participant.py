"""The participant of a study: a simulated person in the simulated shirt, one frame at a time, without a clock."""

import numpy as np

from app.cues import Cue
from app.geometry import Pose
from app.hardware.base import BodyView, LeaderView
from app.hardware.body.cursor_view import CursorView
from app.hardware.body.person import SimulatedPerson
from app.hardware.shirt.simulated_fabric import Fabric
from app.layout import ShirtLayout
from app.messages import ChairState, SensorFrame
from app.world.cursor_task import CursorTask
from app.world.movers import MoverState


class Participant:
    """A simulated person in the simulated shirt.

    Each of `follow`, `rest`, `drive` and `point` advances the body by one frame and returns the shirt's frame. Time is
    the number of frames divided by the sample rate.
    """

    def __init__(self, person: SimulatedPerson, layout: ShirtLayout, sample_rate: float, seed: int) -> None:
        """Put the shirt on `person`; `seed` is the fabric's, `sample_rate` in Hz."""
        self.person = person
        self.layout = layout
        self.sample_rate = sample_rate
        self._fabric = Fabric(layout, seed)
        self._order = np.array([person.joints.index(joint) for joint in self._fabric.joints], dtype=np.intp)
        self._view = BodyView()
        self._dt = 1.0 / sample_rate
        self._seq = 0

    def wear(self, wearer: int) -> None:
        """Let another body wear the shirt; `wearer` is the seed of what differs."""
        self._fabric.worn_by(wearer)

    def don_again(self) -> None:
        """Take the shirt off and put it on again."""
        self._fabric.don_again()

    def follow(self, cue: Cue | None, elapsed: float) -> SensorFrame:
        """Return the next frame of the person following `cue`, which was shown `elapsed` (s) ago."""
        self._view = BodyView(cue=cue, cue_elapsed=elapsed)
        return self._frame()

    def rest(self) -> SensorFrame:
        """Return the next frame of the person at rest."""
        self._view = BodyView()
        return self._frame()

    def drive(self, permitted: bool, chair: ChairState, leader: MoverState | None = None) -> SensorFrame:
        """Return the next frame of the person driving, who sees chair, leader and whether motion is `permitted`."""
        view = self._view
        view.cue = None
        view.driving = permitted
        view.pose = Pose(chair.x, chair.y, chair.theta)
        view.v, view.omega = chair.v, chair.omega
        view.in_contact = chair.in_contact
        view.leader = None if leader is None else LeaderView(*leader)
        return self._frame()

    def point(self, task: CursorTask) -> SensorFrame:
        """Return the next frame of the person who sees cursor and target of an interface test."""
        self._view = BodyView(cursor=CursorView.of(task))
        return self._frame()

    def _frame(self) -> SensorFrame:
        values = self._fabric.step(self.person.step(self._dt, self._view)[self._order], self._dt)
        self._seq += 1
        t = self._seq * self._dt
        return SensorFrame(self._seq, t, t, values)
