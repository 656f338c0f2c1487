"""From speeds to the percents of a chair's joystick, by the tables in the chair's document. Standard library only.

A chair document is JSON: `{"version": 1, "dead_band": 8, "forward": [[20, 0.2], [60, 0.7]], "back": ..., "turn": ...}`.
A row is a deflection in percent and the speed that it gives, m/s or rad/s, each larger than the row before;
`dead_band` is the largest deflection in percent at which the chair still stands. Optional: `name` of the chair, and
`lag`, s from a command to the movement. `bodydrive chair measure` writes one.
"""

import bisect
import hashlib
import json
import math
import os
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple, NoReturn, TypeGuard

from app.geometry import Twist
from app.hardware.chair.outputs import FASTEST_TWIST, OutputRefused
from app.hardware.chair.packet import DIGEST_BYTES
from app.hardware.chair.readings import TableReport

FULL = 100.0  # percent
MOST_BYTES = 64 * 1024  # of a document
MOST_ROWS = 100  # of a table
LARGEST_NUMBER = 1e6  # of those that are compared with a bound
LARGEST_DEAD_BAND = 50.0  # percent
VERSION = 1
FIELDS = ("version", "name", "dead_band", "forward", "back", "turn", "lag")
MOST_LETTERS = 80  # of a name
LARGEST_LAG = 5.0  # s
SHOWN_DIGITS = 12  # of a document's SHA-256, in hexadecimal
LARGEST_SPEED = {"forward": 6.0, "back": 6.0, "turn": 6.0}  # m/s, m/s, rad/s: a larger one is a mistake

# Without a document the chair is taken for one that full deflection drives at 15 km/h, the fastest that EN 12184 has,
# and turns at 4 rad/s: every other chair then drives slower than it is commanded.
ASSUMED_SPEED, ASSUMED_TURN_RATE = 4.2, 4.0  # m/s, rad/s
UNMEASURED_MOST = Twist(0.3, 0.5)  # m/s, rad/s: at 0.5 rad/s the feet, 0.6 m ahead of the axle, move at 0.3 m/s


class AxisTable(NamedTuple):
    """Speeds (m/s or rad/s) and the deflections (percent) that give them, both ascending; the first speed is 0."""

    speeds: tuple[float, ...]
    percents: tuple[float, ...]

    def percent(self, speed: float) -> float:
        """Return the deflection for a speed of 0 or more; beyond the table's last one its last deflection."""
        if not speed > 0.0:
            return 0.0
        if speed >= self.speeds[-1]:
            return self.percents[-1]
        above = bisect.bisect_right(self.speeds, speed)
        low, high = self.speeds[above - 1], self.speeds[above]
        share = (speed - low) / (high - low)
        return self.percents[above - 1] + share * (self.percents[above] - self.percents[above - 1])


class JoystickTable(NamedTuple):
    """The tables of one chair, each measured with the other axis at its centre."""

    forward: AxisTable
    back: AxisTable
    turn: AxisTable
    most: Twist  # m/s forwards, rad/s: the fastest that is commanded
    report: TableReport
    note: str  # of what it was made, for who sets the output up

    def deflection(self, twist: Twist) -> tuple[float, float]:
        """Return the deflection of the joystick for a twist: percent forwards, percent to the right."""
        ahead = self.forward.percent(twist.v) if twist.v > 0.0 else -self.back.percent(-twist.v)
        return ahead, -math.copysign(self.turn.percent(abs(twist.omega)), twist.omega)


def _straight(speed: float) -> AxisTable:
    return AxisTable((0.0, speed), (0.0, FULL))


UNMEASURED = JoystickTable(
    _straight(ASSUMED_SPEED),
    _straight(ASSUMED_SPEED),
    _straight(ASSUMED_TURN_RATE),
    UNMEASURED_MOST,
    TableReport(is_crawling=True),
    f"No chair document is given, so full deflection is taken for {ASSUMED_SPEED:g} m/s and {ASSUMED_TURN_RATE:g} "
    f"rad/s, and at most {UNMEASURED_MOST.v:g} m/s and {UNMEASURED_MOST.omega:g} rad/s are commanded. A chair that is "
    "slower by itself drives slower than that, or not at all.",
)


def joystick_table(file: Path | None) -> JoystickTable:
    """Return the tables in a chair document, without one those of `UNMEASURED`.

    Raises
    ------
    OutputRefused
        In one sentence, when the file cannot be read or is none.
    """
    return UNMEASURED if file is None else table_of(_content(file), file)


def _content(file: Path) -> str:
    try:
        handle = os.open(file, os.O_RDONLY | os.O_NONBLOCK)  # does not wait for a pipe
        with open(handle, encoding="utf-8", newline="") as opened:
            text = opened.read(MOST_BYTES + 1)
    except OSError as error:
        raise OutputRefused(f"the chair document {file} cannot be read ({error.strerror}): correct its name") from error
    except ValueError as error:
        raise OutputRefused(f"the chair document {file} is no text in UTF-8: give the file that was made") from error
    if len(text) > MOST_BYTES:
        raise OutputRefused(f"the chair document {file} is larger than {MOST_BYTES} bytes: give another file")
    return text


def table_of(text: str, file: Path) -> JoystickTable:
    """Return the tables in the text of a chair document; raise OutputRefused, which names `file`, when it is none."""

    def refuse(problem: str) -> NoReturn:
        raise OutputRefused(f"the chair document {file} cannot be used: {problem}")

    try:
        document = json.loads(text, parse_constant=lambda word: refuse(f"{word} is no number"))
    except (ValueError, RecursionError) as error:
        raise OutputRefused(f"the chair document {file} is no JSON ({error}): give the file that was made") from error
    if not isinstance(document, dict):
        refuse("it must be an object with the tables forward, back and turn")
    foreign = sorted(document.keys() - set(FIELDS))
    if foreign:
        refuse(f"it has no field {foreign[0][:MOST_LETTERS]!r}, only {', '.join(FIELDS)}")
    version, name, lag = document.get("version"), document.get("name", ""), document.get("lag", 0.0)
    if version != VERSION or not _is_number(version):
        refuse(f"version must be {VERSION}")
    if not isinstance(name, str) or len(name) > MOST_LETTERS:
        refuse(f"name must be a text of at most {MOST_LETTERS} letters")
    if not _is_number(lag) or not 0.0 <= lag <= LARGEST_LAG:
        refuse(f"lag must be a number of seconds from 0 to {LARGEST_LAG:g}")
    dead_band = document.get("dead_band")
    if not _is_number(dead_band) or not 0.0 <= dead_band <= LARGEST_DEAD_BAND:
        refuse(f"dead_band must be a number from 0 to {LARGEST_DEAD_BAND:g}")
    axes = []
    for axis, largest in LARGEST_SPEED.items():
        rows = document.get(axis)
        if not _is_table(rows):
            refuse(f"{axis} must be 1 to {MOST_ROWS} rows of two numbers, such as [[50, 0.4], [100, 0.9]]")
        percents = (float(dead_band), *(float(percent) for percent, _ in rows))
        speeds = (0.0, *(float(speed) for _, speed in rows))
        if not (_ascends(percents) and _ascends(speeds)):
            refuse(f"in {axis} each row must be larger than the one before, the first than the dead band and speed 0")
        if percents[-1] > FULL or speeds[-1] > largest:
            refuse(f"in {axis} a deflection is above {FULL:g} percent, or a speed above {largest:g}")
        axes.append(AxisTable(speeds, percents))
    forward, back, turn = axes
    most = Twist(min(forward.speeds[-1], FASTEST_TWIST.v), min(turn.speeds[-1], FASTEST_TWIST.omega))
    digest = hashlib.sha256(text.encode()).digest()
    note = f"Speeds are by the chair document {file}, whose SHA-256 begins with {digest.hex()[:SHOWN_DIGITS]}."
    return JoystickTable(forward, back, turn, most, TableReport(digest[:DIGEST_BYTES]), note)


def _is_number(value: object) -> TypeGuard[float]:
    """Return whether a value of a JSON document is a number that can be compared; true and 1e999 are none."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= LARGEST_NUMBER


def _is_table(rows: object) -> TypeGuard[list[list[float]]]:
    return (
        isinstance(rows, list)
        and 1 <= len(rows) <= MOST_ROWS
        and all(isinstance(row, list) and len(row) == 2 and all(map(_is_number, row)) for row in rows)
    )


def _ascends(numbers: Sequence[float]) -> bool:
    return all(low < high for low, high in pairwise(numbers))
