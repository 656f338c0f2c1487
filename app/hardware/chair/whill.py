"""Output to a WHILL Model CR or CR2 over its serial line. Standard library only.

A frame is the byte AF, the length of what follows, a payload, and the XOR of all bytes before. Payloads with a command:

- 0, data set, interval u16 (ms), mode: the chair sends this data set again and again
- 3, whose joystick, front int8, side int8 (percent): 1 gives the chair back to its own joystick
- 8, whose joystick, front int16, side int16 (0.004 km/h): speeds; 0 turns the chair's own joystick off

Numbers are big-endian; front is forwards, side to the right. `side` is the difference of the speeds of both wheels, so
a turn rate is multiplied by the tread. Source: the maker's SDK (PyPI `whill` 1.5.0, MIT); for `side`, the maker's
`convert_radps_to_whill_speed` of ros_whill.

The chair's data set 1 has the speeds of both motors, of which one may count backwards. The maker's sources differ in
which: ros_whill negates the left one, the newest state of the SDK the right one, version 1.5.0 none. It is an option.
The SDK does not say whether the chair stops by itself when commands end; its newest state sends zeros after 0.1 s.
"""

import errno
import math
from collections.abc import Iterator
from functools import reduce
from operator import xor
from struct import Struct
from typing import NamedTuple

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.outputs import FASTEST_TWIST
from app.hardware.chair.readings import NO_TABLE, ChairReadings
from app.hardware.chair.reasons import Reason
from app.hardware.chair.serial_port import SerialPort

BAUD = 38_400
SIGN = 0xAF
START, SET_JOYSTICK, SET_VELOCITY = 0, 3, 8
HOST, OWN = 0, 1  # whose joystick counts
STATE_SET, STATE_MODE = 1, 5  # the data set of the chair's state; a mode counts for the other set only
STREAM_INTERVAL = 50  # ms between two states
LARGEST_LENGTH = 31  # of a frame from the chair, that of its state; a larger one is none

SPEED_STEP = 0.004 / 3.6  # m/s
MOST_AHEAD, MOST_BACK, MOST_SIDE = 1500, -500, 750  # steps
TOUCHED = 10  # percent from which a joystick counts as moved: more than it shows when nobody holds it

EVERY = 0.018  # s between two commands; at steps of 10 ms every second one. The chair needs 5 ms between two
SILENT = 0.3  # s without a state after which the chair does not answer
ASK_EVERY = 0.5  # s between two requests for its states

_VELOCITY = Struct(">BBhh")
_JOYSTICK = Struct(">BBbb")
_START = Struct(">BBHB")
_STATE = Struct(">B12xbbB2x4xhhBxBx")


UNMEASURED = Twist(math.nan, math.nan)


class WhillState(NamedTuple):
    """The chair's data set 1, as far as it is used."""

    front: int  # percent, of the chair's own joystick
    side: int  # percent, right positive
    battery: int  # percent
    right: float  # m/s, as the right motor counts
    left: float  # m/s
    is_on: bool
    error: int  # 0: none

    @property
    def is_touched(self) -> bool:
        """Whether somebody moves the chair's own joystick."""
        return max(abs(self.front), abs(self.side)) >= TOUCHED

    def measured(self, tread: float, backward_motor: str | None) -> Twist:
        """Return the speeds that the motors report; NaN where it is not known which of them counts backwards."""
        if backward_motor is None:
            return UNMEASURED
        right = -self.right if backward_motor == "right" else self.right
        left = -self.left if backward_motor == "left" else self.left
        return Twist((right + left) / 2, (right - left) / tread)


class WhillLine:
    """A WHILL on a serial line.

    While the receiver is armed, or ramps to standstill, the chair gets speeds, and its own joystick is off; otherwise
    its own joystick counts. Whoever moves that while armed so stops the chair, and has it after the ramp. Commands go
    at 50 Hz as long as this process lives. Not known, because the maker's sources do not say so: whether the chair
    stops by itself when they end (this process is killed, the cable is pulled), and whether it tells of its joystick
    while that is off. Both have to be tried with raised wheels before anybody sits in the chair.
    """

    is_real = True
    table = NO_TABLE

    def __init__(self, device: str, tread: float, backward_motor: str | None = None) -> None:
        """Open the line; raise OutputRefused when that is not possible.

        Parameters
        ----------
        device : str
            The serial line.
        tread : float
            m between the middles of the driven wheels.
        backward_motor : str or None
            "right" or "left": the motor whose speed is negative when the chair drives forwards; "none": neither. None:
            that is not known, and no speed counts as measured.
        """
        self._port = SerialPort(device, BAUD)
        self._tread, self._backward_motor = tread, backward_motor
        self.most = Twist(FASTEST_TWIST.v, min(FASTEST_TWIST.omega, MOST_SIDE * SPEED_STEP / tread))
        self._bytes = bytearray()
        self._state: WhillState | None = None  # the newest
        self._state_t = -math.inf  # s, when it came
        self._due = self._ask_due = -math.inf  # s
        self._has_driven = False

    def poll(self, t: float) -> ChairReadings:
        """Return the chair's newest readings; ask for them where none come."""
        self._bytes += self._port.read(t)
        for payload in payloads(self._bytes):
            newest = state_of(payload)
            if newest is not None:
                self._state, self._state_t = newest, t
        state = self._state
        if state is not None and t - self._state_t <= SILENT:
            charge = state.battery / 100 if state.battery <= 100 else math.nan
            trouble = Reason.CHAIR_ERROR if state.error else Reason.NONE if state.is_on else Reason.CHAIR_OFF
            v, omega = state.measured(self._tread, self._backward_motor)
            return ChairReadings(v, omega, charge, state.is_touched, trouble)
        self._state = None
        if t >= self._ask_due and self._port.write(start_command(), t):
            self._ask_due, self._due = t + ASK_EVERY, t + EVERY
        raise TimeoutError(errno.ETIMEDOUT, f"the chair on {self._port.device} reports nothing")

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:  # noqa: ARG002
        """Command `twist`, or give the chair back to its own joystick."""
        if t < self._due:
            return
        is_driven = state == "armed" or twist != STANDSTILL
        self._has_driven |= is_driven
        if self._port.write(velocity_command(twist, self._tread) if is_driven else release_command(), t):
            self._due = t + EVERY

    def description(self) -> str:
        """Return what the chair reports."""
        state = self._state
        if state is None:
            return (
                f"A serial line {self._port.device}: no WHILL reports anything on it. Switch the chair on, and connect "
                "its serial interface (Model CR and CR2 have one)."
            )
        v, omega = state.measured(self._tread, self._backward_motor)
        speeds = (
            f"measured speed {v:.2f} m/s and {omega:.2f} rad/s with a tread of {self._tread:g} m."
            if self._backward_motor is not None
            else f"its right motor at {state.right:.2f} m/s and its left one at {state.left:.2f} m/s. Which of them "
            "counts backwards is not given, so no speed counts as measured: drive forwards by the chair's own joystick "
            "during --check, and give the motor with the minus sign as --backward-motor."
        )
        return (
            f"A WHILL on {self._port.device}: {'on' if state.is_on else 'switched off'}, battery {state.battery} %, "
            f"error code {state.error}, its own joystick at {state.front} % ahead and {state.side} % to the right, "
            f"{speeds}"
        )

    def close(self) -> None:
        """Let the chair stand under its own joystick, and close the line."""
        try:
            if self._has_driven:
                self._port.write(release_command(), self._due)
        finally:
            self._port.close()


def frame(payload: bytes) -> bytes:
    """Return the bytes of a frame."""
    content = bytes((SIGN, len(payload) + 1)) + payload
    return content + bytes((reduce(xor, content),))


def start_command() -> bytes:
    """Return the frame that asks for the chair's state every `STREAM_INTERVAL` ms."""
    return frame(_START.pack(START, STATE_SET, STREAM_INTERVAL, STATE_MODE))


def release_command() -> bytes:
    """Return the frame that gives the chair back to its own joystick."""
    return frame(_JOYSTICK.pack(SET_JOYSTICK, OWN, 0, 0))


def velocity_command(twist: Twist, tread: float) -> bytes:
    """Return the frame that commands a twist; a faster one than the chair takes is cut to that, each axis by itself."""
    ahead = min(MOST_AHEAD, max(MOST_BACK, round(twist.v / SPEED_STEP)))
    side = min(MOST_SIDE, max(-MOST_SIDE, round(-twist.omega * tread / SPEED_STEP)))
    return frame(_VELOCITY.pack(SET_VELOCITY, HOST, ahead, side))


def payloads(received: bytearray) -> Iterator[bytes]:
    """Yield the payloads of whole, right frames; take these, and what belongs to no frame, out of `received`."""
    while True:
        start = received.find(SIGN)
        del received[: start if start >= 0 else len(received)]
        if len(received) < 2:
            return
        size = 2 + received[1]
        if not 4 <= size <= 2 + LARGEST_LENGTH:
            del received[0]
        elif len(received) < size:
            return
        elif reduce(xor, received[:size]):
            del received[0]
        else:
            payload = bytes(received[2 : size - 1])
            del received[:size]
            yield payload


def state_of(payload: bytes) -> WhillState | None:
    """Return the state in a payload; None when it holds something else."""
    if len(payload) != _STATE.size or payload[0] != STATE_SET:
        return None
    _, front, side, battery, right, left, power, error = _STATE.unpack(payload)
    return WhillState(front, side, battery, right * SPEED_STEP, left * SPEED_STEP, power != 0, error)
