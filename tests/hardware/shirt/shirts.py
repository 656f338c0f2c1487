"""Shirts for tests, each with a way to send the next frames."""

import socket
from collections import deque
from types import SimpleNamespace

import numpy as np
from fake_clock import FakeClock
from hardware.shirt.camera_page import CameraPage
from hardware.shirt.fake_brainflow import CYTON, FakeBrainFlow
from hardware.shirt.fake_lsl import FakeLsl
from hardware.shirt.orientation_sensors.fake_bleak import FakeBleak
from hardware.shirt.orientation_sensors.phone_page import PhonePage
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker
from hardware.shirt.wired_board import WiredBoard

from app.clock import MonotonicClock
from app.hardware.shirt.arrival_watch import PATIENCE
from app.hardware.shirt.brainflow_board import BrainFlowConfig, BrainFlowShirt
from app.hardware.shirt.brainflow_library import BoardChannels
from app.hardware.shirt.camera import CameraConfig, CameraShirt
from app.hardware.shirt.lsl import LslConfig, LslShirt
from app.hardware.shirt.orientation_sensors.bluetooth import BluetoothConfig, BluetoothShirt
from app.hardware.shirt.orientation_sensors.orientation_frames import REST_TIME
from app.hardware.shirt.orientation_sensors.phones import PhonesConfig, PhonesShirt
from app.hardware.shirt.orientation_sensors.slimevr import SlimeVrConfig, SlimeVrShirt
from app.hardware.shirt.packet import encode
from app.hardware.shirt.replay import ReplayConfig, ReplayedShirt
from app.hardware.shirt.serial_line import SerialConfig, SerialShirt
from app.hardware.shirt.simulator import SimulatedShirt, SimulatorConfig
from app.hardware.shirt.udp import UdpConfig, UdpShirt
from app.layout import Channel, Joint, ShirtLayout
from app.texts import LANGUAGES, reader_language

RATE = 100.0
SILENCE = PATIENCE + 0.01  # s without a frame, after which a shirt has a verdict


def small_layout():
    return ShirtLayout(
        name="small",
        channels=tuple(Channel(name=f"right_elbow_{i}", joint="right_elbow") for i in range(1, 4)),
        joints=(Joint(name="right_elbow", label="Right elbow"),),
    )


def write_signals(file, count=200, channels=3, rate=RATE):
    """Write a CSV whose first channel holds the number of the sample, so that every loss shows."""
    names = [f"right_elbow_{i}" for i in range(1, channels + 1)]
    rows = [",".join(["t", *names])]
    rows += [",".join([f"{i / rate:.6f}", *(str(i + 1000 * c) for c in range(channels))]) for i in range(count)]
    file.write_text("\n".join(rows) + "\n")
    return file


def said(shirt):
    """Return a shirt's verdict, and what it says, which every language can say."""
    arrivals = shirt.arrivals()
    for language in LANGUAGES:
        with reader_language(language):
            assert "{" not in str(arrivals.message)
    return arrivals.verdict, str(arrivals.message)


class SimulatedCase:
    """The simulated shirt on a fake clock."""

    rate = RATE

    def __init__(self, _tmp_path):
        self.clock = FakeClock(50.0)
        self.shirt = SimulatedShirt(SimulatorConfig(kind="simulator", layout=small_layout()), self.clock)

    def let_come(self, count):
        self.clock.time += (count - 1) / RATE + 1e-6

    def end(self):
        """Do nothing: no other resource is held."""


class ReplayedCase(SimulatedCase):
    """A replayed file on a fake clock."""

    def __init__(self, tmp_path):
        self.clock = FakeClock(50.0)
        file = write_signals(tmp_path / "signals.csv")
        self.shirt = ReplayedShirt(ReplayConfig(kind="replay", file=str(file), loop=False), self.clock)


class UdpCase:
    """The shirt over UDP, and a device that sends to it."""

    rate = RATE

    def __init__(self, _tmp_path):
        self.clock = MonotonicClock()
        config = UdpConfig(kind="udp", port=0, layout=small_layout(), sample_rate=RATE)
        self.shirt = UdpShirt(config, self.clock)
        self.device = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.seq = 0

    def let_come(self, count):
        for _ in range(count):
            self.send(self.seq)
            self.seq += 1

    def send(self, seq, device=None):
        values = np.array([seq % 1000, 1, 2], dtype=np.float32)
        self.send_bytes(encode(seq, (seq % (1 << 32)) / RATE, values), device)

    def send_bytes(self, content, device=None):
        (device or self.device).sendto(content, self.shirt.address)

    def end(self):
        self.device.close()


class LslCase:
    """A stream of LSL, and the network that it comes from."""

    rate = RATE

    def __init__(self, _tmp_path):
        self.clock = FakeClock(50.0)
        self.lsl = FakeLsl(self.clock)
        self.sender = self.lsl.add_sender(rate=RATE, labels=small_layout().channel_names)
        self.shirt = LslShirt(LslConfig(kind="lsl"), self.clock, lambda: self.lsl)
        self.sent = 0

    def let_come(self, count):
        for _ in range(count):
            t = self.sent / RATE
            self.sender.send([self.sent % 1000, 1, 2], t, late=self.clock.now() - t)
            self.sent += 1

    def end(self):
        """Do nothing: no other resource is held."""


class FramesCase:
    """The shirt on a cable, and a board that sends frames on a pseudo terminal."""

    format = "frames"
    rate = RATE

    def __init__(self, _tmp_path, clock=None):
        self.clock = clock or MonotonicClock()
        self.board = WiredBoard(sends_lines=self.format == "lines", rate=RATE)
        self.first_device = self.board.device
        config = SerialConfig(
            kind="serial", device=self.first_device, format=self.format, layout=small_layout(), sample_rate=RATE
        )
        self.shirt = SerialShirt(config, self.clock)

    def let_come(self, count):
        self.board.send(count)

    def end(self):
        self.board.pull()


class LinesCase(FramesCase):
    """The shirt on a cable, and a board that sends plain lines."""

    format = "lines"


class SlimeVrCase:
    """A tracker on the right forearm, at rest, on a fake clock; its datagrams are real."""

    rate = RATE

    def __init__(self, _tmp_path, **parts):
        self.clock = FakeClock(50.0)
        self.tracker = SlimeTracker(rate=RATE)
        config = SlimeVrConfig(
            kind="slimevr", host="127.0.0.1", port=0, sample_rate=RATE, right_forearm=self.tracker.mac, **parts
        )
        self.shirt = SlimeVrShirt(config, self.clock)
        self.device = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.device.setblocking(False)

    def let_come(self, count):
        self.be_still()
        self.clock.time += (count - 1) / RATE + 1e-6
        self.send(self.tracker.rotation())

    def be_still(self):
        """Let the tracker greet, and stay at rest up to the first frame."""
        self.send(self.tracker.handshake())
        self.clock.time += 1e-6
        for _ in range(round(REST_TIME * RATE) - 1):
            self.send(self.tracker.rotation())
            assert self.shirt.read(0.0) is None
            self.clock.time += 1 / RATE

    def send(self, datagram):
        self.device.sendto(datagram, self.shirt.address)

    def end(self):
        self.device.close()


class BluetoothCase:
    """A Bluetooth sensor on the right forearm, at rest, on a fake clock; its connection has its thread."""

    rate = RATE
    address = "A1:B2:C3:D4:E5:F6"

    def __init__(self, _tmp_path):
        self.clock = FakeClock(50.0)
        self.bleak = FakeBleak()
        self.sensor = self.bleak.add_sensor(self.address)
        config = BluetoothConfig(kind="bluetooth", sample_rate=RATE, right_forearm=self.address)
        self.shirt = BluetoothShirt(config, self.clock, lambda: self.bleak)

    def let_come(self, count):
        self.sensor.wait_until_connected()
        self.clock.time += 1e-6
        for _ in range(round(REST_TIME * RATE) - 1):
            self.sensor.send()
            assert self.shirt.read(0.0) is None
            self.clock.time += 1 / RATE
        self.clock.time += (count - 1) / RATE + 1e-6
        self.sensor.send()

    def end(self):
        """Do nothing: no other resource is held."""


class BrainFlowCase:
    """A board of BrainFlow, whose samples its thread takes over."""

    rate = RATE

    def __init__(self, _tmp_path):
        self.clock = MonotonicClock()
        self.brainflow = FakeBrainFlow({**CYTON, "sampling_rate": RATE})
        self.shirt = BrainFlowShirt(BrainFlowConfig(kind="brainflow"), self.clock, lambda: self.brainflow)
        self.sent = 0

    def let_come(self, count):
        numbers = range(self.sent, self.sent + count)
        self.sent += count
        self.brainflow.send([[0, 0, 0, 0, number % 1000, 1, 2, 1e9 + number / RATE] for number in numbers])

    def end(self):
        """Do nothing: no other resource is held."""


class FedBoard:
    """A board of BrainFlow with one channel on a fake clock, which is given what its thread would take over."""

    def __init__(self):
        self.clock = FakeClock(50.0)
        config = BrainFlowConfig(kind="brainflow", layout=small_layout())
        self.shirt = BrainFlowShirt(config, self.clock, FakeBrainFlow)
        self.shirt._begin(BoardChannels({"accel_1": 0}, 1, RATE))
        self.chunks = deque()
        self.reader = SimpleNamespace(chunks=self.chunks, trouble="", wait=self.wait, end=lambda: None)
        self.shirt._reader = self.reader

    def wait(self, longest):
        self.clock.time += longest

    def frames(self, stamps, delay=0.0):
        """Return the frames of samples with these times (s), which are numbered and taken over at once."""
        self.clock.time += delay
        self.chunks.append((self.clock.time, np.array([np.arange(float(len(stamps))), stamps])))
        found = []
        while (frame := self.shirt.read(0.0)) is not None:
            found.append(frame)
        return found


class CameraCase:
    """The camera on a fake clock, and a page that sends what it sees."""

    rate = 30.0

    def __init__(self, _tmp_path):
        self.clock = FakeClock(50.0)
        self.shirt = CameraShirt(CameraConfig(kind="camera"), self.clock)
        self.page = CameraPage(self.shirt, self.clock)

    def let_come(self, count):
        for i in range(count):
            self.clock.time += 1 / self.rate if i else 0.0
            self.page.send()
        self.clock.time += 1e-6

    def end(self):
        """Do nothing: no other resource is held."""


class PhonesCase:
    """A phone on the right forearm, at rest, on a fake clock."""

    rate = RATE

    def __init__(self, _tmp_path):
        self.clock = FakeClock(50.0)
        self.shirt = PhonesShirt(PhonesConfig(kind="phones", sample_rate=RATE, right_forearm="1"), self.clock)
        self.page = PhonePage(self.shirt, self.clock)

    def let_come(self, count):
        self.clock.time += 1e-6
        for _ in range(round(REST_TIME * RATE) - 1):
            self.page.send()
            assert self.shirt.read(0.0) is None
            self.clock.time += 1 / RATE
        self.clock.time += (count - 1) / RATE
        self.page.send()

    def end(self):
        """Do nothing: no other resource is held."""


SHIRTS = (
    SimulatedCase,
    CameraCase,
    PhonesCase,
    SlimeVrCase,
    BluetoothCase,
    FramesCase,
    LinesCase,
    BrainFlowCase,
    LslCase,
    UdpCase,
    ReplayedCase,
)
