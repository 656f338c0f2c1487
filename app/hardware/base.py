"""The roles of the hardware: Shirt, Body, HeadTracker, Chair."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from app.arrivals import Arrivals
from app.cues import Cue
from app.faults import State
from app.geometry import Pose, Twist
from app.hardware.body.cursor_view import CursorView
from app.hardware.shirt.sender_choice import SenderChoice
from app.layout import ShirtLayout
from app.messages import ChairState, HeadPose, SensorFrame, Tick
from app.speed_limits import Speeds
from app.texts import Text
from app.visible_text import one_line
from app.world.floorplan import FloorPlan, PrescribedPath

ORIGIN = Pose(0.0, 0.0, 0.0)
LONGEST_MESSAGE = 120  # characters of a library's message, in a sentence


class HardwareError(Exception):
    """Why a device cannot be used: a text of one sentence that names the device, the place and the remedy."""


def library_message(error: Exception) -> str:
    """Return what the library of a device says of an error: printable, in one short line, never empty."""
    return one_line(str(error), LONGEST_MESSAGE) or type(error).__name__


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
    leader: LeaderView | None = None  # of a task to follow a leader
    cursor: CursorView | None = None  # during an interface test


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
        """Set the targets of joints, 0 (rest) to 1 (full movement); ValueError, with a text, for what cannot be."""
        ...


class Shirt(Protocol):
    """A source of frames. The loop decodes every frame and commands the chair by the newest.

    A driver drops none but those that its own checks refuse: repeated, forged or late ones.
    """

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

    def description(self) -> Text:
        """Return the shirt's state in words."""
        ...

    def close(self) -> None:
        """Release the device; closing twice does no harm."""
        ...


@runtime_checkable
class NetworkShirt(Protocol):
    """A shirt over the network: anybody could send its frames, so a person chooses the sender."""

    @property
    def sender_choice(self) -> SenderChoice:
        """The sender in use, and the others."""
        ...

    def use_sender(self, name: str) -> bool:
        """Accept another sender as the shirt; False when none of this name sent good frames."""
        ...

    def lost_key(self) -> Text | None:
        """Return why the shirt's key counts no longer, None while it does or there is no key."""
        ...


@runtime_checkable
class SearchingShirt(Protocol):
    """A shirt that finds sensors by itself; a person then says where on the body they are."""

    @property
    def found(self) -> list[str]:
        """The names of the sensors that send and are on no part of the body."""
        ...


@runtime_checkable
class ReportingShirt(Protocol):
    """A shirt that says what arrives at it, or why nothing does and what to do; also while it is closed."""

    def arrivals(self) -> Arrivals:
        """Return what arrives now; the loop asks at least twice a second, so that this must not wait."""
        ...


@runtime_checkable
class PageShirt(Protocol):
    """A shirt whose samples a page sends, by the web process."""

    def add_sample(self, page: int, message: bytes, received: float) -> None:
        """Take the message of a page that came at `received` (monotonic s); one that is no sample changes nothing.

        `page` is the number of the page that is the sensor now, another number another page; of phones, their number.
        """
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

    def description(self) -> Text:
        """Return the tracker's state in words."""
        ...

    def close(self) -> None:
        """Release the device; closing twice does no harm."""
        ...


class Chair(Protocol):
    """A chair as it is driven: the virtual chair, or a real one behind its receiver."""

    @property
    def speeds(self) -> Speeds:
        """The chair's own limits."""
        ...

    @property
    def state(self) -> ChairState:
        """Where the chair is and how it moves, as of the newest `drive`."""
        ...

    def drive(self, twist: Twist, dt: float, permitted: bool = False, /) -> ChairState:
        """Command `twist` for `dt` (s) and return the new state; what moves by itself goes on while `permitted`."""
        ...

    def place(self, pose: Pose) -> None:
        """Take `pose` as the chair's place, at a standstill."""
        ...


class LinkedChair(Chair, Protocol):
    """A real chair: a person may sit in it, and commands and telemetry pass over a link.

    A tick calls `listen`, `drive` and `send`, in this order. `listen` and `send` are also called between two ticks.
    """

    @property
    def ready(self) -> bool:
        """Whether the chair has accepted the current arming and obeys commands to move."""
        ...

    @property
    def inhibited(self) -> bool:
        """Whether the chair's stop switch is pressed, or the chair has a fault."""
        ...

    @property
    def stands(self) -> bool:
        """Whether the chair does not move by itself once it is commanded to stand."""
        ...

    @property
    def silent(self) -> bool:
        """Whether no telemetry has come from the chair for too long."""
        ...

    @property
    def switch_reported(self) -> bool:
        """Whether the stop switch was seen, or was reported in a way that the next arming has to confirm."""
        ...

    @property
    def document(self) -> str:
        """The first 16 hexadecimal digits of the chair document's SHA-256; empty: the chair tells of none."""
        ...

    @property
    def crawls(self) -> bool:
        """Whether the chair misses its document, and so drives at a crawl at most."""
        ...

    @property
    def due(self) -> float:
        """When the next command is to be sent (monotonic s), inf when none is."""
        ...

    def close(self) -> None:
        """Release the chair; closing twice does no harm."""
        ...

    def description(self) -> Text:
        """Return the chair's state in words."""
        ...

    def lost_key(self) -> Text | None:
        """Return why the chair's key counts no longer, None while it does."""
        ...

    def use_parameters(self, digest: bytes) -> None:
        """Name the parameter set of the next arming by the first 8 bytes of its SHA-256."""
        ...

    def longest_wait(self, deadline: float, t: float) -> float:
        """Return how long (s) after `t` the loop may wait before it serves the chair.

        `deadline` is when the loop's next tick is due (monotonic s).
        """
        ...

    def listen(self, t: float) -> None:
        """Take in the telemetry that has come up to `t` (monotonic s)."""
        ...

    def send(self, state: State, limits: Speeds, t: float) -> None:
        """Send the twist of the newest `drive`, when a command is due or the gate's `state` has changed.

        Unless `state` is ARMED, zeros are sent in its place.
        """
        ...

    def age(self, t: float) -> float:
        """Return how old (s) at `t` the knowledge of the chair is; inf when nothing is known."""
        ...

    def report(self, tick: Tick, t: float) -> None:
        """Write into a tick what the chair has reported of itself up to `t` (monotonic s)."""
        ...
