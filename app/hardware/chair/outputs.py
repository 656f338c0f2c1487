"""What a receiver drives. Standard library only; what needs more is imported when it is asked for."""

import json
import math
import os
from collections.abc import Mapping
from importlib import import_module
from typing import Protocol

from app.geometry import Twist


class OutputRefused(Exception):  # noqa: N818
    """Why an output cannot be had, in one sentence."""


class Output(Protocol):
    """One way to a chair's motors."""

    is_real: bool  # whether something moves that a person may sit in

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Drive like this from `t` (s) on; called at every step, never waits. OSError: it takes no commands."""
        ...

    def close(self) -> None:
        """Give back what is held; the chair stands."""
        ...


class SimulatedDrive:
    """A differential drive that is a program: two wheels, and where they have led."""

    is_real = False
    WHEEL_DISTANCE = 0.55  # m, between the driven wheels of a powered chair

    def __init__(self) -> None:
        self.x = self.y = self.theta = 0.0  # m, m, rad
        self.left = self.right = 0.0  # m/s, of the wheels
        self._t: float | None = None

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:  # noqa: ARG002
        """Turn the wheels; what they did until now has moved the chair."""
        dt = 0.0 if self._t is None else t - self._t
        v, omega = (self.left + self.right) / 2, (self.right - self.left) / self.WHEEL_DISTANCE
        self.x += v * math.cos(self.theta) * dt
        self.y += v * math.sin(self.theta) * dt
        self.theta = math.remainder(self.theta + omega * dt, math.tau)
        half = twist.omega * self.WHEEL_DISTANCE / 2
        self.left, self.right, self._t = twist.v - half, twist.v + half, t

    def close(self) -> None:
        """Hold nothing."""


class Lines:
    """One JSON line for each change and at least every 100 ms, on stdout; a reader that does not read misses lines."""

    is_real = False
    EVERY = 0.1  # s

    def __init__(self, handle: int = 1) -> None:
        self._handle = handle
        os.set_blocking(handle, False)
        self._last: tuple[str, Twist, str] | None = None
        self._due = -math.inf
        self._rest = b""  # of a line that only partly went out: the next begins on a line of its own

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:
        """Say what is driven, when it is something else or was not said for long."""
        now = (state, twist, reason)
        if now == self._last and t < self._due:
            return
        self._last, self._due = now, t + self.EVERY
        line = {"t": round(t, 6), "state": state, "v": twist.v, "omega": twist.omega, "reason": reason}
        waiting = self._rest or json.dumps(line).encode() + b"\n"
        try:
            self._rest = waiting[os.write(self._handle, waiting) :]
        except BlockingIOError:
            self._last = None  # said as soon as there is room
        # What else goes wrong is for the caller: nobody is left who reads.

    def close(self) -> None:
        """Leave stdout as it was found."""
        os.set_blocking(self._handle, True)


OUTPUTS: Mapping[str, tuple[str, str]] = {
    "sim": (__name__, "SimulatedDrive"),
    "stdout": (__name__, "Lines"),
    "ros2": ("app.hardware.chair.ros2", "Ros2Twist"),
}


def open_output(word: str) -> Output:
    """Return the output of this name.

    Raises
    ------
    OutputRefused
        When there is no such output, or the library that it needs is missing.
    """
    if word not in OUTPUTS:
        raise OutputRefused(f"there is no output '{word}': use one of {', '.join(OUTPUTS)}")
    module, name = OUTPUTS[word]
    try:
        output: Output = getattr(import_module(module), name)()
    except ModuleNotFoundError as error:
        raise OutputRefused(
            f"the output '{word}' needs the library '{error.name}': install it with pip install 'bodydrive[{word}]'"
        ) from error
    return output
