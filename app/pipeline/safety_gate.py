"""The gate: the last step that decides whether and how fast the chair moves. No clock, no socket, no file.

Every command to a chair passes it, the virtual chair included (safety.md). It denies by default: it starts disarmed,
and every doubt ends in a ramp to standstill that no earlier step of the chain can lengthen.
"""

# Compiled in a wheel (hatch_build.py).

import math
from dataclasses import dataclass
from enum import IntEnum
from typing import Final, NamedTuple

from app.faults import Fault, State
from app.geometry import STANDSTILL, Twist
from app.pipeline.shaping import forward_ramp, turn_ramp
from app.pipeline.stop_ramp import STOP_DECELERATION, STOP_TURN_DECELERATION, stop_rate, towards_zero
from app.speed_limits import Speeds

NEUTRAL_TIME: Final = 0.5  # s at rest before motion (ISO 7176-14, control signal at switch-on)
NEUTRAL_PATIENCE: Final = 5.0  # s of the neutral check after which a fault is latched
SHIRT_STALE: Final = 0.05  # s without a frame after which gestures count as neutral
SHIRT_SILENT: Final = 0.2  # s without a frame after which the chair is disarmed (as after a 200 ms stall in ArduPilot)
LOSSY_LIMIT: Final = 1.5  # s of too many lost frames: one burst leaves the window after 1 s; cruising stops sooner
SLOW_SHIRT: Final = 60.0  # Hz: below this rate the two limits above are counted in periods
STALE_PERIODS: Final = 3
SILENT_PERIODS: Final = 12
WEB_SILENT: Final = 0.3  # s without a heartbeat of the web process
SCREEN_SILENT: Final = 0.3  # s without a report of the screen that armed the chair
CHAIR_SILENT: Final = 0.3  # s without telemetry, which comes every 0.1 s
LOOP_STALL: Final = 0.3  # s between two ticks, as for a missing heartbeat
BAD_GESTURES: Final = 2  # number of gestures with bad channels that ends the drive
LARGEST_STEP: Final = 0.1  # s: a longer pause between two ticks counts as this long for motion and ramps


class ChairCondition(IntEnum):
    """Whether a chair can be driven, by its telemetry; the virtual chair is always ready."""

    READY = 0  # it has accepted the current arming, and obeys commands to move
    WAITING = 1  # disarmed, or still checking that it is commanded to stand
    INHIBITED = 2  # its stop switch is pressed, or it has a fault


# Members of enumerations that each tick looks up: a look-up by the name of its class costs 0.1 us.
ARMED: Final = State.ARMED
CHECKING: Final = State.CHECKING
NO_FAULT: Final = Fault.NONE
READY: Final = ChairCondition.READY
INHIBITED: Final = ChairCondition.INHIBITED


@dataclass(slots=True)
class Conditions:
    """The conditions outside the chain that the gate checks."""

    supervisor_age: float = 0.0  # s since the last heartbeat of the web process
    screen_age: float = 0.0  # s since the last report of the screen that armed the chair; inf: it is gone
    screen: Fault = NO_FAULT  # why the screen's report does not count: it is hidden, or its page is frozen
    recording: bool = True  # whether the recording, where one is required, is being written
    chair_age: float = 0.0  # s since the chair's newest telemetry
    chair: ChairCondition = READY


class BadGestures(NamedTuple):
    """Bound gestures that read bad channels, and signals that no movement makes."""

    bound: int = 0  # how many
    brakes: bool = False  # whether the other gestures cannot stop the motion (app/pipeline/person_brakes.py)
    doubts: bool = False  # whether something within the last 2 s was no movement (app/pipeline/movement_check.py)
    disbelieves: bool = False  # whether it would have driven


def shirt_limits(sample_rate: float) -> tuple[float, float]:
    """Return after how many seconds without a frame gestures count as neutral, and the chair is disarmed (S4)."""
    if sample_rate >= SLOW_SHIRT:
        return SHIRT_STALE, SHIRT_SILENT
    return STALE_PERIODS / sample_rate, SILENT_PERIODS / sample_rate


class SafetyGate:
    """Permits or withdraws motion, and limits the twist."""

    def __init__(self, speeds: Speeds, sample_rate: float) -> None:
        self._limits = speeds
        self._forward, self._turn = forward_ramp(speeds), turn_ramp(speeds)
        _, self._shirt_silent = shirt_limits(sample_rate)
        self.state = State.DISARMED
        self.fault = NO_FAULT
        self.stops = 0
        self.stand()
        self._checking_since: float | None = None
        self._neutral_since: float | None = None

    def stand(self) -> None:
        """Assume that the chair stands, as at the start of a run."""
        self.last = STANDSTILL
        self.rates = STANDSTILL
        self._stop_rate = self._stop_turn_rate = 0.0

    @property
    def limits(self) -> Speeds:
        """The limits in force."""
        return self._limits

    def restrict(self, speeds: Speeds, neutral: bool) -> bool:
        """Set other limits: lower limits at once; a higher limit only at standstill and with every gesture at rest.

        Return whether the limits were set; when not, nothing has changed.
        """
        raises = any(getattr(speeds, name) > getattr(self._limits, name) for name in Speeds.model_fields)
        if raises and not (neutral and self.last == STANDSTILL):
            return False
        self._limits = speeds
        self._forward, self._turn = forward_ramp(speeds), turn_ramp(speeds)
        return True

    def arm(self) -> bool:
        """Begin the neutral check; return False, and change nothing, when a fault is latched."""
        if self.state is State.FAULT:
            return False
        if self.state is State.DISARMED:
            self.state = CHECKING
            self._checking_since = self._neutral_since = None
        return True

    def disarm(self) -> None:
        """Withdraw motion; a latched fault stays."""
        if self.state is not State.FAULT:
            self._withdraw(State.DISARMED)

    def stop(self, fault: Fault) -> None:
        """Latch a stop, at any time and any number of times; each stop is counted, the first reason stays."""
        self.stops += 1
        if self.state is not State.FAULT:
            self.fault = fault
            self._withdraw(State.FAULT)

    def clear(self, stops: int) -> bool:
        """Clear a latched fault: the gate is disarmed, the chair stands.

        `stops` is the count of stops that the person who clears has seen; after a further stop nothing is cleared.
        """
        if self.state is not State.FAULT or stops != self.stops:
            return False
        self.state = State.DISARMED
        self.fault = NO_FAULT
        return True

    def decide(
        self, t: float, pause: float, neutral: bool, bad: BadGestures, frame_age: float, conditions: Conditions
    ) -> State:
        """Return whether motion is permitted at `t` (s), `pause` (s) after the tick before.

        `neutral`: every bound gesture is inside its dead-zone. `bad`: the bound gestures that read bad channels.
        `frame_age`: s since the shirt's newest frame.
        """
        if self.state is CHECKING or self.state is ARMED:
            fault = self._fault_now(pause, bad, frame_age, conditions)
            if fault is not NO_FAULT:
                self.stop(fault)
            elif self.state is CHECKING:
                self._check_neutral(t, neutral and not bad.bound and not bad.doubts, bad, conditions.chair)
        return self.state

    def limit(self, asked: Twist, dt: float) -> Twist:
        """Return the twist that may be sent, `dt` (s) after the last; without permission, the ramp to standstill."""
        if self.state is ARMED and not (math.isfinite(asked.v) and math.isfinite(asked.omega)):
            self.stop(Fault.BAD_NUMBER)
        last = self.last
        if self.state is ARMED:
            v = self._forward.bounded(last.v, self.rates.v, asked.v, dt)
            omega = self._turn.bounded(last.omega, self.rates.omega, asked.omega, dt)
            if dt > 0.0:
                self.rates = Twist((v - last.v) / dt, (omega - last.omega) / dt)
            self.last = Twist(v, omega)
        elif last is not STANDSTILL:
            v = towards_zero(last.v, self._stop_rate * dt)
            omega = towards_zero(last.omega, self._stop_turn_rate * dt)
            self.last = Twist(v, omega) if v or omega else STANDSTILL
        return self.last

    def _withdraw(self, state: State) -> None:
        if self.state is ARMED:  # a stop during a stop must not lengthen it
            self._stop_rate = stop_rate(self.last.v, STOP_DECELERATION)
            self._stop_turn_rate = stop_rate(self.last.omega, STOP_TURN_DECELERATION)
            self.rates = STANDSTILL
        self.state = state

    def _fault_now(self, pause: float, bad: BadGestures, frame_age: float, conditions: Conditions) -> Fault:
        # Every comparison is written so that a NaN leads to the fault.
        if not pause <= LOOP_STALL:
            return Fault.LOOP_LATE
        if not conditions.supervisor_age <= WEB_SILENT:
            return Fault.WEB_SILENT
        if not conditions.screen_age <= SCREEN_SILENT:
            return Fault.SCREEN_LOST
        if conditions.screen is not NO_FAULT:
            return conditions.screen
        if not conditions.chair_age <= CHAIR_SILENT:
            return Fault.CHAIR_SILENT
        if conditions.chair is INHIBITED:
            return Fault.STOP_CHAIR
        if self.state is ARMED and conditions.chair is not READY:
            return Fault.CHAIR_DISARMED
        if not conditions.recording:
            return Fault.RECORDING_LOST
        if not frame_age <= self._shirt_silent:
            return Fault.SHIRT_SILENT
        if bad.bound >= BAD_GESTURES:
            return Fault.CHANNELS_BAD
        if bad.disbelieves and self.state is ARMED:
            return Fault.NO_MOVEMENT
        return Fault.BRAKE_BAD if bad.brakes else NO_FAULT

    def _check_neutral(self, t: float, neutral: bool, bad: BadGestures, chair: ChairCondition) -> None:
        if self._checking_since is None:
            self._checking_since = t
        if not neutral:
            self._neutral_since = None
        elif self._neutral_since is None:
            self._neutral_since = t
        if self._neutral_since is not None and t - self._neutral_since >= NEUTRAL_TIME:
            if chair is READY:
                self.state = ARMED
            elif t - self._checking_since > NEUTRAL_PATIENCE:
                self.stop(Fault.CHAIR_NOT_READY)
        elif t - self._checking_since > NEUTRAL_PATIENCE:
            if bad.bound:
                self.stop(Fault.CHANNELS_BAD)
            else:
                self.stop(Fault.NO_MOVEMENT if bad.doubts else Fault.NOT_NEUTRAL)
