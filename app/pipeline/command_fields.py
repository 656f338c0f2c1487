"""The fields of each command (docs/protocols.md, section 1)."""

from typing import Annotated, Any, Literal

from pydantic import Field

from app.calibration.vocabulary import DriveParameters
from app.cues import Cue
from app.pipeline.open_run import RunKind
from app.quantities import Count, Document, Fraction, Name, Radians, Seconds
from app.speeds import Speeds
from app.world.floorplan import FloorPlan

Folder = Annotated[str, Field(min_length=1, max_length=4096, pattern=r"^/[^\x00]*$")]  # absolute
Share = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.1, le=1)]
MAX_CUES = 1000


class Nothing(Document):
    """A command without fields."""


class Heartbeat(Document):
    """The web process lives; how long ago the screen that armed the chair spoke (None: it is gone), and how it is."""

    screen_age: Seconds | None
    screen: Literal["in view", "hidden", "slow"] = "in view"


class Device(Document):
    """A shirt, a body or a chair; the registry looks into the configuration."""

    config: dict[str, Any]


class Head(Document):
    """A head tracker, None for none; the registry looks into the configuration."""

    config: dict[str, Any] | None


class Look(Document):
    """Where a tablet looks, as it tells."""

    yaw: Radians
    pitch: Radians
    roll: Radians


class Sender(Document):
    """Another sender that is the shirt from now on."""

    sender: Annotated[str, Field(min_length=1, max_length=100)]  # HOST:PORT, as `status` names it


class Move(Document):
    """Where the visitor wants the joints of the simulated body."""

    joints: dict[Name, Fraction]


class Parameters(Document):
    """What to drive with."""

    parameters: DriveParameters | None


class World(Document):
    """Where to drive."""

    floorplan: FloorPlan | None
    path: Name | None = None


class Limits(Document):
    """What the clinic's owner allows."""

    clinic: Speeds


class Dial(Document):
    """Which share of forward, reverse and turn speed to drive at."""

    share: Share


class Run(Document):
    """What to record."""

    run_id: Name
    folder: Folder
    kind: RunKind
    cues: Annotated[tuple[Cue, ...], Field(max_length=MAX_CUES)] = ()
    meta: dict[str, Any] = Field(default_factory=dict)


class Arm(Document):
    """Permit motion with the parameters of this hash."""

    hash: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]


class Stop(Document):
    """Who stopped the chair; `picture`: the web process, because a screen has no picture to drive by."""

    by: Literal["tablet", "key", "picture"] = "tablet"


class Clear(Document):
    """Let go of a latched fault; how many stops there had been when the person looked."""

    stops: Count
