"""The loop with a real chair on a fake clock: ticks equal to those with the virtual chair, commands in time."""

import itertools

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.chair.chair_stand_in import ARMED, CHECKING, DISARMED, StandInChair
from pipeline.scripted_shirt import RATE, ScriptedShirt

from app.faults import Fault, State
from app.hardware.chair.packet import DRIVE, STOP
from app.hardware.configs import VirtualChairConfig
from app.pipeline.loop import ControlLoop
from app.pipeline.open_run import OpenRun
from app.pipeline.setup import Setup
from app.texts import Text
from building import make_parameters, make_ring, make_signals

NEUTRAL = 0.5  # s


class Writer:
    damage = ""


class AnsweringChair(StandInChair):
    """Accepts an epoch, arms after half a second, and sends telemetry at 10 Hz and at each change."""

    def __init__(self, folder):
        super().__init__(folder)
        self.state, self.epoch, self.since, self.last = DISARMED, 0, 0.0, None
        self.changes = {}
        self.log = []
        self._said = -1.0

    def turn(self, t):
        before = self.state
        for command in self.commands():
            self.log.append((t, command))
            self.last = command
            if command.epoch != self.epoch:
                self.epoch, self.state, self.since = command.epoch, CHECKING, t
        if self.state == CHECKING and t - self.since >= NEUTRAL:
            self.state = ARMED
        if self._sender is not None and (t - self._said >= 0.1 or self.state != before):
            self._said = t
            self.say(self.state, self.epoch, self.last.sequence if self.last else 0, **self.changes)


class Drive:
    """A loop with a heartbeat and frames at given times."""

    def __init__(self, ring, times, values=None, chair=None, rate=RATE):
        self.parameters = make_parameters(sample_rate=rate)
        self.clock, self.ring, self.chair = FakeClock(), ring, chair
        if values is None:
            values = make_signals(self.parameters, len(times), strokes=False)
        self.setup = Setup(self.clock)
        self.setup.shirt = ScriptedShirt(self.clock, times, values, rate, self.parameters.profile.layout)
        self.setup.use_parameters(self.parameters)
        if chair is not None:
            self.use_chair(chair.config)
        self.loop = ControlLoop(self.setup, ring, None, self.clock)
        self.loop.run = OpenRun("r", 1, "drive", (), 0.0, Writer())

    def use_chair(self, config):
        change = self.setup.change_chair(config)
        change.use(change.open())

    @property
    def gate(self):
        return self.setup.chain.gate

    def until(self, t):
        while self.clock.now() < t:
            self.loop.last_heartbeat = self.loop.last_screen_report = self.clock.now()
            self.loop.turn()
            if self.chair is not None:
                self.chair.turn(self.clock.now())

    def arm(self, t=0.5):
        self.until(t)
        self.setup.chain.arm()
        self.until(t + 1.2)
        assert self.gate.state is State.ARMED

    def ticks(self):
        return self.ring.since(0)[0]


@pytest.fixture
def make_drive():
    made = []

    def make(*arguments, **keywords):
        ring = make_ring()
        made.append(Drive(ring, *arguments, **keywords))
        return made[-1]

    yield make
    for drive in made:
        drive.setup.close()
        drive.ring.close()


@pytest.fixture
def chair(tmp_path):
    made = AnsweringChair(tmp_path)
    yield made
    made.close()


def frame_times(seconds, rate=RATE):
    return [i / rate for i in range(int(seconds * rate))]


def test_the_same_frames_give_the_same_command_log_on_both_chairs(make_drive, chair):
    """Safety S12: bit for bit, turns without a frame and jitter included."""
    rng = np.random.default_rng(3)
    times = np.sort(np.array(frame_times(20.0)) + rng.uniform(0.0, 0.008, 2000))
    times = times[rng.random(2000) > 0.02]
    parameters = make_parameters()
    rest, strokes = make_signals(parameters, 250, strokes=False), make_signals(parameters, len(times) - 250, seed=1)
    signals = np.concatenate((rest, strokes))
    logs = []
    for which in (None, chair):
        drive = make_drive(times, signals, which)
        drive.arm()
        drive.until(20.0)
        logs.append(drive.ticks())
    virtual, real = (log[: min(map(len, logs))] for log in logs)
    assert len(real) > 1900
    assert virtual["t"].tolist() == real["t"].tolist()
    assert set(virtual["chair_kind"]) == {0}
    assert set(real["chair_kind"]) == {1}
    begun = max(np.argmax(log["state"] == State.ARMED) for log in logs)
    assert np.abs(virtual["v"][begun:]).max() > 0.1
    for name in ("score", "activation", "u1", "u2", "v", "omega", "state"):
        assert virtual[name][begun:].tobytes() == real[name][begun:].tobytes(), name
    # ... and the commands to the chair equal the twists in the ticks.
    commanded = {np.float32(v) for v in real["v"]}
    assert {np.float32(command.v) for _, command in chair.log} <= commanded
    assert max(command.v for _, command in chair.log) > 0.1


@pytest.mark.parametrize("rate", [10.0, 63.0, 100.0, 1000.0])
def test_commands_go_out_at_50_hz_whatever_the_shirt_s_rate(make_drive, chair, rate):
    drive = make_drive(frame_times(6.0, rate), chair=chair, rate=rate)
    drive.arm()
    drive.until(4.0)
    sent = [t for t, command in chair.log if command.flags == DRIVE]
    gaps = np.diff(sent)
    assert len(sent) > 100
    assert gaps.max() < 0.0201 + 1 / 1000
    assert gaps.mean() == pytest.approx(0.02, abs=1e-4)


def test_of_frames_that_waited_only_the_newest_is_told(make_drive, chair):
    parameters = make_parameters()
    signals = np.concatenate((make_signals(parameters, 250, strokes=False), make_signals(parameters, 550, seed=1)))
    drive = make_drive(frame_times(8.0), signals, chair)
    drive.arm()
    while abs(drive.gate.last.v) < 0.1:  # until a stroke has begun
        drive.until(drive.clock.now() + 0.01)
    drive.clock.time += 0.06  # as if the process had been suspended
    before, held = len(chair.log), drive.ring.number
    while drive.setup.shirt.pending():
        drive.clock.time += 0.0005  # the time for decoding
        drive.loop.last_heartbeat = drive.loop.last_screen_report = drive.clock.now()
        drive.loop.turn()
        chair.turn(drive.clock.now())
    speeds = drive.ring.since(held)[0]["v"].astype(np.float32).tolist()
    assert len(set(speeds)) >= 5
    assert [command.v for _, command in chair.log[before:]] == speeds[-1:]


def test_a_stop_between_two_ticks_is_told_without_waiting_for_the_next(make_drive, chair):
    drive = make_drive(frame_times(6.0), chair=chair)
    drive.arm()
    chair.commands()
    ticks = drive.ring.number
    drive.gate.stop(Fault.STOP_TABLET)
    drive.loop.send_to_chair()
    assert [command.flags for command in chair.commands()] == [STOP]
    assert drive.ring.number == ticks


def test_the_chair_s_say_is_in_the_ticks(make_drive, chair):
    drive = make_drive(frame_times(6.0), chair=chair)
    chair.changes = {"battery": 0.25, "v": 0.5, "omega": -0.125, "fault": 3}
    drive.arm()
    newest = drive.ticks()[-1]
    assert (newest["chair_kind"], newest["chair_state"], newest["chair_fault"], newest["stop_input"]) == (1, 2, 3, 0)
    assert (newest["battery"], newest["driven_v"], newest["driven_omega"]) == (0.25, 0.5, -0.125)
    assert (newest["own_joystick"], newest["measured"]) == (0, 0)
    assert 0.0 <= newest["chair_age"] <= 0.15
    assert newest["x"] != 0.0


def test_where_the_chair_measures_its_speed_that_is_in_the_ticks(make_drive, chair):
    drive = make_drive(frame_times(6.0), chair=chair)
    chair.changes = {"v": 0.5, "omega": -0.125, "measured_v": 0.375, "measured_omega": 0.25}
    drive.arm()
    newest = drive.ticks()[-1]
    assert (newest["driven_v"], newest["driven_omega"], newest["measured"]) == (0.375, 0.25, 1)


def test_without_a_recording_a_real_chair_is_not_driven(make_drive, chair):
    drive = make_drive(frame_times(6.0), chair=chair)
    drive.loop.run = None
    drive.until(0.5)
    drive.setup.chain.arm()
    drive.until(0.6)
    assert drive.gate.fault is Fault.RECORDING_LOST


@pytest.mark.parametrize("broken", [True, False])
def test_a_recording_that_ends_or_breaks_stops_it(make_drive, chair, broken):
    drive = make_drive(frame_times(6.0), chair=chair)
    drive.arm()
    if broken:
        drive.loop.run.writer.damage = Text("recording-not-written", reason="full")
    else:
        drive.loop.run = None
    drive.until(2.0)
    assert drive.gate.fault is Fault.RECORDING_LOST
    assert chair.last.flags == STOP


@pytest.mark.parametrize(
    ("happens", "fault"),
    [
        ({"stop_input": 1}, Fault.STOP_CHAIR),
        ({"state": 3}, Fault.STOP_CHAIR),
        ({"state": DISARMED}, Fault.CHAIR_DISARMED),
        (None, Fault.CHAIR_SILENT),
    ],
)
def test_what_the_chair_says_or_does_not_say_stops_it(make_drive, chair, happens, fault):
    drive = make_drive(frame_times(6.0), chair=chair)
    drive.arm()
    at = drive.clock.now()
    if happens is None:
        chair.say = lambda *_, **__: None
    else:
        chair.nonce = b"nonce--2"
        chair.state = happens.get("state", ARMED)
        chair.changes = {name: value for name, value in happens.items() if name != "state"}
    while drive.gate.state is State.ARMED:
        drive.until(drive.clock.now() + 0.01)
    assert drive.gate.fault is fault
    assert drive.clock.now() - at < (0.33 if happens is None else 0.15)
    chair.turn(drive.clock.now())
    assert (chair.last.flags, chair.last.v) == (STOP, 0.0)


def test_a_chair_that_takes_no_arming_is_not_ready(make_drive, chair):
    drive = make_drive(frame_times(8.0), chair=chair)
    drive.until(0.5)
    drive.setup.chain.arm()
    chair.turn = lambda _t: (chair.commands(), chair.say(DISARMED))
    drive.until(7.0)
    assert drive.gate.fault is Fault.CHAIR_NOT_READY
    assert not (drive.ticks()["state"] == State.ARMED).any()


def test_back_on_the_virtual_chair_nothing_is_asked_of_the_real_one(make_drive, chair):
    drive = make_drive(frame_times(6.0), chair=chair)
    drive.until(0.5)
    drive.use_chair(VirtualChairConfig(kind="virtual"))
    drive.chair = None
    drive.arm(0.6)
    assert drive.ticks()["chair_kind"][-1] == 0


def test_a_new_arming_in_the_same_breath_is_a_new_one_to_the_chair(make_drive, chair):
    drive = make_drive(frame_times(6.0), chair=chair)
    drive.arm()
    first = chair.epoch
    drive.gate.disarm()
    drive.loop.send_to_chair()
    drive.setup.chain.arm()
    drive.until(2.0)
    flags = [(command.epoch == first, command.flags) for _, command in chair.log[-20:]]
    changes = [flag for flag, _ in itertools.groupby(flags)]
    assert changes == [(True, DRIVE), (True, 0), (False, 0)]
