"""What arrives at a shirt: the verdict of each driver on what its far end sends, and what it says is to be done."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.camera_page import CHANNELS
from hardware.shirt.shirts import (
    RATE,
    SHIRTS,
    SILENCE,
    CameraCase,
    FedBoard,
    FramesCase,
    LinesCase,
    LslCase,
    ReplayedCase,
    SimulatedCase,
    UdpCase,
    said,
    small_layout,
)

from app.arrivals import Arrivals, arrivals_from
from app.hardware.base import HardwareError, ReportingShirt
from app.hardware.chair.key import new_key
from app.hardware.registry import make_shirt, parse_shirt
from app.hardware.shirt.packet import encode
from app.hardware.shirt.sender import signed_frame
from app.hardware.shirt.udp import UdpConfig, UdpShirt
from app.session.equipment.pairing import pair_shirt, shirt_key_file
from app.texts import Text, to_document

SHORT = 0.05  # s for which a shirt waits for what is there already
WAIT = 2.0  # s
REPORTING = [made for made in SHIRTS if made is not SimulatedCase]


class SteadyUdpCase(UdpCase):
    """The shirt over UDP on a fake clock; its datagrams are real."""

    def __init__(self, tmp_path, **config):
        super().__init__(tmp_path)
        self.clock = FakeClock(50.0)
        config = UdpConfig(kind="udp", port=0, layout=small_layout(), sample_rate=RATE, **config)
        self.shirt = UdpShirt(config, self.clock)


# Of every driver.


@pytest.fixture(params=REPORTING, ids=lambda made: made.__name__)
def source(request, tmp_path):
    case = request.param(tmp_path)
    yield case
    case.shirt.close()
    case.end()


def test_a_closed_shirt_is_gone_and_signals_arrive_from_one_that_sends(source):
    assert isinstance(source.shirt, ReportingShirt)
    assert source.shirt.arrivals() == Arrivals("gone", source.shirt.description())
    source.shirt.open()
    source.let_come(3)
    assert source.shirt.read(WAIT) is not None
    assert said(source.shirt) == ("arrives", "Signals arrive.")
    source.shirt.close()
    assert source.shirt.arrivals().verdict == "gone"


def test_the_web_process_gets_what_the_control_process_says():
    for arrivals in (Arrivals("nothing", Text("arrivals-camera-nothing"), 3, 4), Arrivals("gone", "It is gone.")):
        assert arrivals_from(json.loads(json.dumps(arrivals._asdict(), default=to_document))) == arrivals
    assert arrivals_from(None) is None


# The shirt over UDP.


@pytest.mark.parametrize(
    ("host", "words"),
    [
        ("127.0.0.1", "Only programs on this machine reach that address"),
        ("0.0.0.0", "nothing is sent there, or a firewall keeps it out. Let the shirt send to an address of"),
    ],
)
def test_nothing_at_all_at_a_port_names_what_to_open(opened, host, words):
    source = opened(SteadyUdpCase, host=host)
    verdict, message = said(source.shirt)
    assert verdict == "nothing"
    assert message.startswith(f"Nothing at all arrives at {host}:{source.shirt.address[1]}")
    assert words in message


def test_packets_of_another_format_are_counted_measured_and_named(opened):
    source = opened(SteadyUdpCase)
    source.send_bytes(b"x" * 60)
    assert source.shirt.read(SHORT) is None
    sender = f"127.0.0.1:{source.device.getsockname()[1]}"
    assert said(source.shirt) == (
        "foreign",
        "1 packet arrived that is no frame of this shirt. "
        f"It has 60 bytes and comes from {sender} (what arrives does not come from a shirt).",
    )
    source.send_bytes(encode(0, 0.0, np.zeros(52, np.float32)))
    assert source.shirt.read(SHORT) is None
    _, message = said(source.shirt)
    assert message.startswith("2 packets arrived that are no frames of this shirt. The newest has 232 bytes")
    assert "sends 52 sensors, its layout has 3: use the layout of this shirt" in message
    source.clock.time += SILENCE
    assert source.shirt.arrivals().verdict == "nothing"
    assert source.shirt.arrivals().left_out == 2


def test_a_wrong_or_a_missing_key_is_told_from_another_format(opened, tmp_path):
    unpaired = opened(SteadyUdpCase)
    unpaired.send_bytes(signed_frame(new_key(7), 1, 0, 0, [1.0, 2.0, 3.0]))
    assert unpaired.shirt.read(SHORT) is None
    verdict, message = said(unpaired.shirt)
    assert verdict == "refused"
    assert "the shirt signs its frames: choose its key" in message
    keys = tmp_path / "keys"
    paired = opened(SteadyUdpCase, key_file=str(shirt_key_file(keys, pair_shirt(keys).id)))
    paired.send(0)
    assert paired.shirt.read(SHORT) is None
    verdict, message = said(paired.shirt)
    assert verdict == "refused"
    assert "was not signed with this shirt's key" in message


def test_frames_that_are_late_are_no_silence(opened, tmp_path, monkeypatch):
    keys = tmp_path / "keys"
    key = pair_shirt(keys)
    source = opened(SteadyUdpCase, key_file=str(shirt_key_file(keys, key.id)))
    monkeypatch.setattr(source.shirt._newest, "accept", lambda _boot, _seq: True)  # it waits for no disk

    def comes(seq, kept):
        """Send a frame that was made `kept` seconds ago, and return whether it counts."""
        made_at = round(1e6 * (source.clock.now() - kept))
        source.send_bytes(signed_frame(key, 1, seq, made_at, [1.0, 2.0, 3.0]))
        return source.shirt.read(SHORT) is not None

    assert comes(0, 0.0)
    source.clock.time += SILENCE
    assert not comes(1, 0.7)
    verdict, message = said(source.shirt)
    assert verdict == "late"
    assert message.startswith("Frames arrive, but none is used (its frames arrive 0.7 s late")


def test_frames_that_were_used_before_are_no_silence(opened):
    source = opened(SteadyUdpCase)
    source.send(5)
    assert source.shirt.read(WAIT) is not None
    source.clock.time += SILENCE
    source.send(5)
    assert source.shirt.read(SHORT) is None
    verdict, message = said(source.shirt)
    assert verdict == "repeated"
    assert "each was used before: start the shirt again" in message


def test_another_sender_is_named_whether_the_shirt_is_silent_or_not(opened):
    source, stranger = opened(SteadyUdpCase), opened(SteadyUdpCase)
    source.send(0)
    assert source.shirt.read(WAIT) is not None
    for wait in (0.0, SILENCE):
        source.clock.time += wait
        source.send(1, stranger.device)
        assert source.shirt.read(SHORT) is None
        verdict, message = said(source.shirt)
        assert verdict == "senders"
        assert f"Frames arrive from 127.0.0.1:{stranger.device.getsockname()[1]}, and are left out" in message


def test_frames_at_another_rate_than_the_one_that_is_set_say_both(opened):
    source = opened(SteadyUdpCase)
    for seq in range(260):
        source.clock.time += 0.02
        source.send_bytes(encode(seq, seq / 50, np.zeros(3, np.float32)))
        assert source.shirt.read(WAIT) is not None
    assert said(source.shirt) == (
        "rate",
        "50 frames a second arrive, but 100 are set. Choose 50 as “Frames a second”, or let the device send 100.",
    )


# The shirt on a cable.


def serial_case(kind):
    return lambda tmp_path: kind(tmp_path, FakeClock(7.0))


def test_a_board_without_power_and_one_with_another_format(opened):
    source = opened(serial_case(FramesCase))
    verdict, message = said(source.shirt)
    assert verdict == "nothing"
    assert message.startswith(f"Nothing arrives from the shirt on {source.board.device}: check that its board")
    source.board.send_bytes(b"hello\0world\0")
    assert source.shirt.read(SHORT) is None
    assert said(source.shirt) == (
        "foreign",
        f"12 bytes have arrived on {source.board.device}, but what comes is no frame of this shirt "
        "(choose the format and the baud rate of the board's program).",
    )
    assert source.shirt.arrivals().left_out == 1


@pytest.mark.parametrize(("kind", "rate"), [(FramesCase, 50), (LinesCase, 10)])
def test_a_board_at_another_rate(opened, kind, rate):
    source = opened(serial_case(kind))
    source.board.rate = float(rate)
    for _ in range(6 * rate):
        source.clock.time += 1 / rate
        source.board.send(1)
        assert source.shirt.read(WAIT) is not None
    verdict, message = said(source.shirt)
    assert verdict == "rate"
    assert message.startswith(f"{rate} frames a second arrive, but 100 are set.")


def test_a_pulled_cable_names_the_lines_that_are_there(opened):
    source = opened(serial_case(FramesCase))
    source.board.pull()
    assert source.shirt.read(SHORT) is None
    verdict, message = said(source.shirt)
    assert verdict == "gone"
    assert message.endswith("put its cable in again, and its signals come back by themselves.")
    source.shirt._reopening.others = ["/dev/ttyACM1", "/dev/ttyUSB0"]
    assert said(source.shirt)[1].endswith("this machine has /dev/ttyACM1 and /dev/ttyUSB0.")
    source.board.plug()


@pytest.mark.parametrize(
    ("there", "words"),
    [
        ([], r"put its cable in$"),
        (
            ["/dev/rfcomm0", "/dev/cu.Bluetooth-Incoming-Port", "/dev/ttyUSB1"],
            r"or choose the name that the line has now: /dev/ttyUSB1$",
        ),
    ],
)
def test_a_line_that_is_not_there_names_those_that_are(monkeypatch, there, words):
    ports = [SimpleNamespace(device=device) for device in there]
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: ports)
    with pytest.raises(HardwareError, match=words):
        make_shirt(parse_shirt({"kind": "serial", "device": "/dev/ttyNONE99"}), FakeClock()).open()


# Streams of LSL.


def test_a_stream_that_sends_nothing_and_one_that_has_ended(opened):
    source = opened(LslCase)
    verdict, message = said(source.shirt)
    assert verdict == "nothing"
    assert message.startswith("No samples come from Arm (source ID arm-1")
    source.sender.end()
    assert source.shirt.read(SHORT) is None
    source.clock.time += SILENCE
    verdict, message = said(source.shirt)
    assert verdict == "gone"
    assert message.startswith("The program that sends Arm (source ID arm-1")


# Boards of BrainFlow.


def test_a_board_says_why_it_shows_nothing():
    fed = FedBoard()
    assert said(fed.shirt)[0] == "waiting"
    fed.clock.time += SILENCE
    verdict, message = said(fed.shirt)
    assert verdict == "nothing"
    assert message.startswith("Nothing arrives from the board CYTON_BOARD: switch it on")
    fed.reader.trouble = "BOARD_NOT_READY_ERROR"
    verdict, message = said(fed.shirt)
    assert verdict == "gone"
    assert message.startswith("Nothing arrives from the board CYTON_BOARD (BOARD_NOT_READY_ERROR): switch it on")
    fed.reader.trouble = ""
    assert fed.frames([1e9])
    assert said(fed.shirt) == ("arrives", "Signals arrive.")


@pytest.mark.parametrize(("rate", "verdict"), [(50, "rate"), (95, "arrives"), (100, "arrives"), (200, "rate")])
def test_a_board_at_another_rate_than_brainflow_knows_of_it(rate, verdict):
    fed = FedBoard()
    for burst in range(30):
        fed.frames(1e9 + burst / 5 + np.arange(rate // 5) / rate, delay=1 / 5)
    found, message = said(fed.shirt)
    assert found == verdict
    if verdict == "rate":
        assert message.startswith(f"{rate} samples a second arrive from the board CYTON_BOARD, but its stream has 100")


# A camera, a file.


def test_a_camera_says_why_it_shows_nothing(opened):
    source = opened(CameraCase)
    assert said(source.shirt)[0] == "nothing"
    source.page.send()
    assert said(source.shirt)[0] == "arrives"
    for _ in range(4):
        source.clock.time += SILENCE / 4
        source.page.send(underway=0.8)
    verdict, message = said(source.shirt)
    assert verdict == "late"
    assert message.startswith("Pictures arrive 0.8 s late")
    source.page.deliver(b"hello")
    verdict, message = said(source.shirt)
    assert verdict == "foreign"
    assert message.startswith("1 message arrived that is no new sample")
    source.page.send(np.full(CHANNELS, np.nan, np.float32))
    assert said(source.shirt)[0] == "nobody"


def test_a_camera_that_reads_too_few_pictures_says_how_many(opened):
    source = opened(CameraCase)
    for _ in range(60):
        source.clock.time += 0.2
        source.page.send()
    verdict, message = said(source.shirt)
    assert verdict == "rate"
    assert message.startswith("The camera reads 5 pictures a second, too few for 30 frames")


def test_a_file_says_that_it_has_ended(opened):
    source = opened(ReplayedCase)
    while source.shirt.read(1.0) is not None:
        pass
    verdict, message = said(source.shirt)
    assert verdict == "ended"
    assert message.startswith("The replay of signals.csv has ended")
