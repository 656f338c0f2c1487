"""The sources of recordings: in their headers, and in words."""

import pytest

from app.hardware.configs import SHIRTS
from app.hardware.registry import BODIES, CHAIRS
from app.source import (
    NAMED_BODIES,
    NAMED_CHAIRS,
    NAMED_SHIRTS,
    UNKNOWN_SOURCE,
    Source,
    source_description,
    source_group,
    source_of_header,
)


def test_every_source_declares_whether_it_is_simulated_and_has_its_words() -> None:
    assert all(isinstance(driver.simulated, bool) for driver in SHIRTS.values())
    assert {kind for kind, driver in SHIRTS.items() if driver.simulated} == {"simulator", "replay"}
    assert {*SHIRTS, "unknown"} == NAMED_SHIRTS
    assert set(BODIES) == NAMED_BODIES
    assert {*CHAIRS, "unknown"} == NAMED_CHAIRS


def test_a_kind_of_shirt_that_measures_in_another_way_is_a_group_of_its_own() -> None:
    """Safety S26: whoever adds a kind of shirt changes this table."""
    assert {kind: source_group(kind, driver.simulated) for kind, driver in SHIRTS.items()} == {
        "simulator": "simulated",
        "camera": "camera",
        "phones": "phones",
        "slimevr": "slimevr",
        "bluetooth": "bluetooth",
        "serial": "worn",
        "brainflow": "brainflow",
        "lsl": "lsl",
        "udp": "worn",
        "replay": "simulated",
    }
    assert (source_group("camera", True), source_group("camera", None)) == ("simulated", "unknown")


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (Source(shirt="simulator", body="person", chair="virtual", simulated=True),
         "Simulated shirt (simulated person), virtual chair: practice only"),
        (Source(shirt="replay", body=None, chair="virtual", simulated=True),
         "Recorded signals, virtual chair: practice only"),
        (Source(shirt="udp", body=None, chair="udp", simulated=False), "Worn shirt, real chair"),
        (Source(shirt="serial", body=None, chair="udp", simulated=False), "Worn shirt on a cable, real chair"),
        (Source(shirt="lsl", body=None, chair="virtual", simulated=False), "Signals over LSL, virtual chair"),
        (Source(shirt="camera", body=None, chair="virtual", simulated=False), "Camera, virtual chair"),
        (Source(shirt="brainflow", body=None, chair="virtual", simulated=False),
         "Worn board (BrainFlow), virtual chair"),
        (Source(shirt="new", body=None, chair="virtual", simulated=False), "Shirt of the kind 'new', virtual chair"),
        (UNKNOWN_SOURCE, "Shirt not recorded, chair not recorded"),
    ],
)  # fmt: skip
def test_a_source_is_said_in_words(source: Source, words: str) -> None:
    assert source_description(source) == words


def test_the_header_of_a_recording_tells_its_source_and_a_damaged_one_does_not() -> None:
    source = Source(shirt="udp", body=None, chair="virtual", simulated=False)
    assert source_of_header({"source": source.model_dump(mode="json"), "dynamics": None}) == source
    assert source_of_header({}) == UNKNOWN_SOURCE
    assert source_of_header({"source": {"shirt": 7}, "dynamics": None}) == UNKNOWN_SOURCE
