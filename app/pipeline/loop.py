"""The control loop: one frame in, one tick out, and a tick even when no frame comes."""

import math

from app.clock import Clock
from app.faults import Fault, State
from app.geometry import Pose
from app.hardware.base import BodyView, LeaderView, LinkedChair, Shirt
from app.hardware.body.cursor_view import CursorView
from app.hardware.chair.report import ChairReport
from app.messages import ALIVE, IDLE_RATE, NO_CUE, SensorFrame, Tick
from app.pipeline.open_run import OpenRun
from app.pipeline.safety_gate import SCREEN_SILENT, WEB_SILENT, ChairCondition, Conditions, SafetyGate
from app.pipeline.setup import Setup
from app.process.ring import TickRing

LONGEST_WAIT = 1.0 / IDLE_RATE  # s without a frame after which a tick is made without one
WAIT_PERIODS = 2.0  # of a fast shirt's frames without a frame after which a tick is made: its jitter adds no ticks
BURST = 0.01  # s for which a due command is delayed while more frames wait: only the newest frame counts
PUNCTUAL = 1.0  # s of reports in time after which a pause ends


class ScreenPause:
    """Pauses an armed drive of the virtual chair while the screen that drives it does not report in time (S7).

    A slow picture pauses the virtual chair in place of stopping it, because nobody sits in it: nobody has to take a
    stop back. The pause does not apply to a real chair, and clears no fault. It disarms the gate, and arms it again,
    which begins a neutral check.

    Attributes
    ----------
    reason : Fault
        Why the drive is paused; NONE while it is not.
    """

    def __init__(self) -> None:
        self.reason = Fault.NONE
        self._punctual_since = math.inf

    def end(self) -> None:
        """Forget the pause: a person has ended, stopped or disarmed the drive, or a real chair is driven."""
        self.reason = Fault.NONE

    def decide(self, t: float, gate: SafetyGate, conditions: Conditions) -> bool:
        """Pause the drive at `t` (s) when the screen is late; return whether it is to be armed again.

        The screen's part of `conditions` is replaced by a good one: what the pause has answered is no fault any more.
        """
        late = _late(conditions)
        web_age, conditions.screen_age, conditions.screen = conditions.supervisor_age, 0.0, Fault.NONE
        if gate.state is State.CHECKING or gate.state is State.ARMED:
            self.reason = late
            if late is not Fault.NONE:
                gate.disarm()
                self._punctual_since = math.inf
            return False
        if self.reason is Fault.NONE or gate.state is State.FAULT:
            self.reason = Fault.NONE
            return False
        if not web_age <= WEB_SILENT:
            gate.stop(Fault.WEB_SILENT)  # the gate itself looks only while motion is permitted
            self.reason = Fault.NONE
            return False
        if late is not Fault.NONE:
            self.reason, self._punctual_since = late, math.inf
            return False
        self._punctual_since = min(self._punctual_since, t)
        if t - self._punctual_since < PUNCTUAL:
            return False
        self.reason = Fault.NONE
        return True


def _late(conditions: Conditions) -> Fault:
    """Return what is wrong with the screen, as the gate says it; NONE when it reports in time."""
    # The comparison is written so that a NaN leads to the fault.
    return conditions.screen if conditions.screen_age <= SCREEN_SILENT else Fault.SCREEN_LOST


class ControlLoop:
    """Makes one tick at each `turn`; the caller decides when to end.

    Attributes
    ----------
    late : int
        Ticks that came more than a period after the deadline.
    last_heartbeat : float
        When the newest heartbeat of the web process came (monotonic s); -inf before the first.
    last_screen_report : float
        When the screen that armed the chair last reported (monotonic s).
    screen : Fault
        What is wrong with it by that report.
    """

    def __init__(self, setup: Setup, ring: TickRing, report: ChairReport | None, clock: Clock) -> None:
        self.setup = setup
        self.ring = ring
        self.run: OpenRun | None = None
        self.late = 0
        self.last_heartbeat = -math.inf
        self.last_screen_report = -math.inf
        self.screen = Fault.NONE
        self.pause = ScreenPause()
        self.conditions = Conditions()
        self._delayed_since = math.inf  # since when a due command waits for newer frames (monotonic s)
        self._report = report
        self._clock = clock
        self.new_shirt()

    def new_shirt(self) -> None:
        """Take the rate of another shirt, from which no frame has come yet."""
        self._period = 1.0 / self.setup.sample_rate
        self._wait = min(LONGEST_WAIT, WAIT_PERIODS * self._period)
        self._frame_t = -math.inf
        self._shirt_since = self._clock.now()
        self.begin_anew()

    def begin_anew(self) -> None:
        """Set a new deadline, so that a tick after a long change of the setup does not count as late."""
        self._deadline = self._clock.now() + self._wait

    @property
    def shirt_alive(self) -> bool:
        """Whether the shirt has sent a frame within the last `ALIVE` seconds."""
        return self.setup.shirt is not None and self._clock.now() - self._frame_t < ALIVE

    @property
    def shirt_silent(self) -> bool:
        """Whether no frame has come for `ALIVE` seconds; a shirt that was just opened has that long for its first."""
        return self._clock.now() - max(self._frame_t, self._shirt_since) >= ALIVE

    @property
    def all_commands_sent(self) -> bool:
        """Whether no command is left to be sent to the chair."""
        return self.setup.link is None or math.isinf(self.setup.link.due)

    def turn(self) -> None:
        """Wait for a frame until the deadline, and make a tick with the frame or without one.

        Every frame gets its own tick, without a wait when several frames are there: each moves the chair by its own
        time. When a real chair wants to be served sooner, `turn` serves it and returns without a tick, so that ticks
        do not depend on the chair.
        """
        shirt, link = self.setup.shirt, self.setup.link
        now = self._clock.now()
        chair_wait = math.inf if link is None else link.longest_wait(self._deadline, now)
        if shirt is not None:
            frame, lost = self._read(shirt, min(self._wait, chair_wait))
        else:
            self._clock.sleep_until(min(self._deadline, now + chair_wait))
            frame, lost = None, 0
        t = self._clock.now()
        if link is not None:
            link.listen(t)
            if frame is None and t < self._deadline:
                self.send_to_chair()
                return
        self._step(frame, lost)

    def _read(self, shirt: Shirt, wait: float) -> tuple[SensorFrame | None, int]:
        """Return the shirt's next frame and how many it has lost; release a shirt whose driver fails."""
        try:
            return shirt.read(wait), shirt.lost
        except Exception as error:  # whatever a driver raises, the loop turns on
            self.setup.release_failed_shirt(error)
            return None, 0

    def send_to_chair(self) -> None:
        """Send what the gate permits to a real chair, when a command is due or the gate's state has changed."""
        link, shirt, gate = self.setup.link, self.setup.shirt, self.setup.chain.gate
        if link is None:
            return
        t = self._clock.now()
        if gate.state is State.ARMED and t >= link.due and shirt is not None and shirt.pending():
            self._delayed_since = min(self._delayed_since, t)
            if t - self._delayed_since < BURST:
                return
        self._delayed_since = math.inf
        link.send(gate.state, self.setup.chain.limits, t)

    def _step(self, frame: SensorFrame | None, lost: int) -> None:
        t = self._clock.now()
        if t > self._deadline + self._period:
            self.late += 1
        self._deadline = t + self._wait
        setup, conditions, run = self.setup, self.conditions, self.run
        link = setup.link
        conditions.supervisor_age = t - self.last_heartbeat
        conditions.screen_age, conditions.screen = t - self.last_screen_report, self.screen
        conditions.recording = not run.writer.damage if run is not None else link is None
        conditions.chair = chair_condition(link)
        conditions.chair_age = 0.0 if link is None else link.age(t)
        self._pause_for_screen(t)
        tick = setup.chain.step(frame, t, conditions)
        if tick.fault is Fault.NONE:
            tick.fault = self.pause.reason
        state = setup.chair.state
        tick.driven_v, tick.driven_omega, tick.dial = state.v, state.omega, setup.chain.dial
        self.send_to_chair()  # first: nothing that is only shown or recorded may delay a stop
        if link is not None:
            link.report(tick, t)
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

    def _pause_for_screen(self, t: float) -> None:
        """Let a late screen pause an armed trial on the virtual chair; for anything else it stays a fault."""
        run, setup = self.run, self.setup
        if setup.link is not None or run is None or run.kind != "drive" or not run.was_armed:
            self.pause.end()
        elif self.pause.decide(t, setup.chain.gate, self.conditions):
            setup.chain.arm()

    def _show(self, view: BodyView, tick: Tick, cue: int, run_t: float) -> None:
        """Update what the simulated body sees."""
        run = self.run
        if run is None or cue == NO_CUE:
            view.cue, view.cue_elapsed = None, 0.0
        else:
            view.cue = run.cues[cue]
            view.cue_elapsed = run_t - view.cue.start
        view.cursor = self._cursor(tick, run_t)
        view.driving = tick.state is State.ARMED and run is not None and run.kind == "drive"
        view.pose = Pose(tick.x, tick.y, tick.theta)
        chair = self.setup.chair.state
        view.v, view.omega = chair.v, chair.omega
        view.in_contact = tick.in_contact
        leader = self.setup.leader
        view.leader = None if leader is None else LeaderView(*leader.at(tick.scene_t))

    def _cursor(self, tick: Tick, run_t: float) -> CursorView | None:
        """Return what a simulated body sees of an interface test. Its figures come from the recording alone."""
        if self.run is None or self.run.task is None:
            return None
        self.run.task.step(run_t, tick.u1, tick.u2)
        return CursorView.of(self.run.task)


def chair_condition(link: LinkedChair | None) -> ChairCondition:
    """Return the condition of the chair that the gate takes into account; None: the virtual chair."""
    if link is None:
        return ChairCondition.READY
    if link.inhibited:
        return ChairCondition.INHIBITED
    return ChairCondition.READY if link.ready else ChairCondition.WAITING
