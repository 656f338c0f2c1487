"""The decisions of a chair's receiver: from datagrams and time to the speed at which the chair is driven.

No clock, no socket, no file; standard library only. docs/protocols.md, section 9, describes its behaviour. A datagram
with any error changes nothing.
"""

import math
import secrets
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.key import Key
from app.hardware.chair.packet import (
    DRIVE,
    NONCE_BYTES,
    STOP,
    VIRTUAL,
    ChairCommand,
    Telemetry,
    decode_command,
    encode_telemetry,
)
from app.hardware.chair.readings import NO_READINGS, NO_TABLE, ChairReadings, TableReport
from app.hardware.chair.reasons import Reason
from app.speed_ceiling import HIGHEST_SPEED, HIGHEST_TURN_RATE

NEUTRAL_TIME = 0.5  # s of zero commands before motion, as in the gate (S2)
NEUTRAL_PATIENCE = 5.0  # s of the neutral check after which the chair is disarmed
QUIET = 0.1  # s without a newer command after which the chair slows to standstill (S3)
SILENT = 0.3  # s without a newer command after which the chair is disarmed
ROUNDING = 1e-6  # s added to a limit, so that it has passed whatever the rounding
LATE = 0.1  # s of delay beyond that of the quickest command; a later command does not count as newer
FORGIVEN = 0.1  # s per s by which the smallest delay is raised, because clocks drift
STALL = 0.1  # s between two steps after which the last command is too old
ACCELERATION, TURN_ACCELERATION = (
    3.0,
    20.0,
)  # m/s2, rad/s2: the chair's own ramps, steeper than those of any parameter set
STOP_DECELERATION, STOP_TURN_DECELERATION, STOP_TIME = 3.0, 6.0, 0.25  # as in the gate: m/s2, rad/s2, s


class ReceiverState(IntEnum):
    """The state of the telemetry."""

    DISARMED = 0
    CHECKING = 1  # an epoch was accepted; the time of commands to stand is counted
    ARMED = 2
    FAULT = 3  # while a condition forbids motion


@dataclass(slots=True)
class _SpeedRamp:
    """The ramp of one speed to its target."""

    cap: float
    acceleration: float
    deceleration: float  # of a stop
    driven: float = 0.0
    target: float = 0.0
    stop_rate: float = 0.0

    def stop(self) -> None:
        """Slow to standstill; a stop during a stop does not lengthen it."""
        self.target = 0.0
        self.stop_rate = max(self.stop_rate, self.deceleration, abs(self.driven) / STOP_TIME)

    def step(self, dt: float) -> None:
        """Advance by `dt` (s)."""
        change = (self.stop_rate or self.acceleration) * dt
        self.driven = min(self.driven + change, max(self.driven - change, self.target))


class Receiver:
    """One chair with its key and its speed limits.

    Attributes
    ----------
    state : ReceiverState
    reason : Reason
        Why the chair stands; NONE while it is armed.
    nonce : bytes
        The nonce that the tag of a command must cover; new after every epoch.
    """

    def __init__(
        self,
        key: Key,
        v_max: float = HIGHEST_SPEED,
        omega_max: float = HIGHEST_TURN_RATE,
        *,
        refuses_virtual: bool = False,
        table: TableReport = NO_TABLE,
        new_nonce: Callable[[int], bytes] = secrets.token_bytes,
    ) -> None:
        self._key = key
        self._refuses_virtual, self._table = refuses_virtual, table
        self._new_nonce = new_nonce
        self._v = _SpeedRamp(v_max, ACCELERATION, STOP_DECELERATION)
        self._omega = _SpeedRamp(omega_max, TURN_ACCELERATION, STOP_TURN_DECELERATION)
        self.state = ReceiverState.DISARMED
        self.reason = Reason.NONE
        self.nonce = new_nonce(NONCE_BYTES)
        self._epoch: int | None = None  # the last accepted epoch
        self._sequence = 0
        self._digest = b""
        self._was_permitted = False  # whether the drive flag was set in this epoch
        self._command_t = self._checking_since = self._neutral_since = -math.inf
        self._sender_t = 0.0
        self._quickest = math.inf  # s, smallest difference between this clock and the sender's in this epoch
        self._stepped: float | None = None

    @property
    def driven(self) -> Twist:
        """The speeds at which the chair is driven now."""
        return Twist(self._v.driven, self._omega.driven)

    def next_look(self, t: float) -> float:
        """Return when, after `t` (s), a limit of silence is reached; inf when none applies."""
        if self.state not in (ReceiverState.CHECKING, ReceiverState.ARMED):
            return math.inf
        deadlines = (self._command_t + limit + ROUNDING for limit in (QUIET, SILENT))
        return next((deadline for deadline in deadlines if deadline > t), math.inf)

    def accept(self, datagram: bytes, t: float) -> bool:
        """Act on a command that came at `t` (s); return False, with nothing changed, when it is not accepted."""
        command = decode_command(datagram, self._key, self.nonce)
        if command is None or not _is_drivable(command) or (self._refuses_virtual and command.flags & VIRTUAL):
            return False
        if self.state is ReceiverState.DISARMED:
            if not self._opens_epoch(command):
                return False
            self._begin_epoch(command, t)
        elif self.state is ReceiverState.FAULT or not self._is_newer(command, t):
            return False
        self._judge_lateness(command, t)
        if t - self._command_t >= QUIET:
            self._neutral_since = t
        self._sequence, self._command_t = command.sequence, t
        self._obey(command, t)
        return True

    def step(self, t: float, obstacle: Reason = Reason.NONE) -> Twist:
        """Advance to `t` (s); return the speeds to drive. An `obstacle` stops, and forbids motion while it lasts."""
        pause = 0.0 if self._stepped is None else t - self._stepped
        self._stepped = t
        self._watch(t, pause, obstacle)
        dt = min(max(pause, 0.0), STALL)
        self._v.step(dt)
        self._omega.step(dt)
        return self.driven if self._v.driven or self._omega.driven else STANDSTILL

    def stop(self, reason: Reason) -> None:
        """Disarm: slow to standstill, end the epoch, make a new nonce."""
        self._v.stop()
        self._omega.stop()
        self.reason = reason
        if self.state in (ReceiverState.CHECKING, ReceiverState.ARMED):
            self.state = ReceiverState.DISARMED
            self.nonce = self._new_nonce(NONCE_BYTES)

    def telemetry(self, t: float, readings: ChairReadings = NO_READINGS, *, stop_pressed: bool = False) -> bytes:
        """Return the datagram of the telemetry at `t` (s), with what the chair reports of itself."""
        return encode_telemetry(
            Telemetry(
                state=self.state,
                key_id=self._key.id,
                epoch=self._epoch or 0,
                sequence=self._sequence,
                t_ns=int(t * 1e9),
                nonce=self.nonce,
                v=self._v.driven,
                omega=self._omega.driven,
                battery=readings.battery,
                stop_input=int(stop_pressed),
                fault=self.reason,
                own_joystick=int(readings.own_joystick),
                crawls=int(self._table.is_crawling),
                measured_v=readings.v,
                measured_omega=readings.omega,
                document=self._table.digest,
            ),
            self._key,
        )

    def _opens_epoch(self, command: ChairCommand) -> bool:
        stands = command.v == 0.0 and command.omega == 0.0 and not command.flags & STOP
        return stands and command.epoch != self._epoch

    def _begin_epoch(self, command: ChairCommand, t: float) -> None:
        self.state = ReceiverState.CHECKING
        self._epoch, self._digest = command.epoch, command.digest
        self._was_permitted = False
        self._checking_since = self._neutral_since = t
        self._quickest = math.inf

    def _is_newer(self, command: ChairCommand, t: float) -> bool:
        if command.epoch != self._epoch or command.sequence <= self._sequence:
            return False
        if command.flags & STOP:  # a stop is never too late, and needs no digest
            return True
        if command.digest != self._digest:
            return False
        sender_t = command.t_ns * 1e-9
        if sender_t == self._sender_t:  # a clock that stands does not show lateness
            return True
        allowed = self._quickest + FORGIVEN * (t - self._command_t) + LATE
        return t - sender_t <= allowed

    def _judge_lateness(self, command: ChairCommand, t: float) -> None:
        sender_t = command.t_ns * 1e-9
        if sender_t != self._sender_t or math.isinf(self._quickest):
            leaked = self._quickest + FORGIVEN * max(0.0, t - self._command_t)
            self._quickest = min(leaked, t - sender_t)
        self._sender_t = sender_t

    def _obey(self, command: ChairCommand, t: float) -> None:
        if command.flags & STOP:
            self.stop(Reason.STOP_COMMAND)
            return
        if self._was_permitted and not command.flags & DRIVE:
            self.stop(Reason.WITHDRAWN)
            return
        self._was_permitted = bool(command.flags & DRIVE)
        if self.state is ReceiverState.CHECKING:
            if command.v or command.omega:
                self._neutral_since = t
            elif t - self._neutral_since >= NEUTRAL_TIME:
                self.state, self.reason = ReceiverState.ARMED, Reason.NONE
        elif self._was_permitted:
            self._drive(self._v, command.v, command.v_cap)
            self._drive(self._omega, command.omega, command.omega_cap)

    def _drive(self, axis: _SpeedRamp, wanted: float, promised: float) -> None:
        cap = min(axis.cap, promised)
        axis.stop_rate = 0.0
        axis.target = min(cap, max(-cap, wanted))

    def _watch(self, t: float, pause: float, obstacle: Reason) -> None:
        if obstacle is not Reason.NONE:
            self.stop(obstacle)
            self.state = ReceiverState.FAULT
        elif self.state is ReceiverState.FAULT:
            self.state = ReceiverState.DISARMED
        if self.state not in (ReceiverState.CHECKING, ReceiverState.ARMED):
            return
        silence = t - self._command_t
        if not pause <= STALL:
            self.stop(Reason.LATE)
        elif not silence < SILENT:
            self.stop(Reason.SILENT)
        elif not silence < QUIET:
            self._v.stop()
            self._omega.stop()
        elif self.state is ReceiverState.CHECKING and t - self._checking_since > NEUTRAL_PATIENCE:
            self.stop(Reason.NOT_NEUTRAL)


def _is_drivable(command: ChairCommand) -> bool:
    numbers = (command.v, command.omega, command.v_cap, command.omega_cap)
    return all(map(math.isfinite, numbers)) and command.v_cap >= 0.0 and command.omega_cap >= 0.0
