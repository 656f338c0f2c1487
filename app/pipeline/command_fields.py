"""The fields of each command (docs/protocols.md, section 1)."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from app.calibration.vocabulary import DriveParameters
from app.cues import Cue
from app.json_values import JsonDocument
from app.messages import LONGEST_SAMPLE
from app.pipeline.open_run import RunKind
from app.quantities import Count, Document, Finite, Fraction, Name, Radians, Seconds
from app.speed_limits import Speeds
from app.world.cursor_task import CursorPlan
from app.world.floorplan import FloorPlan

Folder = Annotated[str, Field(min_length=1, max_length=4096, pattern=r"^/[^\x00]*$")]  # absolute
Share = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.1, le=1)]
MAX_CUES = 1000


class Nothing(Document):
    """A command without fields."""


class Heartbeat(Document):
    """A sign of life of the web process; the age of the arming screen's last report (None: it is gone), its state."""

    screen_age: Seconds | None
    screen: Literal["in view", "hidden", "slow"] = "in view"


class Device(Document):
    """The configuration of a shirt, a body or a chair, which the registry checks."""

    config: JsonDocument


class HeadDevice(Document):
    """The configuration of a head tracker, which the registry checks; None: no head tracker."""

    config: JsonDocument | None


class Look(Document):
    """The orientation that a tablet reports."""

    yaw: Radians
    pitch: Radians
    roll: Radians


class Sample(Document):
    """What the page that is the sensor has sent: the number of that page, its message, and when it came."""

    page: Count
    message: Annotated[str, Field(max_length=2 * LONGEST_SAMPLE, pattern=r"^([0-9a-f]{2})*$")]  # hex
    received: Finite  # monotonic s


class Sender(Document):
    """The sender whose frames count as the shirt's from now on."""

    sender: Annotated[str, Field(min_length=1, max_length=100)]  # HOST:PORT, as `status` names it


class Move(Document):
    """Targets for the joints of the simulated body, from the visitor's keys."""

    joints: dict[Name, Fraction]


class Parameters(Document):
    """The parameters to drive with."""

    parameters: DriveParameters | None


class World(Document):
    """The floor plan and the path to drive."""

    floorplan: FloorPlan | None
    path: Name | None = None


class Limits(Document):
    """The limits of the clinic's owner."""

    clinic: Speeds


class Dial(Document):
    """The share of forward, reverse and turn speed to drive at."""

    share: Share


class RunFields(Document):
    """The run to record."""

    run_id: Name
    folder: Folder
    kind: RunKind
    cues: Annotated[tuple[Cue, ...], Field(max_length=MAX_CUES)] = ()
    meta: JsonDocument = Field(default_factory=dict)
    test: CursorPlan | None = None  # of an interface test, which no other kind of run has

    @model_validator(mode="after")
    def _test_of_its_kind(self) -> Self:
        if (self.kind == "interface_test") != (self.test is not None):
            raise ValueError("a run of kind interface_test, and no other, has the plan of a test")
        return self


class Arm(Document):
    """Arm with the parameters, and the chair document, of this hash."""

    hash: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]


class Stop(Document):
    """The origin of a stop; `picture`: the web process, because a screen has no current picture to drive by."""

    by: Literal["tablet", "key", "picture"] = "tablet"


class Clear(Document):
    """Clear a latched fault; `stops` is the count of stops that the person saw on the screen."""

    stops: Count
