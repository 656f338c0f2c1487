"""The control loop: one frame in, one tick out, and a tick even when no frame comes."""

import math

from app.clock import Clock
from app.faults import State
from app.geometry import Pose
from app.hardware.base import BodyView, LeaderView, Shirt
from app.hardware.chair.link import ChairLink
from app.hardware.chair.report import ChairReport
from app.messages import NO_CUE, SensorFrame, Tick
from app.pipeline.open_run import OpenRun
from app.pipeline.safety import ChairCondition, Conditions
from app.pipeline.setup import Setup
from app.process.ring import TickRing

LONGEST_WAIT = 0.02  # s without a frame, then a tick is made without one
WAIT_PERIODS = 2.0  # the same for a fast shirt, so that its jitter makes no ticks of its own
CHAIR_WAIT = 0.01  # s between two looks at a real chair, and at what the web process wants of it (LONGEST_WAIT / 2)
BURST = 0.01  # s for which a due command is put off while frames are there already: only the newest matters
ALIVE = 0.5  # s: a shirt that sent nothing for so long is not alive


class ControlLoop:
    """Turns for ever; whoever calls `turn` decides when it ends.

    Attributes
    ----------
    late : int
        Ticks that came more than a period after the deadline.
    last_heartbeat : float
        When the newest heartbeat of the web process came (monotonic s); -inf before the first.
    last_screen_report : float
        When the screen that armed the chair last reported (monotonic s); `conditions.screen` holds the report.
    """

    def __init__(self, setup: Setup, ring: TickRing, report: ChairReport | None, clock: Clock) -> None:
        self.setup = setup
        self.ring = ring
        self.run: OpenRun | None = None
        self.late = 0
        self.last_heartbeat = -math.inf
        self.last_screen_report = -math.inf
        self.conditions = Conditions()
        self._put_off = math.inf  # since when a command waits for newer frames
        self._report = report
        self._clock = clock
        self.new_shirt()

    def new_shirt(self) -> None:
        """Take up the rate of another shirt, of which nothing has come yet."""
        self._period = 1.0 / self.setup.sample_rate
        self._wait = min(LONGEST_WAIT, WAIT_PERIODS * self._period)
        self._frame_t = -math.inf
        self.begin_anew()

    def new_chair(self) -> None:
        """Forget the condition of the chair before."""
        self.conditions.chair, self.conditions.chair_age = ChairCondition.READY, 0.0

    def begin_anew(self) -> None:
        """Set a new deadline: what took long to set up is not called late."""
        self._deadline = self._clock.now() + self._wait

    @property
    def shirt_alive(self) -> bool:
        """Whether the shirt sent a frame just now."""
        return self.setup.shirt is not None and self._clock.now() - self._frame_t < ALIVE

    @property
    def chair_is_told(self) -> bool:
        """Whether nothing is left to be told to a real chair."""
        link = self.setup.link
        return link is None or math.isinf(link.due)

    def turn(self) -> None:
        """Wait for a frame, not beyond the deadline, and make a tick of it or without it.

        Every frame gets its tick, at once when several wait: each moves the chair by its own time. For a real chair
        it also returns earlier, without a tick, when a command is due: the ticks are the same for every chair.
        """
        shirt, link = self.setup.shirt, self.setup.link
        wait = self._wait
        if link is not None:
            now = self._clock.now()
            left = max(0.0, min(self._deadline, link.due) - now)
            wait = left if left <= CHAIR_WAIT else left / 2
        if shirt is not None:
            frame, lost = self._read(shirt, wait)
        else:
            self._clock.sleep_until(self._deadline if link is None else now + wait)
            frame, lost = None, 0
        if link is not None:
            t = self._clock.now()
            link.listen(t)
            if frame is None and t < self._deadline:
                self.tell_chair()
                return
        self._step(frame, lost)

    def _read(self, shirt: Shirt, wait: float) -> tuple[SensorFrame | None, int]:
        """Return the shirt's next frame and how many it has lost; a driver that fails is let go of."""
        try:
            return shirt.read(wait), shirt.lost
        except Exception as error:  # whatever a device does, the loop turns on
            self.setup.release_failed_shirt(error)
            return None, 0

    def tell_chair(self) -> None:
        """Tell a real chair what the gate permits, if it is time to or the gate's state has changed."""
        link, shirt, gate = self.setup.link, self.setup.shirt, self.setup.chain.gate
        if link is None:
            return
        t = self._clock.now()
        if gate.state is State.ARMED and t >= link.due and shirt is not None and shirt.pending():
            self._put_off = min(self._put_off, t)
            if t - self._put_off < BURST:
                return
        self._put_off = math.inf
        link.tell(gate.state, gate.last, self.setup.chain.limits, t)

    def _step(self, frame: SensorFrame | None, lost: int) -> None:
        t = self._clock.now()
        if t > self._deadline + self._period:
            self.late += 1
        self._deadline = t + self._wait
        setup, conditions, run = self.setup, self.conditions, self.run
        link = setup.link
        conditions.supervisor_age = t - self.last_heartbeat
        conditions.screen_age = t - self.last_screen_report
        conditions.recording = link is None if run is None else not run.writer.words
        if link is not None:
            conditions.chair, conditions.chair_age = chair_condition(link), link.age(t)
        tick = setup.chain.step(frame, t, conditions)
        state = setup.chair.state
        tick.driven_v, tick.driven_omega, tick.dial = state.v, state.omega, setup.chain.dial
        if link is not None:
            self.tell_chair()  # before anything else: nothing that only shows may delay a stop
            note_chair(tick, link, t)
        elif self._report is not None:
            self._report.send(tick)
        setup.head.note(tick, t)
        if frame is not None:
            self._frame_t = t
        if run is None:
            run_t, cue = math.nan, NO_CUE
            self.ring.write(tick, 0, run_t, cue, lost, self.late)
        else:
            run_t = t - run.start
            cue = run.cue_at(run_t)
            self.ring.write(tick, run.number, run_t, cue, lost, self.late)
        if setup.simulated_shirt is not None:
            self._show(setup.simulated_shirt.view, tick, cue, run_t)

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
        leader = self.setup.leader
        view.leader = None if leader is None else LeaderView(*leader.at(tick.scene_t))


def chair_condition(link: ChairLink) -> ChairCondition:
    """Return what the gate must know of what a real chair says."""
    if link.telemetry.inhibited:
        return ChairCondition.INHIBITED
    return ChairCondition.READY if link.ready else ChairCondition.WAITING


def note_chair(tick: Tick, link: ChairLink, t: float) -> None:
    """Write into a tick what a real chair says of itself."""
    tick.chair_kind = 1
    tick.chair_age = link.age(t)
    newest = link.telemetry.newest
    if newest is not None:
        tick.chair_state, tick.chair_fault, tick.stop_input = newest.state, newest.fault, newest.stop_input
        tick.battery = newest.battery
