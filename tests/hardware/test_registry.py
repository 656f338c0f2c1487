import re

import pytest
from fake_clock import FakeClock
from hardware.shirt.shirts import small_layout
from pydantic import ValidationError

from app.hardware.base import HardwareError
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.visitor import Visitor
from app.hardware.configs import SHIRTS, PersonConfig, VirtualChairConfig, VisitorConfig
from app.hardware.registry import (
    BODIES,
    CHAIRS,
    HEADS,
    driver_class,
    make_body,
    make_real_chair,
    make_shirt,
    parse_body,
    parse_chair,
    parse_shirt,
)
from app.hardware.shirt import kind as shirt_kind
from app.hardware.shirt.kind import NO_CABLE, NO_KEY, NOBODY_PROVES_IT, NOBODY_WEARS_IT, ShirtKind, Trust
from app.hardware.shirt.orientation_sensors.body_parts import layout_of
from app.hardware.shirt.replay import ReplayConfig
from app.hardware.shirt.simulator import SimulatorConfig
from app.hardware.shirt.udp import UdpConfig, UdpShirt


@pytest.mark.parametrize(("role", "table"), [("body", BODIES), ("chair", CHAIRS), ("head", HEADS)])
def test_every_word_of_the_tables_has_its_class(role, table):
    for word, driver in table.items():
        assert driver_class(role, word, table).__name__ == driver[1]


def test_each_reason_for_having_no_driver_has_its_own_sentence(tmp_path, monkeypatch):
    (tmp_path / "needs_a_library.py").write_text("import a_library_nobody_has\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    table = {
        "lsl": ("needs_a_library", "LslShirt"),
        "gone": ("app.hardware.shirt.gone", "GoneShirt"),
        "empty": ("app.hardware.base", "NoSuchShirt"),
    }
    sentences = []
    for word in ("unheard-of", *table):
        with pytest.raises(HardwareError) as refused:
            driver_class("shirt", word, table)
        sentences.append(str(refused.value))
    assert "use one of lsl, gone, empty" in sentences[0]
    assert "needs the library 'a_library_nobody_has', which is not installed" in sentences[1]
    assert "app.hardware.shirt.gone" in sentences[2]
    assert "has no class NoSuchShirt" in sentences[3]
    assert len(set(sentences)) == 4
    assert all("\n" not in sentence for sentence in sentences)


def test_every_source_of_frames_declares_whether_it_may_arm_a_real_chair(monkeypatch):
    """Safety S29: whoever adds a kind of shirt, or changes its trust, changes this table."""
    monkeypatch.setattr(shirt_kind, "is_cable", lambda line: line == "/dev/ttyACM0")
    assert {kind.name: (kind.trust, kind.simulated) for kind in SHIRTS.values()} == {
        "simulator": (Trust.NEVER, True),
        "camera": (Trust.NEVER, False),
        "phones": (Trust.NEVER, False),
        "slimevr": (Trust.NEVER, False),
        "bluetooth": (Trust.NEVER, False),
        "serial": (Trust.WIRED, False),
        "brainflow": (Trust.NEVER, False),
        "lsl": (Trust.NEVER, False),
        "udp": (Trust.WITH_KEY, False),
        "replay": (Trust.NEVER, True),
    }
    udp = {"kind": "udp", "layout": small_layout().model_dump(mode="json")}
    for document, why in (
        ({"kind": "simulator"}, NOBODY_WEARS_IT),
        ({"kind": "camera"}, NOBODY_PROVES_IT),
        ({"kind": "phones"}, NOBODY_PROVES_IT),
        ({"kind": "slimevr"}, NOBODY_PROVES_IT),
        ({"kind": "bluetooth"}, NOBODY_PROVES_IT),
        ({"kind": "serial"}, None),
        ({"kind": "brainflow", "serial_port": "/dev/ttyUSB0"}, NOBODY_PROVES_IT),  # the dongle of a radio, mostly
        ({"kind": "serial", "device": "/dev/pts/3"}, NO_CABLE),
        ({"kind": "lsl"}, NOBODY_PROVES_IT),
        (udp, NO_KEY),
        ({**udp, "key_file": "shirt-1.key"}, None),
        ({"kind": "replay", "file": "a"}, NOBODY_WEARS_IT),
    ):
        assert SHIRTS[document["kind"]].mistrust(parse_shirt(document)) == why
    assert "bodydrive shirt pair" in str(NO_KEY)


@pytest.mark.parametrize("kind", ["udp", "serial", "lsl"])
def test_no_layout_that_people_bring_says_that_a_sensor_may_stay_constant(kind):
    """Safety S5: only a driver that misses its sensors may say so."""
    layout = layout_of("trackers", ["trunk"])
    assert all(layout.may_stay_constant)
    config = parse_shirt({"kind": kind, "layout": layout.model_dump(mode="json")})
    assert config.layout.may_stay_constant == [False] * 3
    assert config.layout.channel_names == layout.channel_names


def test_a_source_that_declares_nothing_arms_no_real_chair():
    kind = ShirtKind(UdpConfig, UdpShirt)
    assert kind.mistrust(UdpConfig(kind="udp", key_file="shirt-1.key")) == NOBODY_PROVES_IT
    assert ShirtKind(UdpConfig, UdpShirt, Trust.WIRED).mistrust(UdpConfig(kind="udp")) == NO_CABLE


def test_a_missing_file_is_a_sentence_of_its_own(tmp_path):
    shirt = make_shirt(ReplayConfig(kind="replay", file=str(tmp_path / "none.csv")), FakeClock())
    with pytest.raises(HardwareError, match="there is no such file"):
        shirt.open()
    with pytest.raises(HardwareError, match="there is no such file"):
        make_body(parse_body({"kind": "recorded", "file": str(tmp_path / "none.csv")}))


def test_the_documents_of_the_protocol_are_understood():
    layout = small_layout().model_dump(mode="json")
    simulated = {"kind": "simulator", "sample_rate": 100, "seed": 1, "layout": None, "dead_channels": ["a"]}
    assert parse_shirt(simulated).dead_channels == ("a",)
    assert parse_shirt({"kind": "replay", "file": "runs/7", "loop": True}).loop
    udp = {"kind": "udp", "host": "127.0.0.1", "port": 5252, "layout": layout, "sample_rate": 100}
    assert parse_shirt(udp).layout == small_layout()
    assert len(parse_shirt({"kind": "udp"}).layout.channels) == 52  # the standard shirt's
    wired = parse_shirt({"kind": "serial", "device": "/dev/ttyUSB0", "baud": 2_000_000, "format": "lines"})
    assert (wired.device, wired.sample_rate, len(wired.layout.channels)) == ("/dev/ttyUSB0", 100.0, 52)
    assert parse_body({"kind": "person", "skill": "novice", "seed": 1}) == PersonConfig(kind="person", skill="novice")
    assert parse_body({"kind": "visitor"}) == VisitorConfig(kind="visitor")
    assert parse_body({"kind": "recorded", "file": "body.csv"}).file == "body.csv"
    assert parse_chair({"kind": "virtual"}) == VirtualChairConfig(kind="virtual", dynamics="unicycle")
    speeds = {"forward": 0.5}
    real = parse_chair({"kind": "udp", "name": "Salon 2", "host": "chair.lan", "key_file": "7.key", "speeds": speeds})
    assert (real.port, real.speeds.forward, real.speeds.reverse) == (5354, 0.5, 0.3)
    assert make_real_chair(real).speeds == real.speeds


@pytest.mark.parametrize(
    ("document", "words"),
    [
        (None, f'needs a "kind": give one of {", ".join(SHIRTS)}'),
        ({}, 'needs a "kind"'),
        ({"kind": "silk"}, f"no shirt of the kind 'silk': use one of {', '.join(SHIRTS)}"),
        ({"kind": "simulator", "sample_rate": float("nan")}, "sample_rate"),
        ({"kind": "simulator", "sample_rate": 1}, "sample_rate"),
        ({"kind": "simulator", "sample_rate": "100"}, "sample_rate"),
        ({"kind": "simulator", "colour": "red"}, "colour"),
        ({"kind": "replay"}, "file"),
        ({"kind": "serial", "device": "/dev/zero"}, "device"),
        ({"kind": "serial", "baud": 9600}, "baud"),
        ({"kind": "serial", "baud": True}, "baud"),
        ({"kind": "serial", "format": "cobs"}, "format"),
        ({"kind": "udp", "port": 70_000, "layout": small_layout().model_dump()}, "port"),
        ({"kind": "udp", "host": "a host", "layout": small_layout().model_dump()}, "host"),
        ({"kind": "udp", "layout": None}, "layout"),
    ],
)
def test_a_configuration_that_is_none_is_one_sentence_that_names_the_place(document, words):
    with pytest.raises(HardwareError, match=re.escape(words)) as refused:
        parse_shirt(document)
    assert "\n" not in str(refused.value)


def test_what_is_made_is_what_was_asked_for():
    assert make_shirt(SimulatorConfig(kind="simulator", sample_rate=250.0), FakeClock()).sample_rate == 250.0
    assert isinstance(make_body(VisitorConfig(kind="visitor")), Visitor)
    assert isinstance(make_body(PersonConfig(kind="person", skill="practised", seed=3)), SimulatedPerson)


def test_configurations_are_never_changed():
    with pytest.raises(ValidationError):
        SimulatorConfig(kind="simulator").seed = 2
