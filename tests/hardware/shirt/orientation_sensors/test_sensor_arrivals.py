"""What arrives at a shirt of sensors on the body: the verdict on phones, trackers and Bluetooth sensors."""

from fake_clock import FakeClock
from hardware.shirt.orientation_sensors.fake_bleak import wait_for
from hardware.shirt.orientation_sensors.phone_page import PhonePage
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker
from hardware.shirt.shirts import SILENCE, BluetoothCase, PhonesCase, SlimeVrCase, said

from app.hardware.shirt.orientation_sensors import bluetooth_links
from app.hardware.shirt.orientation_sensors.orientation_frames import REST_TIME
from app.hardware.shirt.orientation_sensors.phones import PhonesConfig, PhonesShirt
from app.messages import ALIVE

STRANGER = "00:00:00:00:00:0A"


def test_phones_say_why_they_show_nothing(opened):
    source = opened(PhonesCase)
    assert said(source.shirt)[0] == "nothing"
    PhonePage(source.shirt, source.clock, number=2).send()
    verdict, message = said(source.shirt)
    assert verdict == "unplaced"
    assert message.startswith("On no part of the body: phone 2.")
    source.shirt.add_sample(9, b"hello", source.clock.now())
    assert said(source.shirt)[0] == "foreign"
    source.page.send()
    verdict, message = said(source.shirt)
    assert verdict == "moving"
    assert message.startswith("Not yet at rest: Right forearm.")
    for _ in range(4):
        source.clock.time += SILENCE / 4
        source.page.send(delay=0.9)
    verdict, message = said(source.shirt)
    assert verdict == "late"
    assert message.startswith("Messages of the phones arrive 0.9 s late")


def test_trackers_say_why_they_show_nothing(opened):
    source = opened(SlimeVrCase)
    place = f"127.0.0.1:{source.shirt.address[1]}"
    verdict, message = said(source.shirt)
    assert verdict == "nothing"
    assert message.startswith(f"Nothing at all arrives at {place}. Only programs on this machine")
    stranger = SlimeTracker(STRANGER)
    for datagram, expected, words in (
        (stranger.handshake(), "idle", "A tracker answers, but no movement comes from it."),
        (b"junk", "foreign", "1 packet arrived that is no frame of this shirt. It has 4 bytes"),
        (stranger.rotation(), "unplaced", "On no part of the body: 00:00:00:00:00:0A."),
        (stranger.packet(0), "unplaced", "On no part of the body: 00:00:00:00:00:0A."),
        (source.tracker.handshake(), "unplaced", "On no part of the body: 00:00:00:00:00:0A."),
        (source.tracker.rotation(), "moving", "Not yet at rest: Right forearm."),
    ):
        source.send(datagram)
        source.shirt.read(0.0)
        verdict, message = said(source.shirt)
        assert (verdict, message.startswith(words)) == (expected, True), message


def test_a_part_whose_sensor_sends_nothing_is_named_while_others_send():
    clock = FakeClock(50.0)
    shirt = PhonesShirt(PhonesConfig(kind="phones", trunk="1", right_forearm="2"), clock)
    trunk, forearm = PhonePage(shirt, clock), PhonePage(shirt, clock, number=2)
    shirt.open()

    def send(seconds, *pages):
        """Let pages send for some time, and return what the shirt says."""
        for _ in range(round(seconds * shirt.sample_rate)):
            clock.time += 1 / shirt.sample_rate
            for page in pages:
                page.send()
            shirt.read(0.0)
        return said(shirt)

    assert send(0.1, trunk) == ("partial", "Signals arrive, but none from: Right forearm. Switch the sensor there on.")
    assert send(0.1, trunk, forearm)[0] == "moving"
    assert send(2 * REST_TIME, trunk, forearm)[0] == "arrives"
    assert send(ALIVE, trunk)[0] == "arrives", "a held-up network is no silence"
    assert send(0.1, trunk)[0] == "partial"


def test_a_tracker_that_sends_nothing_while_it_lies_still_is_said_to_do_so(opened):
    source = opened(SlimeVrCase, trunk=STRANGER)
    source.be_still()
    verdict, message = said(source.shirt)
    assert verdict == "partial"
    assert message.startswith("Signals arrive, but none from: Trunk. Switch the tracker there on. One that sends only")


def at_once(monkeypatch):
    """Let Bluetooth's connections be checked at once, so that no test waits for them."""
    monkeypatch.setattr(bluetooth_links, "LOOK", 0.05)
    monkeypatch.setattr(bluetooth_links, "LOOK_AGAIN", 0.02)


def test_bluetooth_sensors_say_why_they_show_nothing(opened, monkeypatch):
    at_once(monkeypatch)
    source = opened(BluetoothCase)
    links = source.shirt._links

    def sends(content=None):
        """Let the sensor send, and return what the shirt says of it."""
        source.sensor.send(content)
        source.shirt.read(0.0)
        return said(source.shirt)

    wait_for(lambda: links.connected)
    assert said(source.shirt)[0] == "idle"
    verdict, message = sends(b"junk")
    assert verdict == "foreign"
    assert message.startswith("1 message arrived that such a sensor does not send")
    frame = source.sensor.motion()
    verdict, message = sends(frame)
    assert verdict == "moving"
    assert message.startswith("Not yet at rest: Right forearm.")
    source.clock.time += SILENCE
    verdict, message = sends(frame)
    assert verdict == "repeated"
    assert message.startswith("A sensor sends one measurement again and again")
    assert source.shirt.arrivals()[2:] == (1, 2)


def test_bluetooth_sensors_that_cannot_be_reached_say_what_to_do(opened, monkeypatch):
    at_once(monkeypatch)
    source = opened(BluetoothCase)
    links = source.shirt._links
    wait_for(lambda: links.connected)
    source.sensor.switch_off()
    wait_for(lambda: not links.connected)
    verdict, message = said(source.shirt)
    assert verdict == "nothing"
    assert message.startswith("No sensor is in reach: switch them on")
    source.bleak.add_sensor("00:00:00:00:00:0A")
    wait_for(lambda: source.shirt.found)
    verdict, message = said(source.shirt)
    assert verdict == "unplaced"
    assert message.startswith("Silent: Right forearm.")
    assert "On no part of the body: 00:00:00:00:00:0A." in message
    source.bleak.failure = OSError("org.bluez.Error.NotReady")  # the adapter was pulled
    wait_for(lambda: links.trouble)
    verdict, message = said(source.shirt)
    assert verdict == "nothing"
    assert message.startswith("Nothing arrives over Bluetooth (org.bluez.Error.NotReady): see that")


def test_a_bluetooth_sensor_that_sends_too_seldom_is_named(opened, monkeypatch):
    at_once(monkeypatch)
    source = opened(BluetoothCase)
    source.sensor.wait_until_connected()
    for _ in range(120):
        source.clock.time += 1 / 20
        source.sensor.send()
        source.shirt.read(0.0)
    verdict, message = said(source.shirt)
    assert verdict == "rate"
    assert message.startswith("Right forearm: its sensor sends 20 times a second, too few for 100 frames.")
    source.clock.time += SILENCE
    assert said(source.shirt)[0] != "rate"
