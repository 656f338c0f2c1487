"""From a frame to a tick: decode, controls, shape, gate, chair. The loop, replay, the study and tests run this code."""

# Compiled in a wheel (hatch_build.py).

import math
from typing import Final

from app.calibration.vocabulary import DriveParameters
from app.faults import Fault, State
from app.geometry import STANDSTILL, Twist
from app.hardware.base import Chair
from app.messages import SensorFrame, Tick
from app.pipeline.controls import Controls
from app.pipeline.decoder import Decoder, periods_between
from app.pipeline.frame_loss import LossWindow
from app.pipeline.movement_check import MovementCheck
from app.pipeline.safety_gate import (
    ARMED,
    CHECKING,
    LARGEST_STEP,
    LOSSY_LIMIT,
    BadGestures,
    Conditions,
    SafetyGate,
    shirt_limits,
)
from app.pipeline.shaping import Shaper
from app.speed_limits import HIGHEST_SPEEDS, Speeds, apply_dial, most_restrictive

NONE_BAD = BadGestures()
RATE_TOLERANCE: Final = 0.25  # of the rate: with less, a movement is taken for one up to a quarter faster or slower
DEVICE_WINDOW: Final = 0.5  # s by the shirt's own clock
ARRIVAL_WINDOW: Final = 2.0  # s by our clock: frames come in bursts, and later than they were sent


class _Window:
    """Frames counted over one window after the other, by the shirt's own counter: lost frames count as well."""

    __slots__ = ("_begin", "_rate", "_seq", "_size", "differs")

    def __init__(self, rate: float, size: float) -> None:
        self._rate, self._size = rate, size
        self._seq, self._begin = 0, math.nan
        self.differs = False

    def step(self, seq: int, t: float) -> None:
        """Count the frame `seq` of the time `t` (s)."""
        passed = t - self._begin
        if 0.0 <= passed < self._size:
            return
        count = seq - self._seq
        # Otherwise: the first frame, a pause, or the shirt began anew.
        if self._size <= passed < 2.0 * self._size and count > 0:
            self.differs = abs(count / passed - self._rate) > RATE_TOLERANCE * self._rate
        self._seq, self._begin = seq, t


class FrameRate:
    """Compares the rate of the frames with the one that the chain counts on, by the shirt's clock and by ours."""

    def __init__(self, sample_rate: float) -> None:
        self._sample_rate = sample_rate
        self.reset()

    def reset(self) -> None:
        """Begin to count anew."""
        self._device = _Window(self._sample_rate, DEVICE_WINDOW)
        self._arrival = _Window(self._sample_rate, ARRIVAL_WINDOW)
        self.differs = False
        """Whether the last count was another rate."""

    def step(self, seq: int, t_device: float, t: float) -> None:
        """Count a frame with its number, by the shirt's clock and by ours (s)."""
        self._device.step(seq, t_device)
        self._arrival.step(seq, t)
        self.differs = self._device.differs or self._arrival.differs


class Chain:
    """Makes one tick of each frame. Without parameters the chair stands and the tick holds the signals only."""

    def __init__(self, sample_rate: float, parameters: DriveParameters | None, chair: Chair) -> None:
        self.parameters = parameters
        self.chair = chair
        self.clinic = HIGHEST_SPEEDS
        self.dial = 1.0  # the speed dial: share of the speeds to drive at
        self.gate = SafetyGate(self._limits(self.clinic, self.dial), sample_rate)
        self._decoder = Decoder(parameters, sample_rate) if parameters else None
        self._check = MovementCheck(parameters, sample_rate) if parameters else None
        self._controls = Controls(parameters) if parameters else None
        self._shaper = Shaper(parameters) if parameters else None
        if self._shaper:
            self._shaper.restrict(self.limits)
        self._sample_rate = sample_rate
        self._stale, self._silent = shirt_limits(sample_rate)
        self._loss = LossWindow()
        self._frame_rate = FrameRate(sample_rate)
        self._tick = Tick()
        self.reset()

    @property
    def limits(self) -> Speeds:
        """The limits in force: the smallest of parameters, clinic and chair, times the dial."""
        return self.gate.limits

    def set_clinic(self, clinic: Speeds) -> bool:
        """Set the clinic's limits; return False, with nothing changed, when they are higher and the chair may move."""
        if not self._restrict(clinic, self.dial):
            return False
        self.clinic = clinic
        return True

    def set_dial(self, share: float) -> bool:
        """Set the speed dial to `share`; return False, with nothing changed, when that is up and the chair may move."""
        if not self._restrict(self.clinic, share):
            return False
        self.dial = share
        return True

    def _restrict(self, clinic: Speeds, share: float) -> bool:
        limits = self._limits(clinic, share)
        if not self.gate.restrict(limits, self._at_rest):
            return False
        if self._shaper:
            self._shaper.restrict(limits)
        return True

    def _limits(self, clinic: Speeds, share: float) -> Speeds:
        speeds = self.parameters.speeds if self.parameters else Speeds()
        return apply_dial(most_restrictive(speeds, clinic, self.chair.speeds), share)

    def reset(self) -> None:
        """Disarm and reset all state: the next frame begins a new run. A latched fault stays."""
        self.gate.disarm()
        self.gate.stand()
        if self._decoder and self._check and self._shaper:
            self._decoder.reset()
            self._check.reset()
            self._shaper.reset()
        self._at_rest = True  # whether every bound gesture was at rest in the newest tick
        self._makes_stop = False  # whether it has the stop gesture; while a stop is latched, only its beginning counts
        self._loss.reset()
        self._frame_rate.reset()
        self._until_look = 0  # frames until the next look at movement and rate
        self._lossy_since: float | None = None
        self._t: float | None = None
        self._frame_t: float | None = None
        self._t_device = math.nan
        self._tick.u1 = self._tick.u2 = 0.0

    def arm(self) -> bool:
        """Begin the neutral check; return False without parameters or with a latched fault."""
        return self.parameters is not None and self.gate.arm()

    def step(self, frame: SensorFrame | None, t: float, conditions: Conditions) -> Tick:
        """Return the tick made of `frame` at `t` (monotonic s); None is a turn without a frame.

        The tick is one object that each call overwrites.
        """
        tick = self._tick
        pause = 0.0 if self._t is None else t - self._t
        dt = min(LARGEST_STEP, max(0.0, pause))
        self._t = tick.t = t
        if frame is None:
            tick.values = None
            tick.t_device = math.nan
        else:
            tick.values = frame.values
            tick.frame_seq = frame.seq
            tick.t_device = frame.t_device
        if self._decoder and self._check and self._controls and self._shaper:
            twist = self._decide(self._decoder, self._check, self._controls, self._shaper, frame, pause, dt, conditions)
        else:
            twist = STANDSTILL
        state = self.chair.drive(twist, dt, self.gate.state is ARMED)
        tick.v, tick.omega = twist
        tick.x, tick.y, tick.theta = state.x, state.y, state.theta
        tick.in_contact, tick.contacts, tick.scene_t = state.in_contact, state.contacts, state.scene_t
        tick.state, tick.fault, tick.stops = self.gate.state, self.gate.fault, self.gate.stops
        return tick

    def _decide(
        self,
        decoder: Decoder,
        check: MovementCheck,
        controls: Controls,
        shaper: Shaper,
        frame: SensorFrame | None,
        pause: float,
        dt: float,
        conditions: Conditions,
    ) -> Twist:
        tick, gate = self._tick, self.gate
        t = tick.t
        if frame is not None:
            self._decode(decoder, check, frame)
        elif self._frame_t is None:
            self._frame_t = t  # the age of the missing first frame counts from here
        frame_age = t - self._frame_t if self._frame_t is not None else math.inf
        self._follow_losses(t, controls)
        unseen = frame_age > self._stale or self._loss.too_lossy
        if unseen:
            decoder.quieten()
        activation = decoder.activation
        tick.score, tick.rate, tick.drive, tick.activation = decoder.score, decoder.rate, decoder.drive, activation
        tick.estimated = decoder.estimated
        if decoder.is_active:
            tick.u1, tick.u2 = controls.step(activation)
            makes_stop = controls.is_stop(activation)
            if makes_stop and gate.state is not State.DISARMED and not (self._makes_stop and gate.state is State.FAULT):
                gate.stop(Fault.STOP_GESTURE)
            self._makes_stop = makes_stop
            self._at_rest = not unseen and controls.is_neutral(activation)
        else:
            tick.u1 = tick.u2 = 0.0
            self._at_rest = not unseen  # unseen is not at rest
        is_good = not check.doubts and decoder.bad is decoder.none_bad and controls.brakes.are_complete
        bad = NONE_BAD if is_good else self._bad(decoder, check, controls)
        permitted = gate.decide(t, pause, self._at_rest, bad, frame_age, conditions)
        if permitted is not ARMED:
            shaper.reset()
            return gate.limit(STANDSTILL, dt)
        return gate.limit(shaper.step(tick.u1, tick.u2, gate.last, gate.rates, dt), dt)

    def _bad(self, decoder: Decoder, check: MovementCheck, controls: Controls) -> BadGestures:
        bad_count = sum(decoder.bad[i] for i in controls.bound)
        brakes_lost = not controls.brakes.suffice(self.gate.last, decoder.bad)
        return BadGestures(bad_count, brakes_lost, check.doubts, check.disbelieves)

    def _follow_losses(self, t: float, controls: Controls) -> None:
        """Stop when frames go on being lost: gestures count as neutral then, so a gesture cannot brake.

        A chair that keeps its speed is stopped as soon as a silent shirt would stop it.
        """
        if not self._loss.too_lossy:
            self._lossy_since = None
        elif self._lossy_since is None:
            self._lossy_since = t
        elif self._may_move:
            limit = self._silent if controls.brakes.are_needed(self.gate.last) else LOSSY_LIMIT
            if t - self._lossy_since > limit:
                self.gate.stop(Fault.SHIRT_LOSSY)

    @property
    def _may_move(self) -> bool:
        """Whether the gate permits motion, or is about to."""
        return self.gate.state is CHECKING or self.gate.state is ARMED

    def _decode(self, decoder: Decoder, check: MovementCheck, frame: SensorFrame) -> None:
        time_step = frame.t_device - self._t_device
        if not 0.0 < time_step < math.inf:  # the first frame, or the device was restarted
            time_step = 1.0 / self._sample_rate
        self._t_device = frame.t_device
        self._frame_t = frame.t
        periods = periods_between(time_step, self._sample_rate)
        decoder.step(frame.values, periods)
        self._loss.step(frame.t, int(periods) - 1)
        self._until_look -= 1
        if self._until_look <= 0 or periods > 1.0:
            self._until_look = check.every
            check.look(frame.values, decoder.bad, decoder.estimated, decoder.rate, decoder.is_active, periods)
            self._frame_rate.step(frame.seq, frame.t_device, frame.t)
            if self._frame_rate.differs and self._may_move:
                self.gate.stop(Fault.SHIRT_RATE)
