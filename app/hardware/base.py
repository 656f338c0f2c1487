"""The roles of the hardware: what every shirt does, and every body inside the simulated one."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from app.cues import Cue
from app.geometry import Pose
from app.layout import ShirtLayout
from app.messages import HeadPose, SensorFrame
from app.world.floorplan import FloorPlan, PrescribedPath

ORIGIN = Pose(0.0, 0.0, 0.0)


class HardwareError(Exception):
    """A device that cannot be had, as one sentence that says what, where and what to do."""


@dataclass(slots=True)
class LeaderView:
    """Somebody ahead who is to be followed."""

    pose: Pose
    v: float  # m/s


@dataclass(slots=True)
class BodyView:
    """What the person in the simulated shirt sees; the loop writes it anew at each tick."""

    cue: Cue | None = None  # what is asked at this moment
    cue_elapsed: float = 0.0  # s since the cue came up
    driving: bool = False  # whether movement may move the chair now
    pose: Pose = ORIGIN
    v: float = 0.0  # m/s
    omega: float = 0.0  # rad/s
    in_contact: bool = False  # whether the chair touches something
    leader: LeaderView | None = None  # whom the task says to follow


class Body(Protocol):
    """What moves inside the simulated shirt."""

    @property
    def joints(self) -> Sequence[str]:
        """Names of the degrees of freedom, in the order of `step`'s posture."""
        ...

    def step(self, dt: float, view: BodyView) -> NDArray[np.float64]:
        """Live on for `dt` (s) and return the posture (n_joints,): 0 at rest, 1 fully towards the gesture.

        It may be negative, and it belongs to the body: it is written anew at the next step.
        """
        ...

    def reset(self) -> None:
        """Come back to rest, and begin anew what is random."""
        ...


@runtime_checkable
class Driving(Protocol):
    """A body that does the tasks of a floor plan by itself."""

    def show_task(self, plan: FloorPlan, path: PrescribedPath) -> None:
        """Show what is asked, and where."""
        ...


@runtime_checkable
class Movable(Protocol):
    """A body whose joints somebody else moves."""

    def move(self, joints: Mapping[str, float]) -> None:
        """Say where joints should go, 0 (rest) to 1 (all the way); ValueError, in one sentence, when they cannot."""
        ...


class Shirt(Protocol):
    """A source of frames. Drivers drop none: the loop decodes every frame and sends on only the newest."""

    @property
    def layout(self) -> ShirtLayout:
        """Names and places of the channels, in the order of a frame's values; known once the shirt is open."""
        ...

    @property
    def sample_rate(self) -> float:
        """Frames per second (Hz); known once the shirt is open."""
        ...

    @property
    def lost(self) -> int:
        """Frames missing in the shirt's own count since it was opened."""
        ...

    def open(self) -> None:
        """Begin.

        Raises
        ------
        HardwareError
            When it cannot be opened; nothing is held then.
        """
        ...

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s); None when none came."""
        ...

    def pending(self) -> bool:
        """Return whether another frame seems to be there already."""
        ...

    def words(self) -> str:
        """Return the shirt's state in words."""
        ...

    def close(self) -> None:
        """Give back what is held; closing twice does no harm."""
        ...


class OtherSenders(Protocol):
    """Who else sends good frames to a shirt's port."""

    @property
    def name(self) -> str:
        """The shirt's own address, empty before its first frame."""
        ...

    @property
    def other(self) -> str:
        """The address of another sender, empty when there is none."""
        ...

    @property
    def others(self) -> int:
        """How many frames of other senders were left out."""
        ...


@runtime_checkable
class FromNetwork(Protocol):
    """A shirt whose frames anybody could send, so that its sender is chosen by a person."""

    @property
    def senders(self) -> OtherSenders:
        """Who sends."""
        ...

    def use_sender(self, name: str) -> bool:
        """Take another sender as the shirt; False when none of this name sent good frames."""
        ...


class HeadTracker(Protocol):
    """A source of head poses. Only the newest matters: nothing is queued, nothing is waited for."""

    def open(self) -> None:
        """Begin.

        Raises
        ------
        HardwareError
            When it cannot be opened; nothing is held then.
        """
        ...

    def newest(self) -> HeadPose | None:
        """Take in what has come, without waiting, and return the newest pose; None before the first.

        What is not finite, cut off or foreign is left out. The pose keeps its time of arrival, so that its age tells
        when the tracker has gone silent.
        """
        ...

    def words(self) -> str:
        """Return the tracker's state in words."""
        ...

    def close(self) -> None:
        """Give back what is held; closing twice does no harm."""
        ...
