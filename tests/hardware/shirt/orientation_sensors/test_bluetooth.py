"""The shirt of Bluetooth sensors: finding them, connecting them again, and what it says; and its frames."""

import asyncio
import threading

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.orientation_sensors.fake_bleak import ANSWER, ASK_VOLTAGE, FakeBleak, wait_for
from hardware.shirt.shirts import RATE, BluetoothCase
from pydantic import ValidationError

from app.hardware.base import HardwareError, NetworkShirt, SearchingShirt
from app.hardware.shirt.orientation_sensors import bluetooth, bluetooth_links
from app.hardware.shirt.orientation_sensors.bluetooth import KIND, READY_LIMIT, BluetoothConfig, BluetoothShirt
from app.hardware.shirt.orientation_sensors.bluetooth_links import END_LIMIT, SensorNotification
from app.hardware.shirt.orientation_sensors.orientation_frames import REST_TIME
from app.hardware.shirt.orientation_sensors.witmotion import sensor_orientation
from app.pipeline.opening import OPENING_LIMIT
from app.texts import LANGUAGES, from_document, reader_language, to_document

FOREARM, TRUNK, OTHER = "A1:B2:C3:D4:E5:F6", "00:00:00:00:00:0A", "00:00:00:00:00:0B"


@pytest.fixture(autouse=True)
def short_pauses(monkeypatch):
    """Let the connections be checked at once, so that no test waits for them."""
    monkeypatch.setattr(bluetooth_links, "LOOK", 0.05)
    monkeypatch.setattr(bluetooth_links, "LOOK_AGAIN", 0.02)


@pytest.fixture
def source(tmp_path):
    made = BluetoothCase(tmp_path)
    made.shirt.open()
    yield made
    made.shirt.close()


def shirt_of(bleak, clock=None, **fields):
    return BluetoothShirt(BluetoothConfig(kind="bluetooth", **fields), clock or FakeClock(), lambda: bleak)


def test_two_sensors_at_once_each_turn_their_own_channels(short_pauses):
    clock, bleak = FakeClock(50.0), FakeBleak()
    trunk, forearm = bleak.add_sensor(TRUNK), bleak.add_sensor(FOREARM)
    shirt = shirt_of(bleak, clock, sample_rate=RATE, trunk=TRUNK, right_forearm=FOREARM.lower())
    shirt.open()
    frames = []
    for sensor in (trunk, forearm):
        sensor.wait_until_connected()
    for step in range(round(REST_TIME * RATE) + 50):
        forearm.angles = (0.0, 0.0, 0.4 * max(0.0, step - REST_TIME * RATE))
        for sensor in (trunk, forearm):
            sensor.send()
        clock.time += 1 / RATE
        frames += [frame for frame in [shirt.read(0.0)] if frame is not None]
    assert shirt.layout.joint_names == ["trunk", "right_elbow"]
    turned = np.rad2deg(frames[-1].values)
    np.testing.assert_allclose(turned, [0, 0, 0, 0, 0, 0.4 * 49], atol=0.05)
    assert (shirt.lost, shirt.repeated) == (0, 0)
    assert str(shirt.description()) == "Bluetooth: 2 of 2 send, 6 sensors."
    shirt.close()


def test_a_sensor_at_rest_may_repeat_its_angles_and_one_that_hangs_is_silent(source):
    """Safety S5: the layout says that its channels may stay constant, for the driver misses a sensor that hangs."""
    assert all(source.shirt.layout.may_stay_constant)
    source.let_come(1)
    frames = [source.shirt.read(0.0)]
    for _ in range(30):
        source.clock.time += 1 / RATE
        source.sensor.send()
        frames.append(source.shirt.read(0.0))
    np.testing.assert_allclose([frame.values for frame in frames], np.zeros((31, 3)), atol=1e-9)
    stuck = source.sensor.motion()
    for _ in range(10):
        source.clock.time += 1 / RATE
        source.sensor.send(stuck)
        frame = source.shirt.read(0.0)
    assert source.shirt.repeated == 9
    assert frame is None
    assert "9 messages repeated" in str(source.shirt.description())
    assert "Silent: Right forearm." in str(source.shirt.description())


def test_jitter_and_bursts_give_even_frames_and_a_loss_is_nan_after_three_periods(source):
    source.let_come(1)
    source.shirt.read(0.0)
    seqs, missing = [], []
    for step in range(60):
        source.clock.time += 1 / RATE
        if step % 3 == 0 and step < 40:
            for _ in range(3):  # as a radio hands on what it held back
                source.sensor.send()
        frame = source.shirt.read(0.0)
        if frame is None:
            missing.append(step)
        else:
            seqs.append(frame.seq)
    assert seqs == list(range(1, len(seqs) + 1))
    assert missing == list(range(missing[0], 60))  # with its only sensor lost, the shirt is silent
    assert 42 <= missing[0] <= 43


def test_junk_is_counted_and_moves_nothing(source):
    source.let_come(1)
    before = source.shirt.read(0.0).values
    for junk in (b"\x00", b"junk" * 5, b"\xff" * 64):
        source.sensor.send(junk)
    source.sensor.send(b"")
    source.clock.time += 1 / RATE
    np.testing.assert_array_equal(source.shirt.read(0.0).values, before)
    assert "3 messages refused" in str(source.shirt.description())


def test_a_sensor_that_was_off_is_connected_again_and_has_to_be_still_anew(source):
    source.let_come(1)
    assert source.shirt.read(0.0) is not None
    source.sensor.switch_off()
    source.clock.time += 0.2
    while source.shirt.read(0.0) is not None:
        """Take the frames in which its newest sample still counts."""
    assert "0 of 1 send" in str(source.shirt.description())
    source.sensor.switch_on()
    source.sensor.wait_until_connected()
    source.sensor.send()
    source.clock.time += 1 / RATE
    assert source.shirt.read(0.0) is None
    assert "Not yet at rest: Right forearm." in str(source.shirt.description())
    for _ in range(round(REST_TIME * RATE)):
        source.sensor.send()
        source.clock.time += 1 / RATE
        frame = source.shirt.read(0.0)
    assert frame is not None


def test_a_connection_that_sends_nothing_is_made_anew(source, monkeypatch):
    monkeypatch.setattr(bluetooth_links, "SILENT", 0.05)
    source.sensor.wait_until_connected()
    wait_for(lambda: source.sensor.connections > 1)


def test_a_connection_that_fails_is_tried_again_and_said(tmp_path):
    made = BluetoothCase(tmp_path)
    made.bleak.refusals = [OSError("in progress")] * 10_000
    made.shirt.open()
    wait_for(lambda: "(in progress)" in str(made.shirt.description()))
    made.bleak.refusals = []
    made.sensor.wait_until_connected()
    assert "(in progress)" not in str(made.shirt.description())
    made.shirt.close()


def test_sensors_are_set_up_and_asked_for_their_batteries(source):
    source.shirt.close()
    source.sensor.written, source.sensor.volts = [], 3.52
    source.shirt.open()
    wait_for(lambda: len(source.sensor.written) >= 3)
    assert [command.hex() for command in source.sensor.written] == ["ffaa6988b5", "ffaa030900", "ffaa276400"]
    wait_for(lambda: len(source.shirt._links.notifications) >= 2)
    source.shirt.read(0.0)
    assert "Battery almost empty: Right forearm. Charge it." in str(source.shirt.description())


def test_sensors_on_no_part_of_the_body_are_offered(source):
    source.shirt.close()
    source.bleak.add_sensor(OTHER)
    source.bleak.add_sensor("00:00:00:00:00:0C", name="Headphones")
    source.shirt.open()
    wait_for(lambda: source.shirt.found == [OTHER])
    source.shirt.read(0.0)
    assert f"On no part of the body: {OTHER}. Choose each" in str(source.shirt.description())
    assert isinstance(source.shirt, SearchingShirt)
    assert not isinstance(source.shirt, NetworkShirt)
    assert not KIND.is_on_network


def test_it_stops_looking_once_all_are_connected_and_goes_on_while_none_is_chosen(source):
    wait_for(lambda: source.shirt._links._has_looked)
    looks = source.bleak.looks
    threading.Event().wait(0.1)
    assert source.bleak.looks == looks
    bleak = FakeBleak()
    bleak.add_sensor(OTHER)
    empty = shirt_of(bleak)
    assert empty.layout.joint_names == ["trunk"]
    empty.open()
    wait_for(lambda: bleak.looks > 2)
    assert empty.found == [OTHER]
    empty.close()


def test_closing_disconnects_and_opening_connects_again(source):
    source.sensor.wait_until_connected()
    thread = source.shirt._links
    source.shirt.close()
    thread.join(ANSWER)
    assert not thread.is_alive()
    assert not source.sensor.is_connected
    assert source.shirt.found == []
    source.shirt.open()
    source.sensor.wait_until_connected()


def test_all_sensors_are_disconnected_at_once():
    """One after the other, hanging connections of ten sensors would outlast the opening of the next shirt."""
    bleak = FakeBleak()
    sensors = [bleak.add_sensor(TRUNK), bleak.add_sensor(FOREARM)]
    shirt = shirt_of(bleak, trunk=TRUNK, right_forearm=FOREARM)
    shirt.open()
    links = shirt._links
    wait_for(lambda: len(links.connected) == 2)
    bleak.ends = asyncio.Barrier(2)
    shirt.close()
    assert not links.is_alive()
    assert not any(sensor.is_connected for sensor in sensors)
    assert END_LIMIT + READY_LIMIT <= OPENING_LIMIT


def test_a_sensor_that_takes_no_question_for_its_battery_holds_nothing_up(tmp_path, monkeypatch):
    monkeypatch.setattr(bluetooth_links, "WRITE_LIMIT", 0.01)
    made = BluetoothCase(tmp_path)
    made.sensor.hangs = True
    made.shirt.open()
    wait_for(lambda: ASK_VOLTAGE in made.sensor.written)
    made.sensor.switch_off()
    made.sensor.switch_on()
    wait_for(lambda: made.sensor.connections > 1)
    made.shirt.close()


def test_after_a_pause_only_the_newest_angles_are_computed_and_those_before_a_new_connection_do_not_count(
    source, monkeypatch
):
    source.let_come(1)
    assert source.shirt.read(0.0) is not None
    computed = []

    def compute(*angles_deg):
        computed.append(angles_deg)
        return sensor_orientation(*angles_deg)

    monkeypatch.setattr(bluetooth, "sensor_orientation", compute)
    for _ in range(20):
        source.sensor.send()
    source.clock.time += 1 / RATE
    assert source.shirt.read(0.0) is not None
    assert len(computed) == 1
    source.sensor.send()
    source.shirt._links.notifications.append(SensorNotification(source.address, b"", source.clock.time))
    source.clock.time += 1 / RATE
    assert source.shirt.read(0.0) is None
    assert len(computed) == 1


def test_a_machine_without_bluetooth_or_without_bleak_is_one_honest_sentence():
    bleak = FakeBleak()
    bleak.failure = OSError("No Bluetooth adapters found.")
    with pytest.raises(HardwareError, match=r"Bluetooth cannot be used \(No Bluetooth adapters found\.\): check that"):
        shirt_of(bleak).open()

    def load():
        raise ModuleNotFoundError("No module named 'bleak'")

    shirt = BluetoothShirt(BluetoothConfig(kind="bluetooth"), FakeClock(), load)
    with pytest.raises(HardwareError, match=r"the library bleak \(No module.*pip install 'bodydrive\[bluetooth\]'"):
        shirt.open()
    assert str(shirt.description()) == "The Bluetooth sensors are not in use."
    assert not [thread for thread in threading.enumerate() if thread.name == "Bluetooth"]


def test_an_adapter_that_is_pulled_later_is_silence_and_said_until_it_is_back(source):
    source.sensor.wait_until_connected()
    source.bleak.failure = OSError("org.bluez.Error.NotReady")
    source.sensor.switch_off()
    wait_for(lambda: source.shirt._links.trouble)
    assert "(org.bluez.Error.NotReady)." in str(source.shirt.description())
    source.bleak.failure = None
    source.sensor.switch_on()
    source.sensor.wait_until_connected()
    wait_for(lambda: not source.shirt._links.trouble)


@pytest.mark.parametrize("name", ["", "left", "A1:B2", "A1:B2:C3:D4:E5:GG", f"{FOREARM}/1", "x" * 41])
def test_what_is_no_address_is_refused(name):
    with pytest.raises(ValidationError):
        BluetoothConfig(kind="bluetooth", head=name)


def test_an_address_is_a_bluetooth_address_or_the_uuid_of_macos_and_on_one_part():
    uuid = "243e23ae-4a99-406c-b317-18f1bd7b4cbe"
    config = BluetoothConfig(kind="bluetooth", head=f" {uuid} ", trunk=FOREARM.lower())
    assert config.sensors == {"trunk": FOREARM, "head": uuid.upper()}
    with pytest.raises(ValidationError, match="two parts"):
        BluetoothConfig(kind="bluetooth", head=FOREARM, trunk=FOREARM.lower())


@pytest.mark.parametrize("rate", [9.0, 101.0, float("nan")])
def test_a_rate_that_these_sensors_do_not_have_is_refused(rate):
    with pytest.raises(ValidationError):
        BluetoothConfig(kind="bluetooth", sample_rate=rate)


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_it_says_is_a_sentence_in_every_language(source, language):
    source.let_come(1)
    source.sensor.send(b"junk")
    source.shirt.read(0.0)
    with reader_language(language):
        sentence = str(from_document(to_document(source.shirt.description())))
    assert sentence.startswith("Bluetooth: ")
    assert sentence.endswith(".")
    assert "{" not in sentence
