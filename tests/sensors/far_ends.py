"""The far ends of the drivers in real time: each sends the time at which it measures, so that a frame shows its age.

A far end runs in a process of its own, or in a thread. It is told what to do through a connection.
"""

import json
import math
import socket
from contextlib import suppress
from pathlib import Path

import numpy as np
from hardware.shirt.camera_page import CHANNELS, message_of
from hardware.shirt.orientation_sensors.fake_bleak import FakeSensor
from hardware.shirt.orientation_sensors.phone_page import PhonePage
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker
from hardware.shirt.wired_board import WiredBoard, frame_bytes

from app.clock import MonotonicClock
from app.hardware.shirt.orientation_sensors.orientation import exponential
from app.hardware.shirt.packet import encode
from app.lsl_library import load_lsl

SENSORS = 52  # of the paper's shirt
TURN = 10.0  # s, after which the measured time begins anew where it is an angle
ANGLE = 2.5  # rad, the angle of a whole TURN: less than half a turn, so that it is known which way
LONGEST_LAG = 1.0  # s: a far end that was held up for longer leaves the samples meanwhile out
NO_ANSWER = 0  # id of a command to the control process
PARTS = (
    *("trunk", "head", "left_upper_arm", "right_upper_arm"),
    *("left_forearm", "right_forearm", "left_hand", "right_hand"),
)
MACS = {part: f"00:00:00:00:00:{number:02X}" for number, part in enumerate(PARTS, 1)}
PHONES = {part: str(number) for number, part in enumerate(PARTS[:6], 1)}
STREAM = "far-end"  # source id of the LSL stream


def time_parts(t):
    """Return a time (s) as whole seconds, milliseconds and microseconds, each less than 1,000."""
    microseconds = round(1e6 * t)
    return microseconds // 1_000_000 % 1000, microseconds // 1000 % 1000, microseconds % 1000


def age_of_parts(values, now):
    """Return how old (s) values are at `now` (s) that begin with `time_parts`."""
    t = float(values[0]) + 1e-3 * float(values[1]) + 1e-6 * float(values[2])
    return (now - t + 500.0) % 1000.0 - 500.0


def angle_at(t):
    """Return the angle (rad) that shows a time (s)."""
    return ANGLE * (t % TURN) / TURN


def age_of_angle(angle, now):
    """Return how old (s) an angle (rad) of `angle_at` is at `now` (s)."""
    return (now - TURN * float(angle) / ANGLE + TURN / 2) % TURN - TURN / 2


class FarEnd:
    """Sends samples; `rate` is how often `step` is called in a second, and `sent` counts the samples."""

    def __init__(self, rate, _link, _folder):
        self.rate = rate
        self.sent = 0
        self.is_cut = False
        self.moves = False

    def go(self, address):
        """Begin to send to a driver, which listens at `address` where it has one."""

    def move(self):
        """Show the time from now on, where a sensor was still before."""
        self.moves = True

    def cut(self):
        """Let nothing through."""
        self.is_cut = True

    def mend(self):
        """Let everything through again."""
        self.is_cut = False

    def step(self, now):
        """Send the samples that are measured at `now` (s)."""

    def close(self):
        """Release what is held."""


class UdpEnd(FarEnd):
    """A shirt over the network, whose count goes on while nothing gets through."""

    def go(self, address):
        self._address, self._seq = address, 0
        self._values = np.zeros(SENSORS, dtype=np.float32)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def step(self, now):
        self._values[:3] = time_parts(now)
        if not self.is_cut:
            self._socket.sendto(encode(self._seq, self._seq / self.rate, self._values), self._address)
            self.sent += 1
        self._seq += 1

    def close(self):
        self._socket.close()


class FramesEnd(FarEnd):
    """A board on a cable that sends frames; a link in the folder is the name of the line, whichever plug it has."""

    BEGIN = b"\0"

    def __init__(self, rate, link, folder):
        super().__init__(rate, link, folder)
        self._name = line_in(folder)
        self._board = WiredBoard()
        self._seq = 0
        self._plug_in()

    def go(self, _address):
        self._board.write(self.BEGIN)

    def cut(self):
        super().cut()
        self._name.unlink()  # another program may get a line of this number
        self._board.pull()

    def mend(self):
        self._board.plug()
        self._plug_in()
        self._board.write(self.BEGIN)
        super().mend()

    def step(self, now):
        if not self.is_cut:
            self._board.write(self.message(now))
            self.sent += 1
            self._seq += 1

    def message(self, now):
        """Return the bytes of the next sample."""
        return frame_bytes(self._seq, round(1e6 * now), (*time_parts(now), *[0] * (SENSORS - 3)))

    def close(self):
        if self._board.is_in:
            self._board.pull()

    def _plug_in(self):
        self._name.symlink_to(self._board.device)


class LinesEnd(FramesEnd):
    """A board on a cable that sends plain lines."""

    BEGIN = b"\r\n"

    def message(self, now):
        return b",".join(b"%d" % number for number in (*time_parts(now), *[512] * (SENSORS - 3))) + b"\r\n"


def line_in(folder):
    """Return the name of the serial line in a folder."""
    return Path(folder) / "ttyBOARD"


class TrackersEnd(FarEnd):
    """Trackers, each with a socket of its own: they look for their server, then turn about one axis."""

    def __init__(self, rate, link, folder):
        super().__init__(4.0 * rate, link, folder)  # a tracker looks at its own clock at each step
        self._trackers = {}
        for mac in MACS.values():
            listening = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            listening.setblocking(False)
            self._trackers[listening] = SlimeTracker(mac, rate=rate)

    def go(self, address):
        self._address = address

    def step(self, now):
        for listening, tracker in self._trackers.items():
            answers = [answer for datagram in heard(listening) for answer in tracker.hear(datagram, now)]
            if self.moves:
                tracker.orientation[0] = exponential(np.array((0.0, 0.0, angle_at(now))))
            datagrams = [*answers, *tracker.step(now)]
            if self.is_cut:
                continue
            for datagram in datagrams:
                listening.sendto(datagram, self._address)
                self.sent += datagram[3] == 17  # an orientation

    def close(self):
        for listening in self._trackers:
            listening.close()


def heard(listening):
    """Yield the datagrams that have come."""
    with suppress(BlockingIOError, ConnectionError):
        while True:
            yield listening.recv(100)


class PagesEnd(FarEnd):
    """Pages that send samples, which the web process hands on to the control process as commands."""

    def __init__(self, rate, link, folder):
        super().__init__(rate, link, folder)
        self._clock = MonotonicClock()
        self._link = link

    def hand_on(self, page, message):
        """Hand a sample on, as one that has just come."""
        if self.is_cut:
            return
        command = {"id": NO_ANSWER, "do": "sample", "page": page, "message": message.hex()}
        self._link.sendall(json.dumps({**command, "received": self._clock.now()}).encode() + b"\n")
        self.sent += 1


class PhonesEnd(PagesEnd):
    """Phones that turn about one axis."""

    def __init__(self, rate, link, folder):
        super().__init__(rate, link, folder)
        self._pages = [PhonePage(None, self._clock, int(number)) for number in PHONES.values()]

    def step(self, now):
        for page in self._pages:
            page.angles = (math.degrees(angle_at(now)) if self.moves else 0.0, 0.0, 0.0)
            self.hand_on(page.number, page.message())


class CameraEnd(PagesEnd):
    """A page that is the camera; the first channel is the time of the picture."""

    def step(self, now):
        values = np.zeros(CHANNELS, dtype=np.float32)
        values[0] = angle_at(now)
        self.hand_on(1, message_of(self.sent, now, now, values))


class BluetoothEnd(FarEnd):
    """Sensors over Bluetooth that turn about one axis, as far as the fake of bleak shows them."""

    def go(self, address):
        self._address = address
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._sensors = {bytes.fromhex(mac.replace(":", "")): FakeSensor(mac) for mac in MACS.values()}

    def step(self, now):
        for mac, sensor in self._sensors.items():
            sensor.angles = (0.0, 0.0, math.degrees(angle_at(now)) if self.moves else 0.0)
            if not self.is_cut:
                self._socket.sendto(mac + sensor.motion(), self._address)
                self.sent += 1

    def close(self):
        self._socket.close()


class BoardEnd(FarEnd):
    """A board of BrainFlow's, as far as the fake of BrainFlow shows it; its time goes on while nothing gets through."""

    def go(self, address):
        self._address, self._seq, self._begun = address, 0, MonotonicClock().now()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def step(self, now):
        if not self.is_cut:
            values = np.zeros(SENSORS + 1)
            values[:3], values[SENSORS] = time_parts(now), self._begun + self._seq / self.rate
            self._socket.sendto(values.tobytes(), self._address)
            self.sent += 1
        self._seq += 1

    def close(self):
        self._socket.close()


class LslEnd(FarEnd):
    """A stream of LSL with the times of a device; a cut is the end of its sender, which is then started again."""

    def __init__(self, rate, link, folder):
        super().__init__(rate, link, folder)
        self._lsl = load_lsl()
        self._values = np.zeros((1, SENSORS), dtype=np.float32)
        self.mend()

    def cut(self):
        super().cut()
        del self._outlet

    def mend(self):
        info = self._lsl.StreamInfo("Far end", "MoCap", SENSORS, self.rate, "float32", STREAM)
        self._outlet = self._lsl.StreamOutlet(info)
        self._begun, self._pushed = self._lsl.local_clock(), 0
        super().mend()

    def step(self, now):
        if not self.is_cut:
            self._values[0, :3] = time_parts(now)
            self._outlet.push_chunk(self._values, [self._begun + self._pushed / self.rate])
            self._pushed += 1
            self.sent += 1


def run(make, rate, connection, link, folder):
    """Be a far end that `make` makes of the other arguments, until `connection` says "end".

    Each command is the name of a method with its arguments, or "pause", "resume" or "count"; it is answered with the
    number of samples that were sent.
    """
    clock = MonotonicClock()
    far_end = make(rate, link, folder)
    connection.send(None)
    due, runs = clock.now(), False
    while True:
        if runs:
            clock.sleep_until(due)
        while not runs or connection.poll(0):
            what, *fields = connection.recv()
            if what == "end":
                far_end.close()
                link.close()
                return
            if what not in {"count", "pause", "resume"}:
                getattr(far_end, what)(*fields)
            if what in {"go", "resume"}:
                due, runs = clock.now(), True
            elif what == "pause":
                runs = False
            connection.send(far_end.sent)
        now = clock.now()
        due += 1.0 / far_end.rate
        if now - due > LONGEST_LAG:
            due = now
        far_end.step(now)
