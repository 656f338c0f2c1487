"""The whole way from a frame to a tick: decode, controls, shape, gate, chair. The same in the loop and in tests."""

import math
from typing import Protocol

from app.calibration.speeds import Speeds
from app.calibration.vocabulary import DriveParameters
from app.faults import Fault, State
from app.geometry import STANDSTILL, Twist
from app.messages import SensorFrame, Tick
from app.pipeline.controls import Controls
from app.pipeline.decoder import Decoder, periods_between
from app.pipeline.health import LossWindow
from app.pipeline.safety import LARGEST_STEP, LOSSY_LIMIT, Conditions, SafetyGate, shirt_limits
from app.pipeline.shaping import Shaper


class ChairState(Protocol):
    """Where a chair is and what it does, as it tells."""

    x: float
    y: float
    theta: float
    in_contact: bool
    contacts: int


class Chair(Protocol):
    """The one verb that a chair has."""

    def drive(self, twist: Twist, dt: float) -> ChairState:
        """Do `twist` for `dt` (s) and tell where that led."""
        ...


class Chain:
    """One frame in, one tick out. Without parameters it drives nothing and hands the signals through."""

    def __init__(self, sample_rate: float, parameters: DriveParameters | None, chair: Chair) -> None:
        self.parameters = parameters
        self.chair = chair
        self.gate = SafetyGate(parameters.speeds if parameters else Speeds(), sample_rate)
        self._decoder = Decoder(parameters, sample_rate) if parameters else None
        self._controls = Controls(parameters) if parameters else None
        self._shaper = Shaper(parameters) if parameters else None
        self._sample_rate = sample_rate
        self._stale, _ = shirt_limits(sample_rate)
        self._loss = LossWindow()
        self._tick = Tick()
        self.reset()

    def reset(self) -> None:
        """Forget the past, disarm: the next frame begins a new run. A latched fault stays."""
        self.gate.disarm()
        self.gate.last = STANDSTILL
        if self._decoder:
            self._decoder.reset()
        self._loss.reset()
        self._lossy_since: float | None = None
        self._t: float | None = None
        self._frame_t: float | None = None
        self._t_device = math.nan
        self._tick.u1 = self._tick.u2 = 0.0

    def arm(self) -> bool:
        """Begin the neutral check; False when there is nothing to drive with or a fault is latched."""
        return self.parameters is not None and self.gate.arm()

    def step(self, frame: SensorFrame | None, t: float, conditions: Conditions) -> Tick:
        """Return what came of `frame` at `t` (monotonic s); None is a turn without a frame.

        The tick is one object, written anew at each call.
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
        if self._decoder and self._controls and self._shaper:
            twist = self._decide(self._decoder, self._controls, self._shaper, frame, t, pause, dt, conditions)
        else:
            twist = STANDSTILL
        state = self.chair.drive(twist, dt)
        tick.v, tick.omega = twist
        tick.x, tick.y, tick.theta = state.x, state.y, state.theta
        tick.in_contact, tick.contacts = state.in_contact, state.contacts
        tick.state, tick.fault = self.gate.state, self.gate.fault
        return tick

    def _decide(
        self,
        decoder: Decoder,
        controls: Controls,
        shaper: Shaper,
        frame: SensorFrame | None,
        t: float,
        pause: float,
        dt: float,
        conditions: Conditions,
    ) -> Twist:
        tick, gate = self._tick, self.gate
        if frame is not None:
            self._decode(decoder, frame)
        elif self._frame_t is None:
            self._frame_t = t  # from here on the first frame is waited for
        frame_age = t - self._frame_t if self._frame_t is not None else math.inf
        self._follow_losses(t)
        unseen = frame_age > self._stale or self._loss.too_lossy
        if unseen:
            decoder.quieten()
        activation = decoder.activation
        tick.score, tick.rate, tick.drive, tick.activation = decoder.score, decoder.rate, decoder.drive, activation
        tick.u1, tick.u2 = controls.step(activation)
        if controls.is_stop(activation) and gate.state is not State.DISARMED:
            gate.stop(Fault.STOP_GESTURE)
        bad_gestures = sum(decoder.bad[i] for i in controls.bound) if True in decoder.bad else 0
        # What is not seen is not seen at rest.
        neutral = gate.state is State.CHECKING and not unseen and controls.is_neutral(activation)
        permitted = gate.decide(t, pause, neutral, bad_gestures, frame_age, conditions)
        asked = shaper.step(tick.u1, tick.u2, gate.last, dt) if permitted is State.ARMED else STANDSTILL
        return gate.limit(asked, dt)

    def _follow_losses(self, t: float) -> None:
        """Stop when losses go on: with gestures silenced, nobody could slow a chair that cruises."""
        if not self._loss.too_lossy:
            self._lossy_since = None
        elif self._lossy_since is None:
            self._lossy_since = t
        elif t - self._lossy_since > LOSSY_LIMIT and self.gate.state is not State.DISARMED:
            self.gate.stop(Fault.SHIRT_LOSSY)

    def _decode(self, decoder: Decoder, frame: SensorFrame) -> None:
        time_step = frame.t_device - self._t_device
        if not 0.0 < time_step < math.inf:  # the first frame, or a device that was restarted
            time_step = 1.0 / self._sample_rate
        self._t_device = frame.t_device
        self._frame_t = frame.t
        decoder.step(frame.values, time_step)
        self._loss.step(frame.t, int(periods_between(time_step, self._sample_rate)) - 1)
