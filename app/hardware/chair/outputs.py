"""The outputs that a receiver drives. Standard library only; an output with other libraries is imported on demand."""

import json
import math
import os
import select
from collections.abc import Mapping
from importlib import import_module
from typing import Protocol

from app.geometry import Pose, Twist
from app.hardware.chair.odometry import arc

STDOUT = 1


class OutputRefused(Exception):  # noqa: N818
    """Why an output cannot be opened, in one sentence."""


class Output(Protocol):
    """An output to a chair's motors."""

    is_real: bool  # whether the output moves a chair that a person may sit in

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Drive `twist` from `t` (s) on. Called at every step; never waits. OSError: the output accepts no commands."""
        ...

    def close(self) -> None:
        """Let the chair stand, and release the output."""
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
    EVERY = 0.1  # s
    MARGIN = 0.02  # s, two steps: a line that would be due before the next step, or during a late one, is written now

    def __init__(self, handle: int = STDOUT) -> None:
        self._sink = Sink(handle)
        self._last: tuple[str, Twist, str] | None = None
        self._due = -math.inf

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Write a line when something has changed or the last line is too old."""
        now = (state, twist, reason)
        if now == self._last and t < self._due:
            return
        line = {"t": round(t, 6), "state": state, "v": twist.v, "omega": twist.omega, "reason": reason}
        if self._sink.put(json.dumps(line)):
            self._last, self._due = now, t + self.EVERY - self.MARGIN

    def close(self) -> None:
        """Do nothing: no resource is held."""


class SimulatedDrive:
    """A simulated differential drive: two wheels, the pose, and a line about both every second."""

    is_real = False
    WHEEL_DISTANCE = 0.55  # m between the driven wheels of a powered chair
    EVERY = 1.0  # s

    def __init__(self, handle: int = STDOUT) -> None:
        self.pose = Pose(0.0, 0.0, 0.0)
        self.left = self.right = 0.0  # m/s, of the wheels
        self._sink = Sink(handle)
        self._t: float | None = None
        self._state = ""
        self._due = -math.inf

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Integrate the pose up to `t`, then set the speeds of the wheels."""
        dt = 0.0 if self._t is None else t - self._t
        turned = Twist((self.left + self.right) / 2, (self.right - self.left) / self.WHEEL_DISTANCE)
        self.pose = arc(self.pose, turned, dt)
        half = twist.omega * self.WHEEL_DISTANCE / 2
        self.left, self.right, self._t = twist.v - half, twist.v + half, t
        if (state != self._state or t >= self._due) and self._sink.put(self._words(state, reason)):
            self._state, self._due = state, t + self.EVERY

    def close(self) -> None:
        """Do nothing: no resource is held."""

    def _words(self, state: str, reason: str) -> str:
        x, y, theta = self.pose
        where = f"at ({x:.2f}, {y:.2f}) m, heading {math.degrees(theta):.0f} degrees"
        text = f"{state}: wheels at {self.left:.2f} and {self.right:.2f} m/s, {where}."
        return f"{text} {reason}" if reason else text


OUTPUTS: Mapping[str, tuple[str, str]] = {
    "sim": (__name__, "SimulatedDrive"),
    "stdout": (__name__, "Lines"),
    "ros2": ("app.hardware.chair.ros2", "Ros2Twist"),
}


def open_output(word: str) -> Output:
    """Return the output of this name in `OUTPUTS`.

    Raises
    ------
    OutputRefused
        When its library is missing or cannot start.
    """
    module, name = OUTPUTS[word]
    try:
        output: Output = getattr(import_module(module), name)()
    except ModuleNotFoundError as error:
        raise OutputRefused(
            f"the output {word} needs the library {error.name}, install it with pip install 'bodydrive[{word}]'"
        ) from error
    return output
