"""The control loop: one frame in, one tick out, and a tick even when no frame comes."""

import math

from app.clock import Clock
from app.faults import State
from app.geometry import Pose
from app.hardware.base import BodyView
from app.hardware.chair.report import ChairReport
from app.messages import NO_CUE, SensorFrame, Tick
from app.pipeline.open_run import OpenRun
from app.pipeline.safety import Conditions
from app.pipeline.setup import Setup
from app.ring import TickRing

LONGEST_WAIT = 0.02  # s without a frame, then a tick is made without one
WAIT_PERIODS = 2.0  # the same for a fast shirt, so that its jitter makes no ticks of its own
ALIVE = 0.5  # s: a shirt that sent nothing for so long is not alive


class ControlLoop:
    """Turns for ever; whoever calls `turn` decides when it ends.

    Attributes
    ----------
    late : int
        Ticks that came more than a period after the deadline.
    heard : float
        When the web process was heard last (monotonic s); never, at first.
    screen_seen : float
        When the screen that armed the chair last said that it is in view (monotonic s).
    """

    def __init__(self, setup: Setup, ring: TickRing, report: ChairReport | None, clock: Clock) -> None:
        self.setup = setup
        self.ring = ring
        self.run: OpenRun | None = None
        self.late = 0
        self.heard = -math.inf
        self.screen_seen = -math.inf
        self.conditions = Conditions()
        self._report = report
        self._clock = clock
        self.new_shirt()

    def new_shirt(self) -> None:
        """Take up the rate of another shirt, of which nothing has come yet."""
        self._period = 1.0 / self.setup.sample_rate
        self._wait = min(LONGEST_WAIT, WAIT_PERIODS * self._period)
        self._frame_t = -math.inf
        self.begin_anew()

    def begin_anew(self) -> None:
        """Set a new deadline: what took long to set up is not called late."""
        self._deadline = self._clock.now() + self._wait

    @property
    def shirt_alive(self) -> bool:
        """Whether the shirt sent a frame just now."""
        return self.setup.shirt is not None and self._clock.now() - self._frame_t < ALIVE

    def turn(self) -> None:
        """Wait for a frame, not beyond the deadline, and make a tick of it or without it.

        Every frame gets its tick, at once when several wait: each moves the chair by its own time.
        """
        shirt = self.setup.shirt
        if shirt is None:
            self._clock.sleep_until(self._deadline)
            self._step(None, 0)
        else:
            self._step(shirt.read(self._wait), shirt.lost)

    def _step(self, frame: SensorFrame | None, lost: int) -> None:
        t = self._clock.now()
        if t > self._deadline + self._period:
            self.late += 1
        self._deadline = t + self._wait
        conditions, run = self.conditions, self.run
        conditions.supervisor_age = t - self.heard
        conditions.screen_age = t - self.screen_seen
        conditions.recording = run is None or not run.writer.words
        tick = self.setup.chain.step(frame, t, conditions)
        if self._report is not None:
            self._report.send(tick)
        if frame is not None:
            self._frame_t = t
        if run is None:
            run_t, cue = math.nan, NO_CUE
            self.ring.write(tick, 0, run_t, cue, lost, self.late)
        else:
            run_t = t - run.start
            cue = run.cue_at(run_t)
            self.ring.write(tick, run.number, run_t, cue, lost, self.late)
        if self.setup.dressed is not None:
            self._show(self.setup.dressed.view, tick, cue, run_t)

    def _show(self, view: BodyView, tick: Tick, cue: int, run_t: float) -> None:
        """Let the body in the simulated shirt see what its wearer would see."""
        run = self.run
        if run is None or cue == NO_CUE:
            view.cue, view.cue_elapsed = None, 0.0
        else:
            view.cue = run.cues[cue]
            view.cue_elapsed = run_t - view.cue.start
        view.driving = tick.state is State.ARMED and run is not None and run.kind == "drive"
        view.pose = Pose(tick.x, tick.y, tick.theta)
        chair = self.setup.chair.state
        view.v, view.omega = chair.v, chair.omega
        view.in_contact = tick.in_contact
