"""The far ends of the sources, each in a process of its own: what moves them is a scripted person."""

import multiprocessing
import os
import socket
from collections.abc import Mapping
from contextlib import ExitStack, contextmanager, suppress
from typing import ClassVar

import numpy as np
from browser.fake_camera import own_browser, person
from hardware.shirt.orientation_sensors.fake_bleak import FakeSensor
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker
from hardware.shirt.wired_board import WiredBoard, frame_bytes
from playwright.sync_api import sync_playwright
from processes.udp_shirt import free_port
from sensors.far_ends import heard
from sources_tried.film import Film
from sources_tried.limbs import ARMS, device_angles_deg, orientations, sensor_angles_deg
from sources_tried.person import Eyes, ScriptedPerson, visitor

from app.clock import MonotonicClock
from app.hardware.base import BodyView
from app.hardware.shirt.packet import encode
from app.hardware.shirt.simulated_fabric import FULL_SCALE, STEPS, Fabric
from app.hardware.shirt.standard import standard_layout
from app.layout import Channel, Joint, ShirtLayout
from app.lsl_library import load_lsl
from building import PAPER_JOINTS

HERE = "127.0.0.1"
LONGEST_LAG = 0.5  # s: a far end that was held up for longer leaves the samples meanwhile out
ANSWER = 60.0  # s that a far end may take to answer: a phone's browser is started, or its page opened
EACH = 3  # stretch sensors at a joint
PHONE = {"width": 390, "height": 844}  # px
ADDRESSES = {part: f"00:00:00:00:00:{number:02X}" for number, part in enumerate(ARMS, 1)}
PHONES = {part: str(number) for number, part in enumerate(ARMS, 1)}
FAR_END_PORT = "SOURCES_TRIED_PORT"  # in the environment: where a stand-in listens to its far end
STREAM = "stretch-sensors"  # source id of the LSL stream


def stretch_layout():
    """Return the layout of a home-made shirt: EACH sensors at each elbow and shoulder."""
    return ShirtLayout(
        name="Stretch sensors",
        channels=tuple(
            Channel(name=f"{joint}_{number}", joint=joint) for joint in PAPER_JOINTS for number in range(1, EACH + 1)
        ),
        joints=tuple(Joint(name=joint, label=joint.replace("_", " ").capitalize()) for joint in PAPER_JOINTS),
    )


class FarEnd:
    """Sends what it measures of a person, `rate` (Hz) times a second.

    Attributes
    ----------
    plays : dict
        Which of the person's joints another joint of the shirt moves as.
    shown : str
        The joint whose movement is compared with the signals.
    facts : dict
        What is known only now, for the form of the page, and for the environment of the program and the browser.
    """

    rate = 100.0
    plays: ClassVar[Mapping[str, str]] = {}
    shown = "right_elbow"

    def __init__(self, _folder):
        self.facts = {}

    def send(self, levels, t):
        """Send what is measured at `t` (monotonic s); `levels` of the joints, 0 at rest, 1 in a full movement."""
        raise NotImplementedError

    def pair(self, link):
        """Pair another device by a link of the page."""
        raise NotImplementedError

    def close(self):
        """Release what is held."""


class FabricEnd(FarEnd):
    """Sensors that stretch: those of the paper's shirt."""

    def __init__(self, folder):
        super().__init__(folder)
        self.layout = self.make_layout()
        self._fabric = Fabric(self.layout, 1)
        self._seq = 0

    @staticmethod
    def make_layout():
        return standard_layout()

    def send(self, levels, t):
        posture = np.array([levels[name] for name in self._fabric.joints])
        self.send_values(self._fabric.step(posture, 1.0 / self.rate), t)
        self._seq += 1

    def send_values(self, values, t):
        """Send the sensors' values (n_channels,), V."""
        raise NotImplementedError


class UdpEnd(FabricEnd):
    """A shirt over the network."""

    def __init__(self, folder):
        super().__init__(folder)
        self._port = free_port()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.facts = {"port": str(self._port)}

    def send_values(self, values, _t):
        self._socket.sendto(encode(self._seq, self._seq / self.rate, values), (HERE, self._port))

    def close(self):
        self._socket.close()


class FramesEnd(FabricEnd):
    """A board on a cable that sends frames with a checksum, of the counts of its converter."""

    def __init__(self, folder):
        super().__init__(folder)
        self._board = WiredBoard()
        os.set_blocking(self._board._ours, False)
        self.facts = {"line": self._board.device}

    def send_values(self, values, t):
        counts = np.rint(values * (STEPS / FULL_SCALE)).astype(int).tolist()
        with suppress(BlockingIOError):  # nobody reads the line yet
            self._board.write(self.message(counts, t))

    def message(self, counts, t):
        """Return the bytes of the next sample."""
        return frame_bytes(self._seq, round(1e6 * t), counts)

    def close(self):
        self._board.pull()


class LinesEnd(FramesEnd):
    """A home-made board on a cable that prints its sensors."""

    def __init__(self, folder):
        super().__init__(folder)
        self.facts |= {"layout": layout_file(folder, self.layout)}

    @staticmethod
    def make_layout():
        return stretch_layout()

    def message(self, counts, _t):
        return b"%s\r\n" % ",".join(map(str, counts)).encode()


class LslEnd(FabricEnd):
    """A stream of LSL that describes its channels."""

    def __init__(self, folder):
        super().__init__(folder)
        self._lsl = load_lsl()
        info = self._lsl.StreamInfo("Stretch", "Stretch", len(self.layout.channels), self.rate, "float32", STREAM)
        channels = info.desc().append_child("channels")
        for channel in self.layout.channels:
            described = channels.append_child("channel")
            for name, text in (("label", channel.name), ("unit", "V"), ("joint", channel.joint)):
                described.append_child_value(name, text)
        self._outlet = self._lsl.StreamOutlet(info)
        self.facts = {"stream": STREAM}

    @staticmethod
    def make_layout():
        return stretch_layout()

    def send_values(self, values, _t):
        self._outlet.push_chunk(values[np.newaxis], [self._lsl.local_clock()])


class BoardEnd(FabricEnd):
    """A board of BrainFlow's, as far as the stand-in for BrainFlow shows it."""

    def __init__(self, folder):
        super().__init__(folder)
        self._port = free_port()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.facts = {"layout": layout_file(folder, self.layout), FAR_END_PORT: str(self._port)}

    @staticmethod
    def make_layout():
        return stretch_layout()

    def send_values(self, values, t):
        sample = np.array([self._seq % 256, *values.tolist(), t])  # packet number, data, time
        self._socket.sendto(sample.tobytes(), (HERE, self._port))

    def close(self):
        self._socket.close()


class OrientationEnd(FarEnd):
    """Sensors of orientation on both arms."""

    noise = 0.002  # rad

    def __init__(self, folder):
        super().__init__(folder)
        self._random = np.random.default_rng(1)

    def send(self, levels, t):
        for part, orientation in orientations(levels, self._random, self.noise).items():
            self.send_orientation(part, orientation, t)

    def send_orientation(self, part, orientation, t):
        """Send the orientation (4,) of a part of the body."""
        raise NotImplementedError


class TrackersEnd(OrientationEnd):
    """Trackers, each with a socket of its own."""

    def __init__(self, folder):
        super().__init__(folder)
        self._port = free_port()
        self.facts = {"port": str(self._port)}
        self._trackers = {}
        for part, mac in ADDRESSES.items():
            listening = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            listening.setblocking(False)
            self._trackers[part] = listening, SlimeTracker(mac, rate=self.rate)

    def send_orientation(self, part, orientation, t):
        listening, tracker = self._trackers[part]
        answers = [answer for datagram in heard(listening) for answer in tracker.hear(datagram, t)]
        tracker.orientation[0] = orientation
        for datagram in (*answers, *tracker.step(t)):
            listening.sendto(datagram, (HERE, self._port))

    def close(self):
        for listening, _ in self._trackers.values():
            listening.close()


class BluetoothEnd(OrientationEnd):
    """Sensors over Bluetooth, as far as the stand-in for bleak shows them."""

    def __init__(self, folder):
        super().__init__(folder)
        self._port = free_port()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._sensors = {part: FakeSensor(address) for part, address in ADDRESSES.items()}
        self.facts = {FAR_END_PORT: str(self._port)}

    def send_orientation(self, part, orientation, _t):
        sensor = self._sensors[part]
        sensor.angles = sensor_angles_deg(orientation)
        address = bytes.fromhex(sensor.address.replace(":", ""))
        self._socket.sendto(address + sensor.motion(), (HERE, self._port))

    def close(self):
        self._socket.close()


class PhonesEnd(OrientationEnd):
    """Phones: pages of a browser, whose orientation the developer's tools set; they tell steps of 0.1 degrees."""

    rate = 30.0
    noise = 0.0026  # rad: as a hand's, for a page hears only of what has changed

    def __init__(self, folder):
        super().__init__(folder)
        self._ends = ExitStack()
        playwright = self._ends.enter_context(sync_playwright())
        self._browser = self._ends.enter_context(own_browser(playwright, folder))
        self._devices = []

    def pair(self, link):
        context = self._browser.new_context(viewport=PHONE, has_touch=True)
        page = context.new_page()
        page.goto(link)
        page.get_by_role("button", name="Start").click()
        self._devices.append(context.new_cdp_session(page))

    def send_orientation(self, part, orientation, _t):
        number = int(PHONES[part])
        if number <= len(self._devices):
            angles = zip(("alpha", "beta", "gamma"), device_angles_deg(orientation), strict=True)
            self._devices[number - 1].send("DeviceOrientation.setDeviceOrientationOverride", dict(angles))

    def close(self):
        self._ends.close()


class CameraEnd(FarEnd):
    """The picture of a person before the camera, who leans, tilts the head and lifts the shoulders."""

    rate = 15.0
    plays: ClassVar[Mapping[str, str]] = {"trunk": "right_elbow", "head": "left_elbow"}
    shown = "trunk"

    def __init__(self, folder):
        super().__init__(folder)
        file = folder / "film.y4m"
        self._film = Film(file, person())
        self.facts = {"film": str(file)}

    def send(self, levels, _t):
        self._film.show(levels)

    def close(self):
        self._film.close()


def layout_file(folder, layout):
    """Write a layout into a folder, and return its file."""
    file = folder / "layout.json"
    file.write_text(layout.model_dump_json(), encoding="utf-8")
    return str(file)


def run(make, connection, folder):
    """Be a far end that `make` makes, and the person whom it moves, until `connection` says "end".

    First its facts are sent. Then each command, a word with its fields, is answered: "report" by what the eyes saw
    (metre_t, ages, seen) and the level of the joint `shown` at each time (t, level); any other one by metre_t.
    """
    clock = MonotonicClock()
    far_end, body, eyes = make(folder), ScriptedPerson(make.plays), None
    sent = []
    connection.send(far_end.facts)
    before = due = clock.now()
    while True:
        while connection.poll(0):
            what, *fields = connection.recv()
            if what == "end":
                far_end.close()
                if eyes is not None:
                    eyes.close()
                return
            if what == "watch":
                eyes = Eyes(visitor(*fields), make.plays)
                eyes.start()
            elif what == "pair":
                far_end.pair(*fields)
            metre_t = None if eyes is None else eyes.metre_t
            connection.send((metre_t, list(eyes.ages), list(eyes.seen), sent) if what == "report" else metre_t)
        now = clock.now()
        levels = body.levels(now - before, BodyView() if eyes is None else eyes.view)
        far_end.send(levels, now)
        sent.append((now, levels[make.shown]))
        before = now
        due = max(due + 1.0 / make.rate, now - LONGEST_LAG)
        clock.sleep_until(due)


@contextmanager
def running(make, folder):
    """Run a far end in a process of its own; yield its facts, and what sends it a command and returns the answer."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=run, args=(make, theirs, folder), daemon=True)
    process.start()
    theirs.close()  # so that an end of the process is noticed here

    def answer():
        assert ours.poll(ANSWER), f"the far end {make.__name__} does not answer"
        return ours.recv()

    def ask(*what):
        ours.send(what)
        return answer()

    try:
        yield answer(), ask
    finally:
        with suppress(OSError):
            ours.send(("end",))
        process.join(ANSWER)
        if process.is_alive():
            process.kill()
