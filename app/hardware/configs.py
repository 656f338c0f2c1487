"""The configurations of shirts, simulated bodies, chairs and head trackers (docs/protocols.md, section 2)."""

from typing import Annotated, Literal

from pydantic import Field

from app.hardware.addresses import FilePlace, Host, SerialLine
from app.hardware.chair.packet import PORT
from app.hardware.shirt.standard import standard_layout
from app.layout import ShirtLayout
from app.quantities import Count, Document, Hertz, Name, Port, Title
from app.speeds import Speeds

ShirtRate = Annotated[Hertz, Field(ge=10, le=2000)]
ReceiverPort = Annotated[Port, Field(gt=0)]
RECEIVER_PORT = PORT


class SimulatorConfig(Document):
    """The simulated shirt."""

    kind: Literal["simulator"]
    sample_rate: ShirtRate = 100.0
    seed: Count = 1  # of the fabric: each seed is a different shirt
    layout: ShirtLayout | None = None  # None: the paper's 52 channels
    dead_channels: tuple[Name, ...] = ()  # names of channels with a broken line


class ReplayConfig(Document):
    """A shirt that replays a file."""

    kind: Literal["replay"]
    file: FilePlace
    loop: bool = True


class UdpConfig(Document):
    """A shirt that sends datagrams (docs/protocols.md, section 6)."""

    kind: Literal["udp"]
    host: Host = "127.0.0.1"  # the address of this machine that the shirt sends to
    port: Port = 5252  # 0: any free port
    layout: ShirtLayout = Field(default_factory=standard_layout)
    sample_rate: ShirtRate = 100.0
    key_file: FilePlace | None = None  # None: unsigned frames are accepted, and no real chair is armed


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
    port: Port = 4242  # 0: any free port


class FreepieConfig(Document):
    """FreePIE's UDP: 50 bytes a pose."""

    kind: Literal["freepie"]
    host: Host = "127.0.0.1"
    port: Port = 5555


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


ShirtConfig = Annotated[SimulatorConfig | ReplayConfig | UdpConfig, Field(discriminator="kind")]
BodyConfig = Annotated[PersonConfig | VisitorConfig | RecordedConfig, Field(discriminator="kind")]
ChairConfig = Annotated[VirtualChairConfig | RealChairConfig, Field(discriminator="kind")]
HeadConfig = Annotated[
    OpentrackConfig | FreepieConfig | FlockOfBirdsConfig | SimulatedHeadConfig | RecordedHeadConfig | TabletHeadConfig,
    Field(discriminator="kind"),
]
