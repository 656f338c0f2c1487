"""The outputs that a receiver drives. Standard library only; an output with other libraries is imported on demand."""

import json
import math
import os
import select
from collections.abc import Mapping
from importlib import import_module
from typing import NamedTuple, Protocol

from app.geometry import Pose, Twist
from app.hardware.chair.odometry import arc
from app.hardware.chair.readings import NO_READINGS, NO_TABLE, ChairReadings, TableReport
from app.speed_ceiling import HIGHEST_SPEED, HIGHEST_TURN_RATE

STDOUT = 1
FASTEST_TWIST = Twist(HIGHEST_SPEED, HIGHEST_TURN_RATE)
NO_CHAIR = "no chair is connected, so there is nothing to look at"


class OutputRefused(Exception):  # noqa: N818
    """Why an output cannot be opened, in one sentence."""


class Output(Protocol):
    """An output to a chair's motors.

    Each step calls `poll`, then `drive`. Neither waits: what hangs ends in an OSError, with which the receiver stops
    (docs/safety.md says for each output what the chair does then). An output that failed is tried again at every step.
    """

    is_real: bool  # whether the output moves a chair that a person may sit in
    most: Twist  # m/s, rad/s: the fastest that the output drives, forwards and in a turn
    table: TableReport  # of its chair document

    def poll(self, t: float) -> ChairReadings:
        """Return what the chair has reported of itself up to `t` (s). OSError: the chair does not answer."""
        ...

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Drive `twist` from `t` (s) on. OSError: the output accepts no commands."""
        ...

    def description(self) -> str:
        """Return what was found at the output, for who sets it up; nothing has to be driven before."""
        ...

    def close(self) -> None:
        """Let the chair stand, and release the output."""
        ...


class JoystickOutput(Output, Protocol):
    """An output that sets the deflection of a joystick, and takes the chair document that says what speed that is."""

    def deflect(self, t: float, is_driven: bool, ahead: float, right: float) -> None:
        """Set a deflection in percent, forwards and to the right, at `t` (s); not `is_driven`: the chair is let go.

        OSError: as of `drive`.
        """
        ...


class Sink:
    """Lines to a reader that may be slow: a line that would have to wait is not written."""

    def __init__(self, handle: int) -> None:
        self._handle = handle
        self._writable = select.poll()
        self._writable.register(handle, select.POLLOUT)

    def put(self, line: str) -> bool:
        """Write a line; return False when there is no room, raise OSError when the reader has gone.

        A pipe that is ready has room for a page, more than any line here; so the pipe, which is shared with other
        programs, need not be set to non-blocking.
        """
        if not self._writable.poll(0):
            return False
        os.write(self._handle, f"{line}\n".encode())
        return True


class Lines:
    """One JSON line for each change and at least every 100 ms; a reader that does not read misses lines."""

    is_real = False
    most = FASTEST_TWIST
    table = NO_TABLE
    EVERY = 0.1  # s
    MARGIN = 0.02  # s, two steps: a line that would be due before the next step, or during a late one, is written now

    def __init__(self, handle: int = STDOUT) -> None:
        self._sink = Sink(handle)
        self._last: tuple[str, Twist, str] | None = None
        self._due = -math.inf

    def poll(self, t: float) -> ChairReadings:  # noqa: ARG002
        """Return no readings: nothing is connected."""
        return NO_READINGS

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Write a line when something has changed or the last line is too old."""
        now = (state, twist, reason)
        if now == self._last and t < self._due:
            return
        line = {"t": round(t, 6), "state": state, "v": twist.v, "omega": twist.omega, "reason": reason}
        if self._sink.put(json.dumps(line)):
            self._last, self._due = now, t + self.EVERY - self.MARGIN

    def description(self) -> str:
        """Return that nothing is connected."""
        return f"Lines to the standard output: {NO_CHAIR}."

    def close(self) -> None:
        """Do nothing: no resource is held."""


class SimulatedDrive:
    """A simulated differential drive: two wheels, the pose, and a line about both every second."""

    is_real = False
    most = FASTEST_TWIST
    table = NO_TABLE
    WHEEL_DISTANCE = 0.55  # m between the driven wheels of a powered chair
    EVERY = 1.0  # s

    def __init__(self, handle: int = STDOUT) -> None:
        self.pose = Pose(0.0, 0.0, 0.0)
        self.left = self.right = 0.0  # m/s, of the wheels
        self._sink = Sink(handle)
        self._t: float | None = None
        self._state = ""
        self._due = -math.inf

    def poll(self, t: float) -> ChairReadings:  # noqa: ARG002
        """Return the speeds of the wheels, as measured."""
        return ChairReadings(*self._measured)

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Integrate the pose up to `t`, then set the speeds of the wheels."""
        dt = 0.0 if self._t is None else t - self._t
        self.pose = arc(self.pose, self._measured, dt)
        half = twist.omega * self.WHEEL_DISTANCE / 2
        self.left, self.right, self._t = twist.v - half, twist.v + half, t
        if (state != self._state or t >= self._due) and self._sink.put(self._words(state, reason)):
            self._state, self._due = state, t + self.EVERY

    def description(self) -> str:
        """Return that nothing is connected."""
        return f"A simulated drive: {NO_CHAIR}."

    def close(self) -> None:
        """Do nothing: no resource is held."""

    @property
    def _measured(self) -> Twist:
        return Twist((self.left + self.right) / 2, (self.right - self.left) / self.WHEEL_DISTANCE)

    def _words(self, state: str, reason: str) -> str:
        x, y, theta = self.pose
        where = f"at ({x:.2f}, {y:.2f}) m, heading {math.degrees(theta):.0f} degrees"
        text = f"{state}: wheels at {self.left:.2f} and {self.right:.2f} m/s, {where}."
        return f"{text} {reason}" if reason else text


class OutputRow(NamedTuple):
    """Where an output is, and the options that its constructor takes by name."""

    module: str
    name: str
    needs: tuple[str, ...] = ()
    takes: tuple[str, ...] = ()
    extra: str = ""  # of the package, with the output's library


OUTPUTS: Mapping[str, OutputRow] = {
    "sim": OutputRow(__name__, "SimulatedDrive"),
    "stdout": OutputRow(__name__, "Lines"),
    "ros2": OutputRow("app.hardware.chair.ros2", "Ros2Twist", takes=("topic", "message", "frame"), extra="ros2"),
    "luci": OutputRow("app.hardware.chair.luci", "LuciRemote", takes=("chair_document",), extra="ros2"),
    "whill": OutputRow("app.hardware.chair.whill", "WhillLine", needs=("device", "tread"), takes=("backward_motor",)),
    "analog": OutputRow(
        "app.hardware.chair.analog", "AnalogBoard", needs=("device", "key_file"), takes=("chair_document",)
    ),
}
# Those of a class with the methods of JoystickOutput.
JOYSTICK_OUTPUTS = tuple(word for word, row in OUTPUTS.items() if "chair_document" in row.takes)
# Each of some outputs only.
OWN_OPTIONS = ("device", "tread", "backward_motor", "topic", "message", "frame", "chair_document")


def open_output(word: str, given: Mapping[str, object] | None = None) -> Output:
    """Return the output of this name in `OUTPUTS`; None among the `given` options: the option was not given.

    Raises
    ------
    OutputRefused
        When an option is missing or is another output's, or its library or its device is missing or cannot start.
    """
    row = OUTPUTS[word]
    options = {name: value for name, value in (given or {}).items() if value is not None}
    foreign = next((name for name in OWN_OPTIONS if name in options and name not in row.needs + row.takes), None)
    if foreign is not None:
        raise OutputRefused(f"the output {word} does not take {_flag(foreign)}: leave it out")
    missing = next((name for name in row.needs if name not in options), None)
    if missing is not None:
        raise OutputRefused(f"the output {word} needs {_flag(missing)}: --help says what that is")
    try:
        made = getattr(import_module(row.module), row.name)
    except ModuleNotFoundError as error:
        raise OutputRefused(
            f"the output {word} needs the library {error.name}, install it with pip install 'bodydrive[{row.extra}]'"
        ) from error
    output: Output = made(**{name: options[name] for name in row.needs + row.takes if name in options})
    return output


def _flag(name: str) -> str:
    return f"--{name.replace('_', '-')}"
