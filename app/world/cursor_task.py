"""The task of the interface test: targets on a cross, which u1 and u2 reach by moving a cursor. Nothing drives.

Lengths are in arms of the cross: the cross reaches from -1 to 1 ahead and to the left. The task is made of the ticks
of a run alone, so that the live picture, the score of a recording and the study compute the same one.
"""

import math
import random
from typing import Annotated, Literal, NamedTuple

from pydantic import Field

from app.quantities import Count, Document, Seconds

LARGEST_STEP = 0.1  # s: a longer pause between two ticks moves the cursor as far as this one
DIRECTIONS = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))  # ahead, back, left, right

Arms = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=1)]
Speed = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=10)]
Phase = Literal["ready", "running", "over"]


class CursorPlan(Document):
    """What is asked in one interface test. Tests are comparable when they differ in their seed only."""

    seed: Count  # of the order of the targets
    ready: Seconds = 3.0  # before the first target
    duration: Annotated[Seconds, Field(ge=1)] = 120.0  # from the first target to the end
    time_limit: Annotated[Seconds, Field(ge=1)] = 15.0  # for one target, after which it counts as missed
    dwell: Annotated[Seconds, Field(ge=0.1)] = 1.0  # for which the cursor stays in a target to acquire it
    speed: Speed = 1.0  # arms/s at u1 or u2 = 1
    width: Arms = 0.2  # diameter of a target
    distances: tuple[Arms, ...] = (0.4, 0.8)  # of the targets from the middle of the cross

    def same_task(self, other: "CursorPlan") -> bool:
        """Return whether two tests ask the same, whatever the order of their targets."""
        return self.model_copy(update={"seed": 0}) == other.model_copy(update={"seed": 0})


class Target(NamedTuple):
    """A target, and the straight way from the middle of the target before it."""

    ahead: float
    left: float
    distance: float  # from the middle of the target before
    direction: tuple[float, float]  # of that way: ahead, left

    def back(self) -> "Target":
        """Return the middle of the cross as the target after this one."""
        ahead, left = self.direction
        return Target(0.0, 0.0, self.distance, (0.0 - ahead, 0.0 - left))


class Attempt(NamedTuple):
    """What happened with one target, from its appearance until it was acquired or missed."""

    target: Target
    start: tuple[float, float]  # of the cursor when the target appeared
    end: tuple[float, float]  # of the cursor when the target was acquired or missed
    acquired: bool
    appeared: float  # s since the start of the run
    first_entry: float | None  # s since the target appeared; None: the cursor was never in it
    last_entry: float | None
    entries: int
    way: float  # driven by the cursor until the last entry; until the end for a target that was never entered
    entry: tuple[float, float]  # of the cursor at the last entry; `end` for a target that was never entered


class OpenAttempt:
    """What has happened so far with the target that is shown."""

    __slots__ = ("appeared", "entered", "entries", "first", "last", "place_in", "start", "target", "way", "way_in")

    def __init__(self, target: Target, start: tuple[float, float], t: float) -> None:
        """Show `target` at `t` (s), with the cursor at `start`."""
        self.target = target
        self.start = self.place_in = start
        self.appeared = t
        self.first: float | None = None  # s since it appeared, of the first entry
        self.last: float | None = None
        self.entered: float | None = None  # s since the start of the run; None: the cursor is outside
        self.entries = 0
        self.way = self.way_in = 0.0  # driven by the cursor: until now, until the last entry

    def enter(self, t: float, place: tuple[float, float]) -> None:
        """Let the cursor enter at `t` (s)."""
        self.entered = t
        self.entries += 1
        self.last = t - self.appeared
        self.first = self.last if self.first is None else self.first
        self.way_in, self.place_in = self.way, place

    def closed(self, end: tuple[float, float], *, acquired: bool) -> Attempt:
        """Return the attempt, which ends with the cursor at `end`."""
        was_inside = self.last is not None
        return Attempt(
            self.target,
            self.start,
            end,
            acquired,
            self.appeared,
            self.first,
            self.last,
            self.entries,
            self.way_in if was_inside else self.way,
            self.place_in if was_inside else end,
        )


class CursorTask:
    """Moves the cursor by the ticks of a run, and follows which targets it acquires.

    Attributes
    ----------
    ahead, left : float
        Position of the cursor, -1 to 1.
    phase : "ready", "running" or "over"
    inside : float
        For how long (s) the cursor has been in the target without leaving it.
    remaining : float
        Time (s) until the first target, then until the end.
    attempts : list of Attempt
    acquired : int
        How many of the attempts acquired their target.
    """

    def __init__(self, plan: CursorPlan) -> None:
        self.plan = plan
        self.ahead = self.left = 0.0
        self.phase: Phase = "ready"
        self.inside = 0.0
        self.remaining = plan.ready
        self.attempts: list[Attempt] = []
        self.acquired = 0
        self._open: OpenAttempt | None = None
        self._random = random.Random(plan.seed)
        self._block: list[Target] = []  # outward targets of the present block that are still to come
        self._t: float | None = None
        self._end = plan.ready + plan.duration
        self._radius_square = plan.width * plan.width / 4.0

    @property
    def target(self) -> Target | None:
        """The target that is shown; None before the first and after the end."""
        return None if self._open is None else self._open.target

    def step(self, run_t: float, u1: float, u2: float) -> None:
        """Take the controls of the tick at `run_t` (s since the start of the run)."""
        if self.phase == "over":
            return
        dt = 0.0 if self._t is None else min(LARGEST_STEP, max(0.0, run_t - self._t))
        self._t = run_t
        if run_t >= self._end:
            self.phase, self._open, self.remaining, self.inside = "over", None, 0.0, 0.0
            return
        if run_t < self.plan.ready:
            self.remaining = self.plan.ready - run_t
            return
        self.remaining = self._end - run_t
        attempt = self._open
        if attempt is None:
            self.phase = "running"
            self._show(self._outward(), run_t)
            return
        ahead = min(1.0, max(-1.0, self.ahead + u1 * self.plan.speed * dt))
        left = min(1.0, max(-1.0, self.left + u2 * self.plan.speed * dt))
        attempt.way += math.hypot(ahead - self.ahead, left - self.left)
        self.ahead, self.left = ahead, left
        self._check_target(attempt, run_t)

    def _check_target(self, attempt: OpenAttempt, t: float) -> None:
        """Follow whether the cursor is in the target, and end the attempt when it is acquired or missed."""
        ahead, left = self.ahead - attempt.target.ahead, self.left - attempt.target.left
        if ahead * ahead + left * left > self._radius_square:
            attempt.entered, self.inside = None, 0.0
        else:
            if attempt.entered is None:
                attempt.enter(t, (self.ahead, self.left))
            self.inside = t - (attempt.entered or t)
            if self.inside >= self.plan.dwell:
                self._close(attempt, t, acquired=True)
                return
        if t - attempt.appeared >= self.plan.time_limit:
            self._close(attempt, t, acquired=False)

    def _close(self, attempt: OpenAttempt, t: float, *, acquired: bool) -> None:
        """Close the attempt and show the next target: the middle after an acquired outward one, else outward."""
        self.attempts.append(attempt.closed((self.ahead, self.left), acquired=acquired))
        self.acquired += acquired
        target = attempt.target
        if not acquired:
            self.ahead = self.left = 0.0  # every way outward begins in the middle
        is_outward = bool(target.ahead or target.left)
        self._show(target.back() if acquired and is_outward else self._outward(), t)

    def _show(self, target: Target, t: float) -> None:
        self._open, self.inside = OpenAttempt(target, (self.ahead, self.left), t), 0.0

    def _outward(self) -> Target:
        """Return the next outward target: in each block one in each direction at each distance, in a random order."""
        if not self._block:
            targets = [
                Target(distance * ahead, distance * left, distance, (ahead, left))
                for ahead, left in DIRECTIONS
                for distance in self.plan.distances
            ]
            self._block = sorted(targets, key=lambda _: self._random.random())
        return self._block.pop()
