"""The roles of the hardware: Shirt, Body, HeadTracker, Chair."""

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
    """Why a device cannot be used, as one sentence that names the device, the place and the remedy."""


@dataclass(slots=True)
class LeaderView:
    """The leader whom the chair is to follow."""

    pose: Pose
    v: float  # m/s


@dataclass(slots=True)
class BodyView:
    """What the simulated body sees; the loop rewrites it at each tick."""

    cue: Cue | None = None  # the cue in force
    cue_elapsed: float = 0.0  # s since the cue came up
    driving: bool = False  # whether gestures may move the chair now
    pose: Pose = ORIGIN
    v: float = 0.0  # m/s
    omega: float = 0.0  # rad/s
    in_contact: bool = False  # whether the chair touches something
    leader: LeaderView | None = None  # of a task that says to follow somebody


class Body(Protocol):
    """What moves inside the simulated shirt: a simulated body."""

    @property
    def joints(self) -> Sequence[str]:
        """Names of the degrees of freedom, in the order of `step`'s posture."""
        ...

    def step(self, dt: float, view: BodyView) -> NDArray[np.float64]:
        """Advance by `dt` (s) and return the posture (n_joints,): 0 at rest, 1 fully towards the gesture.

        A posture may be negative. The array belongs to the body, which overwrites it at the next step.
        """
        ...

    def reset(self) -> None:
        """Return to rest and restart the random numbers."""
        ...


@runtime_checkable
class DrivingBody(Protocol):
    """A body that drives the tasks of a floor plan by itself."""

    def show_task(self, plan: FloorPlan, path: PrescribedPath) -> None:
        """Give the body the floor plan and the path that it is to drive."""
        ...


@runtime_checkable
class MovableBody(Protocol):
    """A body whose joints are moved from outside."""

    def move(self, joints: Mapping[str, float]) -> None:
        """Set the targets of joints, 0 (rest) to 1 (full movement); ValueError, in one sentence, for what cannot be."""
        ...


class Shirt(Protocol):
    """A source of frames. Drivers drop none: the loop decodes every frame and commands the chair by the newest."""

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
        """Open the device.

        Raises
        ------
        HardwareError
            When the device cannot be opened; no resource is held then.
        """
        ...

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s); None when none came."""
        ...

    def pending(self) -> bool:
        """Return whether another frame seems to have arrived already."""
        ...

    def words(self) -> str:
        """Return the shirt's state in words."""
        ...

    def close(self) -> None:
        """Release the device; closing twice does no harm."""
        ...


class SenderReport(Protocol):
    """Which addresses send good frames to a shirt's port."""

    @property
    def name(self) -> str:
        """The shirt's own address, empty before its first frame."""
        ...

    @property
    def other(self) -> str:
        """The address of another sender, empty when only the shirt sends."""
        ...

    @property
    def other_frames(self) -> int:
        """How many frames of other senders were ignored."""
        ...


@runtime_checkable
class NetworkShirt(Protocol):
    """A shirt over the network: anybody could send its frames, so a person chooses the sender."""

    @property
    def sender_choice(self) -> SenderReport:
        """The sender in use, and the others."""
        ...

    def use_sender(self, name: str) -> bool:
        """Accept another sender as the shirt; False when none of this name sent good frames."""
        ...


class HeadTracker(Protocol):
    """A source of head poses. Only the newest pose counts: none is queued, and reading never waits."""

    def open(self) -> None:
        """Open the device.

        Raises
        ------
        HardwareError
            When the device cannot be opened; no resource is held then.
        """
        ...

    def newest(self) -> HeadPose | None:
        """Take in what has arrived, without waiting, and return the newest pose; None before the first.

        Poses that are not finite, truncated or foreign are ignored. A pose keeps its time of arrival, so that its age
        shows when the tracker has gone silent.
        """
        ...

    def words(self) -> str:
        """Return the tracker's state in words."""
        ...

    def close(self) -> None:
        """Release the device; closing twice does no harm."""
        ...
