"""Output to a joystick interface by two voltages, through a board on a serial line. Standard library only.

The board (examples/firmware/chair_output) takes commands that answer one of its statuses of the last 100 ms, in the
order of their numbers, with the tag of the chair's key: what was recorded, kept back or meant for another chair does
nothing. Little-endian:

- command, 38 bytes: magic `BMIC`, version 1, flags u8 (1: drive), forwards i16, right i16 (per mille of full
  deflection), number u32, and of the answered status its time u32 (ms) and the board's boot u32; tag: the first 16
  bytes of HMAC-SHA-256 over bytes 0..21
- status, 20 bytes, every 20 ms: magic `BMIB`, version 1, state u8, number u32 of the last command that was obeyed, time
  u32 (ms since the boot), boot u32, CRC-16/CCITT-FALSE u16 over all before
"""

import errno
import hmac
import math
from binascii import crc_hqx
from collections import deque
from pathlib import Path
from struct import Struct
from typing import NamedTuple

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.chair_document import FULL, joystick_table
from app.hardware.chair.key import Key, KeyRefused, read_key
from app.hardware.chair.outputs import OutputRefused
from app.hardware.chair.readings import NO_READINGS, ChairReadings
from app.hardware.chair.serial_port import SerialPort

BAUD = 115_200
VERSION = 1
COMMAND_MAGIC, STATUS_MAGIC = b"BMIC", b"BMIB"
DRIVE = 1  # flag of a command
PER_MILLE = 1000
TAG_BYTES = 16
CRC_START = 0xFFFF
_COMMAND = Struct("<4sBBhhIII")
_STATUS = Struct("<4sBBIIIH")

EVERY = 0.018  # s between two commands: at steps of 10 ms every second one; the board waits 45 ms
SILENT = 0.1  # s without a status after which the board does not answer
UNANSWERED = 0.15  # s after which a command that the board has not obeyed is too old
MOST_UNANSWERED = 50  # commands

# What the board says of itself, by its state.
STATES = {
    0: "its relay is open, and it waits for a command to stand",
    1: "its relay is open",
    2: "its relay is closed, and it drives",
    3: "it has no key yet",
    4: "a converter from numbers to voltages does not answer it",
}
TROUBLES = (3, 4)  # states in which the board obeys nothing


class BoardStatus(NamedTuple):
    """A report of the board."""

    state: int  # one of STATES
    number: int  # of the last command that it obeyed; 0: it has obeyed none, or fell silent since
    time: int  # ms since its boot
    boot: int  # counts its starts


class AnalogBoard:
    """A board on a serial line.

    45 ms after the last command, at its start, and after a reset by a brown-out or its watchdog, the board's relay puts
    the chair's inputs at their centre, which needs no program; then it waits for a command to stand.
    """

    is_real = True

    def __init__(self, device: str, key_file: Path, chair_document: Path | None = None) -> None:
        """Raise OutputRefused for a wrong document or key, or when the line cannot be opened."""
        try:
            self._key = read_key(key_file)
        except KeyRefused as error:
            raise OutputRefused(str(error)) from error
        self._table = joystick_table(chair_document)
        self.most, self.table = self._table.most, self._table.report
        self._port = SerialPort(device, BAUD)
        self._bytes = bytearray()
        self._status: BoardStatus | None = None  # the newest
        self._status_t = self._due = -math.inf  # s
        self._number = 0  # of the last command
        self._unanswered: deque[tuple[int, float]] = deque(maxlen=MOST_UNANSWERED)  # number, when it was sent (s)

    def poll(self, t: float) -> ChairReadings:
        """Take in the board's statuses; OSError when none come, or it does not obey. The board knows nothing else."""
        self._bytes += self._port.read(t)
        has_restarted = False
        for status in statuses(self._bytes):
            if self._status is not None and status.boot != self._status.boot:
                has_restarted = True
                self._unanswered.clear()
            self._status, self._status_t = status, t
        if self._status is None or t - self._status_t > SILENT:
            self._status = None
            self._unanswered.clear()
            raise TimeoutError(errno.ETIMEDOUT, f"the board on {self._port.device} reports nothing")
        while self._unanswered and self._unanswered[0][0] <= self._status.number:
            self._unanswered.popleft()
        if has_restarted or self._status.state in TROUBLES:
            why = "it has started again" if has_restarted else STATES[self._status.state]
            raise OSError(errno.EIO, f"the board on {self._port.device}: {why}")
        if self._unanswered and t - self._unanswered[0][1] > UNANSWERED:
            raise TimeoutError(errno.ETIMEDOUT, f"the board on {self._port.device} obeys no command")
        return NO_READINGS

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:  # noqa: ARG002
        """Command the deflection of `twist`, or the centre with the relay open while the chair is disarmed."""
        self.deflect(t, state == "armed" or twist != STANDSTILL, *self._table.deflection(twist))

    def deflect(self, t: float, is_driven: bool, ahead: float, right: float) -> None:
        """Command a deflection in percent; the relay is open unless `is_driven`."""
        if t < self._due or self._status is None:
            return
        if self._port.write(self._command(self._status, is_driven, ahead, right), t):
            self._unanswered.append((self._number, t))
            self._due = t + EVERY

    def description(self) -> str:
        """Return what the board says."""
        status = self._status
        found = (
            "nothing comes from it, load examples/firmware/chair_output into it"
            if status is None
            else f"{STATES.get(status.state, 'its state is unknown')}; start {status.boot} of the board"
        )
        return (
            f"A board on {self._port.device}: {found}. The chair's own joystick and its speed are not known to it. "
            f"{self._table.note}"
        )

    def close(self) -> None:
        """Put the chair's inputs at their centre, and close the line."""
        try:
            if self._status is not None and self._number:
                self._port.write(self._command(self._status, False, 0.0, 0.0), self._due)
        finally:
            self._port.close()

    def _command(self, status: BoardStatus, is_driven: bool, *percents: float) -> bytes:
        """Return the next command, which answers `status`; `percents` are forwards and to the right."""
        self._number += 1
        forwards, right = (round(PER_MILLE * percent / FULL) for percent in percents)
        return command_bytes(self._key, is_driven, forwards, right, self._number, status)


def command_bytes(key: Key, is_driven: bool, forwards: int, right: int, number: int, status: BoardStatus) -> bytes:
    """Return the 38 bytes of a command, in per mille of full deflection, that answers a status."""
    flags = DRIVE if is_driven else 0
    body = _COMMAND.pack(COMMAND_MAGIC, VERSION, flags, forwards, right, number, status.time, status.boot)
    return body + hmac.digest(key.secret, body, "sha256")[:TAG_BYTES]


def statuses(received: bytearray) -> list[BoardStatus]:
    """Return the whole, right statuses; take these, and what belongs to none, out of `received`."""
    found: list[BoardStatus] = []
    while True:
        start = received.find(STATUS_MAGIC)
        if start < 0:  # the magic may have begun
            del received[: max(0, len(received) - len(STATUS_MAGIC) + 1)]
            return found
        del received[:start]
        if len(received) < _STATUS.size:
            return found
        content = bytes(received[: _STATUS.size])
        _, version, state, number, time, boot, checksum = _STATUS.unpack(content)
        if version == VERSION and checksum == crc_hqx(content[:-2], CRC_START):
            found.append(BoardStatus(state, number, time, boot))
            del received[: _STATUS.size]
        else:
            del received[0]
