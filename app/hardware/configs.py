"""The kinds of shirts; configurations of simulated bodies, chairs and head trackers (docs/protocols.md, section 2)."""

from collections.abc import Mapping
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field

from app.hardware.addresses import FilePlace, Host, SerialLine
from app.hardware.shirt import brainflow_board, camera, lsl, replay, serial_line, simulator, udp
from app.hardware.shirt.kind import ShirtConfig, ShirtKind
from app.hardware.shirt.orientation_sensors import bluetooth, phones, slimevr
from app.ports import FREEPIE_PORT, OPENTRACK_PORT, RECEIVER_PORT
from app.quantities import Count, Document, Port, Title
from app.speed_limits import Speeds

KINDS: tuple[ShirtKind[Any], ...] = (
    simulator.KIND,
    camera.KIND,
    phones.KIND,
    slimevr.KIND,
    bluetooth.KIND,
    serial_line.KIND,
    brainflow_board.KIND,
    lsl.KIND,
    udp.KIND,
    replay.KIND,
)
SHIRTS: Mapping[str, ShirtKind[Any]] = {kind.name: kind for kind in KINDS}
"""Every kind of shirt by its name."""

ReceiverPort = Annotated[Port, Field(gt=0)]
MOST_PHONES = phones.MOST_PHONES


class PersonConfig(Document):
    """A simulated person, who drives by himself."""

    kind: Literal["person"]
    skill: Literal["novice", "practised"] = "practised"
    seed: Count = 1


class VisitorConfig(Document):
    """A simulated body whose joints are moved by keys, pads or a gamepad."""

    kind: Literal["visitor"]


class RecordedConfig(Document):
    """A simulated body that repeats a recorded movement."""

    kind: Literal["recorded"]
    file: FilePlace


class VirtualChairConfig(Document):
    """The simulated chair."""

    kind: Literal["virtual"]
    dynamics: Literal["unicycle", "wheelchair"] = "unicycle"


class RealChairConfig(Document):
    """A chair behind a receiver (docs/protocols.md, section 9)."""

    kind: Literal["udp"]
    name: Title
    host: Host
    port: ReceiverPort = RECEIVER_PORT
    key_file: FilePlace
    speeds: Speeds  # the chair's own limits


class OpentrackConfig(Document):
    """opentrack's "UDP over network": 48 bytes a pose."""

    kind: Literal["opentrack"]
    host: Host = "127.0.0.1"  # the address of this machine that the tracker sends to
    port: Port = OPENTRACK_PORT  # 0: any free port


class FreepieConfig(Document):
    """FreePIE's UDP: 50 bytes a pose."""

    kind: Literal["freepie"]
    host: Host = "127.0.0.1"
    port: Port = FREEPIE_PORT


class FlockOfBirdsConfig(Document):
    """Ascension's Flock of Birds on a serial line."""

    kind: Literal["flock_of_birds"]
    device: SerialLine  # such as /dev/ttyUSB0
    baud: Annotated[int, Field(strict=True, ge=2400, le=115_200)] = 115_200
    address: Annotated[int, Field(strict=True, ge=1, le=14)] | None = None  # in a group of units; None: a single unit


class SimulatedHeadConfig(Document):
    """A simulated head that looks around."""

    kind: Literal["simulator"]
    seed: Count = 1


class RecordedHeadConfig(Document):
    """A head that repeats a recorded movement: a CSV with t, yaw_deg, pitch_deg, roll_deg."""

    kind: Literal["recorded"]
    file: FilePlace
    loop: bool = True


class TabletHeadConfig(Document):
    """The orientation of a tablet or phone, reported by its page."""

    kind: Literal["tablet"]


if TYPE_CHECKING:
    AnyShirtConfig = ShirtConfig
else:
    AnyShirtConfig = Annotated[reduce(or_, (kind.config for kind in KINDS)), Field(discriminator="kind")]
BodyConfig = Annotated[PersonConfig | VisitorConfig | RecordedConfig, Field(discriminator="kind")]
ChairConfig = Annotated[VirtualChairConfig | RealChairConfig, Field(discriminator="kind")]
HeadConfig = Annotated[
    OpentrackConfig | FreepieConfig | FlockOfBirdsConfig | SimulatedHeadConfig | RecordedHeadConfig | TabletHeadConfig,
    Field(discriminator="kind"),
]
