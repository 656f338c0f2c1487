"""The sources that are tried: how each is chosen on the Shirt page, and its far end."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from sources_tried.far_ends import (
    ADDRESSES,
    EACH,
    PHONES,
    BluetoothEnd,
    BoardEnd,
    CameraEnd,
    FarEnd,
    FramesEnd,
    LinesEnd,
    LslEnd,
    PhonesEnd,
    TrackersEnd,
    UdpEnd,
)

STANDARD = 52  # sensors of the paper's shirt
STRETCH = 4 * EACH
TURNED = 3 * len(ADDRESSES)  # channels of sensors of orientation
NONE: Mapping[str, str] = MappingProxyType({})


class Source(NamedTuple):
    """A source of movements."""

    name: str  # of its photographs, and on the command line
    title: str  # of its card
    recorded: str  # what the result calls it
    far_end: type[FarEnd]
    lamps: int  # so many at least are good
    fields: Mapping[str, str] = NONE  # what is filled in, by the label; {NAME} stands for a fact of the far end
    places: Mapping[str, str] = NONE  # the sensor of each part of the body, by the label: chosen once they are found
    phones: int = 0  # how many are paired, before they have places
    is_short: bool = False  # by the button of a demonstration and the short calibration: with the fewest taps
    library: str = ""  # of Python, without which it cannot be tried


def placed(sensors: Mapping[str, str]) -> Mapping[str, str]:
    """Return the sensors by the labels of the parts that they are on."""
    return {part.replace("_", " ").capitalize(): name for part, name in sensors.items()}


SOURCES = (
    Source(
        name="udp",
        title="A shirt over the network",
        recorded="Worn shirt, virtual chair",
        far_end=UdpEnd,
        lamps=STANDARD,
        fields={"Port": "{port}"},
    ),
    Source(
        name="frames",
        title="A shirt on a cable",
        recorded="Worn shirt on a cable, virtual chair",
        far_end=FramesEnd,
        lamps=STANDARD,
        fields={"Serial line": "{line}", "Format": "frames"},
    ),
    Source(
        name="lines",
        title="A shirt on a cable",
        recorded="Worn shirt on a cable, virtual chair",
        far_end=LinesEnd,
        lamps=STRETCH,
        fields={"Serial line": "{line}", "Format": "lines", "Layout from a file": "{layout}"},
    ),
    Source(
        name="slimevr",
        title="Trackers (SlimeVR)",
        recorded="Worn trackers, virtual chair",
        far_end=TrackersEnd,
        lamps=TURNED,
        fields={"Listen on": "127.0.0.1", "Port": "{port}"},
        places=placed(ADDRESSES),
    ),
    Source(
        name="bluetooth",
        title="Sensors over Bluetooth (WitMotion)",
        recorded="Worn Bluetooth sensors, virtual chair",
        far_end=BluetoothEnd,
        lamps=TURNED,
        places=placed(ADDRESSES),
    ),
    Source(
        name="phones",
        title="Phones as sensors",
        recorded="Worn phones, virtual chair",
        far_end=PhonesEnd,
        lamps=TURNED,
        fields={"Frames a second": "20"},
        places=placed(PHONES),
        phones=len(PHONES),
    ),
    Source(
        name="camera",
        title="A camera",
        recorded="Camera, virtual chair",
        far_end=CameraEnd,
        lamps=4,  # what else is seen of a person depends on the picture
        is_short=True,
        library="skimage",
    ),
    Source(
        name="lsl",
        title="Streams of the Lab Streaming Layer",
        recorded="Signals over LSL, virtual chair",
        far_end=LslEnd,
        lamps=STRETCH,
        fields={"Source ID": "{stream}"},
        library="pylsl",
    ),
    Source(
        name="brainflow",
        title="A board (BrainFlow)",
        recorded="Worn board (BrainFlow), virtual chair",
        far_end=BoardEnd,
        lamps=STRETCH,
        fields={"Data": "analog", "Layout from a file": "{layout}"},
    ),
)
