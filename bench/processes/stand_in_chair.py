"""Stands in for a chair's receiver: arms, obeys and disarms as docs/protocols.md, section 9, says; nothing moves."""

import math
import secrets

from app.hardware.chair.key import Key
from app.hardware.chair.packet import (
    DRIVE,
    NONCE_BYTES,
    STOP,
    Command,
    Telemetry,
    decode_command,
    encode_telemetry,
    is_hello,
)

DISARMED, CHECKING, ARMED = 0, 1, 2
NEUTRAL_TIME = 0.5  # s of zero commands before it drives
SILENT = 0.3  # s without a command, then it disarms
TELEMETRY_EVERY = 0.1  # s


class StandInChair:
    """Takes datagrams and says what to answer; without clock or socket. All times are monotonic s."""

    def __init__(self, key: Key) -> None:
        self._key = key
        self._command: Command | None = None  # the newest of this epoch
        self._ended = 0  # the epoch that was ended last
        self._since = self._heard = self._told = -math.inf
        self.was_greeted = False  # the last datagram was a hello
        self.state = DISARMED
        self._nonce = secrets.token_bytes(NONCE_BYTES)
        self._asked = True  # telemetry is due at once

    def take(self, datagram: bytes, now: float) -> Command | None:
        """Return the command in `datagram`, None when it is none or not for now."""
        command = decode_command(datagram, self._key, self._nonce)
        self.was_greeted = command is None and is_hello(datagram, self._key.id)
        self._asked = self._asked or self.was_greeted
        if command is None or not math.isfinite(command.v + command.omega):
            return None
        zero = command.v == 0.0 == command.omega
        if self.state == DISARMED:
            if not zero or command.flags & STOP or command.epoch == self._ended:
                return None
            self.state, self._since, self._asked = CHECKING, now, True
        elif self._command and (command.epoch != self._command.epoch or command.sequence <= self._command.sequence):
            return None
        withdrawn = self.state == ARMED and self._command and self._command.flags & ~command.flags & DRIVE
        self._command, self._heard = command, now
        if command.flags & STOP or withdrawn:
            self._withdraw()
        elif self.state == CHECKING and not zero:
            self._since = now
        elif self.state == CHECKING and now - self._since >= NEUTRAL_TIME:
            self.state, self._asked = ARMED, True
        return command

    def answer(self, now: float) -> bytes | None:
        """Return the telemetry that is due at `now`: every 0.1 s, at each change of state, and when asked for."""
        if self.state != DISARMED and now - self._heard > SILENT:
            self._withdraw()
        if not self._asked and now - self._told < TELEMETRY_EVERY:
            return None
        self._asked, self._told = False, now
        epoch, sequence, v, omega = 0, 0, 0.0, 0.0
        if self._command:
            epoch, sequence = self._command.epoch, self._command.sequence
            v, omega = (self._command.v, self._command.omega) if self.state == ARMED else (0.0, 0.0)
        telemetry = Telemetry(
            self.state, self._key.id, epoch, sequence, int(now * 1e9), self._nonce, v, omega, math.nan, 0, 0
        )
        return encode_telemetry(telemetry, self._key)

    def _withdraw(self) -> None:
        """Disarm: from now on only a new epoch under a new nonce counts."""
        self.state = DISARMED
        self._ended = self._command.epoch if self._command else 0
        self._nonce = secrets.token_bytes(NONCE_BYTES)
        self._asked = True
