"""Head trackers for tests, each with a way to send a pose."""

import math
import socket
import struct
import time

from fake_clock import FakeClock
from hardware.head.flock_unit import FlockUnit

from app.clock import MonotonicClock
from app.hardware.configs import (
    FlockOfBirdsConfig,
    FreepieConfig,
    OpentrackConfig,
    RecordedHeadConfig,
    SimulatedHeadConfig,
    TabletHeadConfig,
)
from app.hardware.head.flock_of_birds import FlockOfBirds
from app.hardware.head.freepie import Freepie
from app.hardware.head.opentrack import Opentrack
from app.hardware.head.recorded import RecordedHead
from app.hardware.head.simulator import SimulatedHead
from app.hardware.head.tablet import TabletHead


class Datagrams:
    """A tracker that sends datagrams, and the driver that listens."""

    def __init__(self, _tmp_path):
        self.clock = MonotonicClock()
        self.head = self.driver()
        self.device = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def send(self, content, device=None):
        (device or self.device).sendto(content, self.head.address)

    def end(self):
        self.device.close()


class OpentrackCase(Datagrams):
    """opentrack."""

    def driver(self):
        return Opentrack(OpentrackConfig(kind="opentrack", port=0), self.clock)

    def let_come(self, yaw, pitch, roll):
        degrees = (math.degrees(-yaw), math.degrees(pitch), math.degrees(-roll))
        self.send(struct.pack("<6d", 0.0, 0.0, 0.0, *degrees))


class FreepieCase(Datagrams):
    """FreePIE, orientation only."""

    def driver(self):
        return Freepie(FreepieConfig(kind="freepie", port=0), self.clock)

    def let_come(self, yaw, pitch, roll):
        self.send(struct.pack("<BB12f", 0, 2, -yaw, pitch, -roll, *[0.0] * 9))


class FlockCase:
    """A Flock of Birds on a pseudo terminal."""

    def __init__(self, _tmp_path):
        self.clock = MonotonicClock()
        self.unit = FlockUnit()
        self.head = FlockOfBirds(FlockOfBirdsConfig(kind="flock_of_birds", device=self.unit.device), self.clock)

    def let_come(self, yaw, pitch, roll):
        self.unit.send((0, 0, 0, *(round(angle * 32768 / math.pi) for angle in (-yaw, pitch, roll))))

    def end(self):
        self.unit.end()


class SimulatedCase:
    """The simulated head."""

    exact = False

    def __init__(self, _tmp_path):
        self.clock = FakeClock(50.0)
        self.head = SimulatedHead(SimulatedHeadConfig(kind="simulator"), self.clock)

    def let_come(self, *_angles):
        self.clock.time += 0.1

    def end(self):
        """Do nothing: no other resource is held."""


class Recorded(SimulatedCase):
    """A recorded head."""

    def __init__(self, tmp_path):
        self.clock = FakeClock(50.0)
        file = tmp_path / "head.csv"
        rows = [f"{t / 10},{math.sin(t / 10) * 30},{math.cos(t / 7)},0.5" for t in range(60)]
        file.write_text("\n".join(["t,yaw_deg,pitch_deg,roll_deg", *rows]) + "\n")
        self.head = RecordedHead(RecordedHeadConfig(kind="recorded", file=str(file)), self.clock)


class Tablet(SimulatedCase):
    """A tablet's page."""

    exact = True

    def __init__(self, _tmp_path):
        self.clock = FakeClock(50.0)
        self.head = TabletHead(TabletHeadConfig(kind="tablet"), self.clock)

    def let_come(self, yaw, pitch, roll):
        self.head.look(yaw, pitch, roll)


HEADS = (OpentrackCase, FreepieCase, FlockCase, SimulatedCase, Recorded, Tablet)


def wait_for(head, good, seconds=20.0):
    """Poll until a pose is as wanted, because datagrams need a moment."""
    deadline = time.monotonic() + seconds
    while True:
        pose = head.newest()
        if pose is not None and good(pose):
            return pose
        assert time.monotonic() < deadline, pose
        time.sleep(0.005)
