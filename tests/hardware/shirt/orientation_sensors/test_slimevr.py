"""The shirt of SlimeVR's trackers: its configuration, its socket, and what it says."""

import pytest
from fake_clock import FakeClock
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker
from hardware.shirt.shirts import RATE, SlimeVrCase

from app.hardware.base import HardwareError, NetworkShirt
from app.hardware.registry import parse_shirt
from app.hardware.shirt.orientation_sensors.slimevr import KIND, SlimeVrConfig, SlimeVrShirt
from app.hardware.shirt.orientation_sensors.slimevr_packets import HANDSHAKE_REPLY, HEARTBEAT

MAC = "A1:B2:C3:D4:E5:F6"


@pytest.fixture
def source(tmp_path):
    made = SlimeVrCase(tmp_path)
    made.shirt.open()
    yield made
    made.shirt.close()
    made.end()


def answers(source):
    """Return what the shirt has sent to the tracker."""
    found = []
    while True:
        try:
            found.append(source.device.recv(100))
        except BlockingIOError:
            return found


def test_a_tracker_is_answered_and_gets_a_heartbeat_every_second(source):
    source.send(source.tracker.handshake())
    source.shirt.read(0.0)
    assert answers(source) == [HANDSHAKE_REPLY]
    for _ in range(5):
        source.clock.time += 1.0
        source.shirt.read(0.0)
    assert answers(source) == [HEARTBEAT] * 5


def test_it_says_who_is_silent_who_moves_and_which_sensors_are_on_nobody(source):
    assert str(source.shirt.description()) == (
        f"Trackers on 127.0.0.1:{source.shirt.address[1]}: 0 of 1 send, 3 sensors. "
        "Silent: Right forearm. Switch these on, and check their network."
    )
    stranger = SlimeTracker("00:00:00:00:00:0A", sensors=(1,))
    source.send(stranger.handshake())
    source.send(stranger.rotation(1))
    source.send(b"junk")
    source.shirt.read(0.0)
    assert source.shirt.found == ["00:00:00:00:00:0A/1"]
    assert "1 datagram refused" in str(source.shirt.description())
    assert "On no part of the body: 00:00:00:00:00:0A/1. Choose" in str(source.shirt.description())
    source.send(source.tracker.handshake())
    source.send(source.tracker.rotation())
    source.shirt.read(0.0)
    assert "1 of 1 send" in str(source.shirt.description())
    assert "Not yet at rest: Right forearm. Stay still" in str(source.shirt.description())
    source.send(source.tracker.battery(0.05))
    source.let_come(2)
    assert [source.shirt.read(0.0) for _ in range(2)][-1] is not None
    assert "Not yet at rest" not in str(source.shirt.description())
    assert "Battery almost empty: Right forearm." in str(source.shirt.description())


def test_a_flood_does_not_hold_up_the_frames(source):
    source.be_still()
    for _ in range(150):
        source.send(b"junk" * 10)
    source.send(source.tracker.rotation())
    source.clock.time += 1e-6
    assert source.shirt.read(0.0) is not None


def test_a_second_program_on_the_port_is_one_sentence(source):
    config = SlimeVrConfig(kind="slimevr", host="127.0.0.1", port=source.shirt.address[1])
    with pytest.raises(HardwareError, match=r"cannot be received on 127.0.0.1:\d+ .*: end the other program"):
        SlimeVrShirt(config, FakeClock()).open()


def test_people_choose_among_the_senders_of_a_tracker(source):
    assert KIND.is_on_network
    assert isinstance(source.shirt, NetworkShirt)
    assert source.shirt.lost_key() is None
    assert (source.shirt.sender_choice.name, source.shirt.sender_choice.other) == ("", "")
    assert not source.shirt.use_sender("10.0.0.1:6969")


def test_after_a_long_hold_up_the_frames_meanwhile_are_lost(source):
    source.let_come(1)
    assert source.shirt.read(0.0).seq == 0
    source.clock.time += 5.0
    source.send(source.tracker.rotation())
    frame = source.shirt.read(0.0)
    assert frame.seq == pytest.approx(5 * RATE, abs=1)
    assert source.shirt.lost == frame.seq - 1
    source.clock.time += 0.5  # a short one is made good
    source.send(source.tracker.rotation())
    assert source.shirt.read(0.0).seq == frame.seq + 1


def test_opening_it_again_begins_anew(source):
    source.let_come(1)
    assert source.shirt.read(0.0) is not None
    source.shirt.open()
    source.send(source.tracker.rotation())
    source.clock.time += 0.1
    assert source.shirt.read(0.0) is None, "the tracker has to greet, and to be still"
    assert source.shirt.lost == 0


def test_without_a_tracker_on_the_body_it_looks_for_some():
    shirt = SlimeVrShirt(SlimeVrConfig(kind="slimevr"), FakeClock())
    assert shirt.layout.joint_names == ["trunk"]
    assert (shirt.address, shirt.sample_rate) == (("0.0.0.0", 6969), 50.0)
    assert str(shirt.description()) == "Nothing listens for trackers."
    only_chair = SlimeVrShirt(SlimeVrConfig(kind="slimevr", chair=MAC), FakeClock())
    assert only_chair.layout.joint_names == ["trunk"]


@pytest.mark.parametrize(
    ("written", "name"),
    [
        (MAC.lower(), MAC),
        (f" {MAC}/0 ", MAC),
        (f"{MAC}/1", f"{MAC}/1"),
        (f"{MAC}/flex", f"{MAC}/flex"),
        (f"{MAC}/02/Flex", f"{MAC}/2/flex"),
    ],
)
def test_a_sensor_is_named_as_people_write_it(written, name):
    config = parse_shirt({"kind": "slimevr", "left_fingers": written})
    assert config.sensors == {"left_fingers": name}
    shirt = SlimeVrShirt(config, FakeClock())
    assert len(shirt.layout.channels) == (1 if name.endswith("flex") else 3)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"trunk": "A1:B2"}, "'A1:B2' is no tracker's address: write it like A1:B2:C3:D4:E5:F6"),
        ({"trunk": f"{MAC}/256"}, "is no tracker's address"),
        ({"trunk": MAC, "left_hand": MAC.lower()}, f"the sensor {MAC} is on two parts of the body"),
        ({"chair": f"{MAC}/flex"}, "has no orientation"),
        ({"nose": MAC}, "nose"),
        ({"sample_rate": 5}, "sample_rate"),
        ({"port": 70000}, "port"),
    ],
)
def test_a_wrong_configuration_is_one_sentence(fields, words):
    with pytest.raises(HardwareError) as refused:
        parse_shirt({"kind": "slimevr", **fields})
    assert words in str(refused.value)
    assert "\n" not in str(refused.value)


def test_the_form_names_each_part_of_the_body_and_measures_it_from_its_neighbour():
    form = SlimeVrConfig.model_json_schema()
    assert form["properties"]["from_neighbour"]["default"] is True
    assert form["properties"]["left_forearm"]["title"] == "Left forearm"
    assert form["properties"]["left_forearm"]["format"] == "tracker"
    assert form["properties"]["from_neighbour"]["title"] == "Measure each part from its neighbour"
    assert form["title"] == "Trackers (SlimeVR)"
