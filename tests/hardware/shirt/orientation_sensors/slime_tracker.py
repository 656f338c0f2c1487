"""A tracker that behaves as the firmware SlimeVR-Tracker-ESP does, for tests: bytes out, bytes in, time given."""

import struct

import numpy as np

SERVER_SILENCE = 3.0  # s without a packet after which the tracker looks for a server again
EVERY_SECOND = 1.0  # s between two handshakes, and between two reports of a sensor


class SlimeTracker:
    """Looks for a server, then sends what its sensors measure once a period, numbered from 0 since its start.

    Attributes
    ----------
    still : set of int
        Sensors that lie quite still: the firmware sends no orientation that has not changed, and no acceleration
        without an orientation (OPTIMIZE_UPDATES).
    hung : set of int
        Sensors that hang: the tracker lives, and they send nothing.
    """

    def __init__(self, mac="A1:B2:C3:D4:E5:F6", sensors=(0,), flex=(), rate=50.0, sends_acceleration_alone=False):
        """`sends_acceleration_alone`: firmware that sends the acceleration of a sensor that lies still, too."""
        self.mac = mac
        self.sends_acceleration_alone = sends_acceleration_alone
        self.orientation = {sensor: np.array((0.0, 0.0, 0.0, 1.0)) for sensor in sensors}
        self.flex = dict.fromkeys(flex, 300.0)
        self.still, self.hung = set(), set()
        self.period = 1 / rate
        self.is_connected = False
        self.heartbeats = 0  # that came
        self._next_t = 0.0
        self.start()

    def start(self):
        """Begin as after the tracker was switched on."""
        self.number = 0
        self.is_connected = False
        self._heard_t = self._greeted_t = self._told_t = -np.inf
        self._acknowledged = set()

    def packet(self, kind, content=b""):
        """Return the next numbered packet."""
        self.number += 1
        return struct.pack(">IQ", kind, self.number - 1) + content

    def handshake(self):
        """Return the packet by which a tracker looks for a server; its number is always 0."""
        build, firmware = struct.pack(">7I", 4, 8, 2, 0, 0, 0, 22), b"0.7.0"
        name = bytes([len(firmware)]) + firmware
        return struct.pack(">IQ", 3, 0) + build + name + bytes.fromhex(self.mac.replace(":", "")) + b"\0"

    def rotation(self, sensor=0, kind=1):
        """Return the packet of an orientation."""
        return self.packet(17, struct.pack(">BB4fB", sensor, kind, *self.orientation[sensor], 0))

    def acceleration(self, sensor=0):
        """Return the packet of a sensor's acceleration."""
        return self.packet(4, struct.pack(">3fB", 0.0, 0.0, 0.0, sensor))

    def flexed(self, sensor):
        """Return the packet of a strain sensor."""
        return self.packet(26, struct.pack(">Bf", sensor, self.flex[sensor]))

    def battery(self, share):
        """Return the packet of the battery."""
        return self.packet(12, struct.pack(">2f", 3.7, share))

    def step(self, t):
        """Return what the tracker sends up to `t` (s)."""
        if self.is_connected and t - self._heard_t > SERVER_SILENCE:
            self.is_connected = False
            self._acknowledged.clear()
        if not self.is_connected:
            if t - self._greeted_t < EVERY_SECOND:
                return []
            self._greeted_t = t
            return [self.handshake()]
        sent = []
        if t - self._told_t >= EVERY_SECOND:
            self._told_t = t
            told = [sensor for sensor in self.orientation if sensor not in self._acknowledged]
            sent += [self.packet(15, struct.pack(">BBBHBB", sensor, 1, 8, 0, 0, 0)) for sensor in told]
        if t >= self._next_t - 1e-9:
            self._next_t = max(self._next_t + self.period, t)
            for sensor in self.orientation.keys() - self.hung:
                is_changed = sensor not in self.still
                sent += [self.rotation(sensor)] if is_changed else []
                sent += [self.acceleration(sensor)] if is_changed or self.sends_acceleration_alone else []
            sent += [self.flexed(sensor) for sensor in self.flex]
        return sent

    def hear(self, datagram, t):
        """Take what the server sends, and return the answers."""
        if not self.is_connected:
            self.is_connected = datagram[:13] == b"\x03Hey OVR =D 5"
            self._heard_t = t
            return []
        self._heard_t = t
        (kind,) = struct.unpack_from(">I", datagram)
        if kind == 1:
            self.heartbeats += 1
            return [self.packet(0)]
        if kind == 15:
            assert len(datagram) == 6
            self._acknowledged.add(datagram[4])
        return []
