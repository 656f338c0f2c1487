"""The decisions of a guided drive, which measures what speed each deflection of a chair's joystick gives.

No clock, no terminal, no chair; standard library only. `app.hardware.chair.chair_measure` is the program around it.
"""

import math
import re
from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple

from app.geometry import Twist
from app.hardware.chair.chair_document import FULL, LARGEST_DEAD_BAND, LARGEST_LAG, LARGEST_SPEED, VERSION
from app.hardware.chair.readings import ChairReadings

FINE, COARSE = 5, 10  # percent from one drive to the next: until the chair moves, afterwards
LONGEST = 10.0  # s of a drive
NEUTRAL = 0.5  # s at the centre before a drive
RISE = 0.5  # s in which the deflection rises; at the end it is let go at once, as a hand lets go of a joystick
STALL = 0.1  # s between two steps after which the drive is ended
STEADY_AFTER = 2.0  # s from which the measured speed counts as that of the deflection
LEAST_STEADY = 1.0  # s of steady drive whose mean counts
MOVES = 0.02  # m/s or rad/s from which a measured speed is a movement
WRONG_WAY = 0.05  # m/s or rad/s
TOO_FAST = 1.5  # times the limit: where the chair measures its speed, the drive ends there
SHORTEST_DISTANCE, LONGEST_DISTANCE = 0.05, 50.0  # m
SMALLEST_TURN, LARGEST_TURN = 5.0, 7200.0  # degrees
SHORTEST_TIME = 0.2  # s between two marks
NUMBER = re.compile(r"[0-9]{1,6}(\.[0-9]{1,6})?")
DONE, AGAIN, QUIT = "done", "again", "quit"

# For each table of the document: the direction of the joystick, forwards and to the right, and its words.
DIRECTIONS = {"forward": (1, 0), "back": (-1, 0), "turn": (0, 1)}
ANNOUNCED = {"forward": "FORWARDS", "back": "BACKWARDS", "turn": "A TURN TO THE RIGHT, ON THE SPOT"}


class Deflection(NamedTuple):
    """What the output is to do: the joystick's deflection in percent; not driven: the chair is let go."""

    is_driven: bool
    ahead: float
    right: float


CENTRE = Deflection(False, 0.0, 0.0)


class DrivePhase(Enum):
    """What the guided drive waits for."""

    ASKS = "Enter, to drive"
    STANDS = "the time at the centre before a drive"
    DRIVES = "the end of the drive"
    COUNTS = "what the person measured"
    ENDED = "nothing"


@dataclass(slots=True)
class AxisRows:
    """What is known of one direction.

    Attributes
    ----------
    most : float
        m/s or rad/s that a drive may be expected to reach.
    stood : int
        The largest deflection in percent at which the chair stood.
    rows : list of (int, float)
        Deflection in percent, speed in m/s or rad/s; both ascend.
    """

    most: float
    stood: int = 0
    rows: list[tuple[int, float]] = field(default_factory=list)
    is_finished: bool = False

    def next_percent(self) -> int | None:
        """Return the deflection of the next drive; None: none is needed, or it would be too fast."""
        if self.is_finished:
            return None
        if not self.rows:
            percent = self.stood + FINE
            return percent if percent <= LARGEST_DEAD_BAND else None
        last, speed = self.rows[-1]
        before, slower = self.rows[-2] if len(self.rows) > 1 else (self.stood, 0.0)
        expected = speed + (speed - slower) / (last - before) * COARSE
        return last + COARSE if last + COARSE <= FULL and expected <= self.most else None

    def add(self, percent: int, speed: float) -> str:
        """Add what a drive gave, 0: the chair stood; return why that cannot be, empty when it was added."""
        if speed == 0.0 and not self.rows:
            self.stood = percent
        elif not self.rows or speed > self.rows[-1][1]:
            self.rows.append((percent, speed))
        else:
            last, slower = self.rows[-1]
            return f"That is not faster than the {slower:.3g} with {last} percent. Drive it again, or type {DONE}."
        return ""


class GuidedDrive:
    """A drive after another, each announced, begun by Enter, ended by time, a key, the chair or its stop switch.

    Attributes
    ----------
    phase : DrivePhase
    told : list of str
        Sentences for the person, oldest first; whoever prints them clears the list.
    """

    def __init__(self, most: Twist) -> None:
        """Begin with the first direction; `most` is the fastest that a drive may be expected to be (m/s, rad/s)."""
        self.phase = DrivePhase.ASKS
        self.told: list[str] = []
        self._axes = {axis: AxisRows(most.omega if axis == "turn" else most.v) for axis in DIRECTIONS}
        self._axis, self._percent = "forward", 0
        self._obstacle = ""
        self._has_ended = False
        self._stepped: float | None = None  # s
        self._begun = 0.0  # s
        self._steady: list[tuple[float, float]] = []  # s since the begin of the drive, measured speed
        self._moved_after: float | None = None  # s
        self._lags: list[float] = []  # s
        self._go_on()

    @property
    def is_moving(self) -> bool:
        """Whether the chair moves or is about to: any key ends that."""
        return self.phase in (DrivePhase.STANDS, DrivePhase.DRIVES)

    @property
    def next_drive(self) -> str:
        """The drive that goes on or is next, in words."""
        return f"{ANNOUNCED[self._axis]}, {self._percent} percent"

    @property
    def document(self) -> dict[str, object] | None:
        """The chair document; None while a direction is not measured."""
        axes = self._axes.values()
        if not all(axis.rows and axis.next_percent() is None for axis in axes):
            return None
        tables = {name: [list(row) for row in axis.rows] for name, axis in self._axes.items()}
        # The smallest: with a larger one the chair would be faster than commanded in the other directions.
        document: dict[str, object] = {"version": VERSION, "dead_band": min(axis.stood for axis in axes), **tables}
        if self._lags:
            document["lag"] = round(max(self._lags), 3)
        return document

    def step(self, t: float, readings: ChairReadings, obstacle: str = "") -> Deflection:
        """Advance to `t` (s); return the deflection to command.

        Parameters
        ----------
        t : float
            s, of a clock that is never set back.
        readings : ChairReadings
            What the chair reports.
        obstacle : str
            Why the chair must not be driven now, in a sentence; empty: it may be driven.
        """
        pause = 0.0 if self._stepped is None else t - self._stepped
        self._stepped, self._obstacle = t, obstacle
        if self._has_ended:
            self.phase = DrivePhase.ENDED
        elif self.is_moving:
            if obstacle:
                self._break_off(obstacle)
            elif not 0.0 <= pause <= STALL:
                self._break_off("This computer was held up.")
            elif self.phase is DrivePhase.DRIVES:
                self._watch(t - self._begun, readings)
            elif t - self._begun >= NEUTRAL:
                self.phase, self._begun = DrivePhase.DRIVES, t
        if self.phase is not DrivePhase.DRIVES:
            return CENTRE
        percent = self._percent * min(1.0, max(0.0, (t - self._begun) / RISE))
        ahead, right = DIRECTIONS[self._axis]
        return Deflection(True, ahead * percent, right * percent)

    def hear(self, text: str) -> None:
        """Act on what the person typed: a line, or any key while the chair moves or is about to."""
        line = text.strip().lower()
        if self.phase is DrivePhase.STANDS:
            self._break_off("A key was pressed.")
        elif self.phase is DrivePhase.DRIVES:
            self._finish()
        elif line == QUIT:
            self.end()
        elif self.phase is DrivePhase.ASKS:
            self._begin(line)
        elif self.phase is DrivePhase.COUNTS:
            self._count(line)

    def stop(self) -> None:
        """End the drive, or the wait before it; where the chair stands, nothing is begun and nothing changed."""
        if self.is_moving:
            self._break_off("Stop was pressed on the page.")

    def end(self) -> None:
        """End all; the chair is let go at the next step. A signal handler may call this in the midst of a step."""
        self._has_ended = True
        self.phase = DrivePhase.ENDED

    def _begin(self, line: str) -> None:
        if line == DONE:
            if self._axes[self._axis].rows:
                self._axes[self._axis].is_finished = True
                self._go_on()
            else:
                self.told.append(f"It has not moved {ANNOUNCED[self._axis].lower()} yet: drive, or type {QUIT}.")
        elif line:
            self.told.append(f"Press Enter alone to drive, or type {DONE} or {QUIT}.")
        elif self._obstacle:
            self.told.append(f"It cannot be driven: {self._obstacle}")
        elif self._stepped is not None:
            self.phase, self._begun = DrivePhase.STANDS, self._stepped
            self._steady, self._moved_after = [], None
            self.told.append("It moves in half a second. ANY KEY ENDS IT.")

    def _watch(self, since: float, readings: ChairReadings) -> None:
        """Watch the drive, `since` seconds after its begin."""
        ahead, right = DIRECTIONS[self._axis]
        speed = ahead * readings.v if ahead else -right * readings.omega
        if math.isfinite(speed):
            if speed < -WRONG_WAY and since > RISE:
                self._break_off("It moves the other way: look at the wires, and at the side that is positive.")
                return
            if speed > TOO_FAST * self._axes[self._axis].most:
                self._break_off(f"It is faster than it may be, at {speed:.2f}: type {DONE} or {QUIT}.")
                return
            if speed >= MOVES and self._moved_after is None:
                self._moved_after = since
            if since >= STEADY_AFTER:
                self._steady.append((since, speed))
        if since >= LONGEST:
            self._finish()

    def _break_off(self, why: str) -> None:
        self.phase = DrivePhase.ASKS
        self.told.append(f"ENDED. {why}")
        self._announce()

    def _finish(self) -> None:
        """End the drive, and take what the chair measured, or ask for it."""
        self.phase = DrivePhase.COUNTS
        steady = self._steady
        if steady and steady[-1][0] - steady[0][0] >= LEAST_STEADY:
            mean = sum(speed for _, speed in steady) / len(steady)
            self.told.append(f"It stops. The chair measured {mean:.3f} {'rad/s' if self._axis == 'turn' else 'm/s'}.")
            self._add(mean if mean >= MOVES else 0.0)
            return
        unit, mark = ("degrees", "turn") if self._axis == "turn" else ("metres", "way")
        self.told.append(
            f"It stops. Type the {unit} of {mark} between your two marks, a space, and the seconds between them; "
            f"0 when it did not move; {AGAIN} to drive the same once more."
        )

    def _count(self, line: str) -> None:
        if line == AGAIN:
            self._go_on()
            return
        speed = typed_speed(line, is_turn=self._axis == "turn")
        if speed is None:
            self.told.append("That is no such measurement. Type two numbers, such as 2.5 6.1, or 0, or again.")
        else:
            self._add(speed)

    def _add(self, speed: float) -> None:
        axis = self._axes[self._axis]
        stood = axis.stood
        problem = axis.add(self._percent, speed) if speed <= LARGEST_SPEED[self._axis] else "No chair is that fast."
        if problem:
            self.told.append(problem)
        elif speed and self._moved_after is not None:
            lag = self._moved_after - RISE * stood / self._percent  # since the deflection left the dead band
            self._lags.append(min(LARGEST_LAG, max(0.0, lag)))
        self._go_on()

    def _go_on(self) -> None:
        """Announce the next drive, or end where there is none or a direction cannot be measured."""
        for name, axis in self._axes.items():
            percent = axis.next_percent()
            if percent is not None:
                self._axis, self._percent, self.phase = name, percent, DrivePhase.ASKS
                self._announce()
                return
            if not axis.rows:
                self.told.append(f"With {axis.stood} percent it stands: {ANNOUNCED[name].lower()} cannot be measured.")
                break
        self.end()

    def _announce(self) -> None:
        self.told.append(
            f"NEXT: {self.next_drive}, at most {LONGEST:g} s. Is the floor free? "
            f"Press Enter to drive; {DONE} ends this direction, {QUIT} ends all."
        )


def typed_speed(line: str, *, is_turn: bool) -> float | None:
    """Return the speed (m/s, rad/s) in "METRES SECONDS" or "DEGREES SECONDS", 0 for "0"; None when it is neither."""
    words = line.replace(",", ".").split()
    if words == ["0"]:
        return 0.0
    if len(words) != 2 or not all(map(NUMBER.fullmatch, words)):
        return None
    way, seconds = map(float, words)
    least, most = (SMALLEST_TURN, LARGEST_TURN) if is_turn else (SHORTEST_DISTANCE, LONGEST_DISTANCE)
    if not (least <= way <= most and SHORTEST_TIME <= seconds <= LONGEST):
        return None
    return (math.radians(way) if is_turn else way) / seconds
