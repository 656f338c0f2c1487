"""A chair's end of the chair link for tests: notes commands with a valid tag, and sends scripted telemetry."""

import socket

from app.hardware.chair.key import new_key, write_key
from app.hardware.chair.packet import Telemetry, decode_command, encode_telemetry, is_hello
from app.hardware.configs import RealChairConfig

DISARMED, CHECKING, ARMED, FAULT = range(4)
SPEEDS = (
    {"forward": 0.8, "reverse": 0.3, "turn": 1.2}
    | {"acceleration": 0.8, "deceleration": 1.2, "turn_acceleration": 6.0}
    | {"jerk": 8.0, "turn_jerk": 60.0}
)


class StandInChair:
    """A chair that listens on its own port."""

    def __init__(self, folder):
        self.key = new_key(7)
        self.key_file = folder / "7.key"
        write_key(self.key_file, self.key)
        self.nonce = b"nonce--1"
        self.t_ns = 1_000_000
        self.hellos = self.refused = 0
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.setblocking(False)
        self._sender = None

    @property
    def document(self):
        host, port = self.socket.getsockname()
        where = {"name": "Salon", "host": host, "port": port, "key_file": str(self.key_file)}
        return {"kind": "udp", **where, "speeds": SPEEDS}

    @property
    def config(self):
        return RealChairConfig.model_validate(self.document)

    def commands(self):
        """Return the commands that have come since the last call."""
        found = []
        while True:
            try:
                datagram, self._sender = self.socket.recvfrom(100)
            except BlockingIOError:
                return found
            if is_hello(datagram, self.key.id):
                self.hellos += 1
                continue
            command = decode_command(datagram, self.key, self.nonce)
            if command is None:
                self.refused += 1
            else:
                found.append(command)

    def telemetry(self, state=DISARMED, epoch=0, sequence=0, **changes):
        """Return the bytes of a telemetry, 0.1 s of the chair's time after the one before."""
        self.t_ns += 100_000_000
        said = Telemetry(state, self.key.id, epoch, sequence, self.t_ns, self.nonce, 0.0, 0.0, 0.5, 0, 0)
        return encode_telemetry(said._replace(**changes), self.key)

    def say(self, state=DISARMED, epoch=0, sequence=0, **changes):
        """Send a telemetry to the last sender, and return its bytes."""
        datagram = self.telemetry(state, epoch, sequence, **changes)
        self.send(datagram)
        return datagram

    def send(self, datagram):
        self.socket.sendto(datagram, self._sender)

    def close(self):
        self.socket.close()
