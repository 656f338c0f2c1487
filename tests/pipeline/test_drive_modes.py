"""One suite for every control mode and both kinds of chair: what must hold for the whole chain."""

import math

import numpy as np
import pytest

from app.calibration.vocabulary import STOP_TOGETHER
from app.faults import Fault, State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import ChairCondition, Conditions
from app.pipeline.stop_ramp import STOP_TIME
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from building import make_parameters, make_signals

RATE = 100.0
DT = 1 / RATE
KINDS = ("railed", "flat", "nan", "infinite", "out of range")


class RealChair:
    """A virtual chair that claims to be real; no heir of it, because a compiled one can have none."""

    is_real = True

    def __init__(self, *given):
        self._chair = VirtualChair(*given)

    def __getattr__(self, name):
        return getattr(self._chair, name)


class Ride:
    """A chain and its time."""

    def __init__(self, mode, chair, **changes):
        self.parameters = make_parameters().model_copy(update={"mode_u1": mode, **changes})
        self.chain = Chain(RATE, self.parameters, chair(None, Pose(0.0, 0.0, 0.0)))
        self.gate = self.chain.gate
        self.steps = 0
        self.held = np.float32(0.0)  # (n_channels,) what a movement left in the signals: no limb jumps back

    def feed(self, frame, **conditions):
        t = self.steps / RATE
        self.steps += 1
        sensed = None if frame is None else SensorFrame(self.steps, t, t, frame + self.held)
        return self.chain.step(sensed, t, Conditions(**conditions))

    def rest(self, seconds, seed=0):
        frames = make_signals(self.parameters, round(seconds * RATE), seed=seed, strokes=False)
        for frame in frames:
            tick = self.feed(frame)
        return tick

    def armed(self):
        assert self.chain.arm()
        assert self.rest(0.8).state is State.ARMED
        return self

    def bend(self, *joints, seconds=0.6):
        """Return the frames of a stroke of these joints."""
        count = round(seconds * RATE)
        frames = make_signals(self.parameters, count, seed=5, strokes=False)
        for joint in self.parameters.profile.joints:
            if joint.name in joints:
                frames[:, list(joint.channels)] += np.outer(np.linspace(0, 0.8, count), joint.direction) * joint.span
        return frames

    def moving(self):
        self.armed()
        for frame in self.bend("right_elbow", "right_shoulder", seconds=0.4):
            tick = self.feed(frame)
        assert tick.v > 0.1
        assert tick.omega > 0.1
        self.held = frame - self.bend()[-1]
        return self


@pytest.fixture(params=["velocity", "acceleration"])
def mode(request):
    return request.param


@pytest.fixture(params=[VirtualChair, RealChair])
def ride(request, mode):
    return Ride(mode, request.param)


def test_nothing_moves_that_was_not_armed(ride):
    for frame in ride.bend("right_elbow", "right_shoulder", seconds=2.0):
        tick = ride.feed(frame)
        assert (tick.v, tick.omega, tick.state) == (0.0, 0.0, State.DISARMED)


def test_nothing_moves_during_the_neutral_check(ride):
    ride.chain.arm()
    for frame in ride.bend("right_elbow", seconds=2.0):
        tick = ride.feed(frame)
        assert (tick.v, tick.omega) == (0.0, 0.0)
        assert tick.state is not State.ARMED


@pytest.mark.parametrize(
    ("conditions", "fault"),
    [
        ({"supervisor_age": 0.301}, Fault.WEB_SILENT),
        ({"screen_age": 0.301}, Fault.SCREEN_LOST),
        ({"screen": Fault.SCREEN_HIDDEN}, Fault.SCREEN_HIDDEN),
        ({"screen": Fault.SCREEN_SLOW}, Fault.SCREEN_SLOW),
        ({"recording": False}, Fault.RECORDING_LOST),
        ({"chair_age": 0.301}, Fault.CHAIR_SILENT),
        ({"chair": ChairCondition.WAITING}, Fault.CHAIR_DISARMED),
        ({"chair": ChairCondition.INHIBITED}, Fault.STOP_CHAIR),
    ],
)
def test_each_condition_stops_at_its_first_tick_and_latches(ride, conditions, fault):
    ride.moving()
    frames = ride.bend("right_elbow")
    tick = ride.feed(frames[0], **conditions)
    assert (tick.state, tick.fault, tick.stops) == (State.FAULT, fault, 1)
    speeds = [abs(ride.feed(frame).v) for frame in frames]  # without the fault it stays stopped
    assert speeds == sorted(speeds, reverse=True)
    assert speeds[round(STOP_TIME * RATE) + 1] == 0.0


@pytest.mark.parametrize("fault", [Fault.STOP_TABLET, Fault.STOP_KEY])
def test_a_stop_from_outside_beats_the_strongest_movement(ride, fault):
    ride.moving()
    ride.gate.stop(fault)
    for count, frame in enumerate(ride.bend("right_elbow", "right_shoulder", seconds=1.0)):
        tick = ride.feed(frame)
        assert (tick.state, tick.fault) == (State.FAULT, fault)
        assert count <= STOP_TIME * RATE or (tick.v, tick.omega) == (0.0, 0.0)


def test_the_stop_gesture_stops(ride):
    ride.armed()
    ticks = [(tick.state, tick.fault) for tick in map(ride.feed, ride.bend("right_elbow", "left_elbow"))]
    assert ticks[-1] == (State.FAULT, Fault.STOP_GESTURE)
    assert ride.gate.last == (0.0, 0.0)


def test_a_stop_gesture_counts_once_each_time_it_is_made(ride):
    """Otherwise nobody could have seen the last one while the gesture lasts, and its notice would be said again."""
    ride.moving()
    ride.gate.stop(Fault.STOP_TABLET)
    for times in (1, 2):
        active = [min(ride.feed(frame).activation[:2]) > 0 for frame in ride.bend("right_elbow", "left_elbow")]
        assert sum(active) > 2
        assert ride.gate.stops == 1 + times
        ride.rest(1.0)


def test_a_cleared_stop_moves_nothing_before_a_new_check(ride):
    ride.moving()
    ride.gate.stop(Fault.STOP_TABLET)
    ride.rest(0.5)
    assert ride.gate.clear(ride.gate.stops)
    for frame in ride.bend("right_elbow", seconds=1.0):
        assert ride.feed(frame).v == 0.0
    assert ride.rest(1.0).state is State.DISARMED


def test_frames_that_stop_coming_silence_and_then_stop(ride):
    ride.moving()
    seen = [(tick.u1, tick.u2, tick.state) for tick in (ride.feed(None) for _ in range(25))]
    assert all(u1 == u2 == 0.0 for u1, u2, _ in seen[round(0.05 * RATE) + 1 :])
    assert State.FAULT not in [state for *_, state in seen[: round(0.2 * RATE) - 1]]
    assert seen[round(0.2 * RATE) + 1][2] is State.FAULT
    assert ride.gate.fault is Fault.SHIRT_SILENT


def broken(values, channel, kind, profile):
    """Return the frame with one channel broken in this way."""
    wrong = values.copy()
    half = 0.5 * (profile.high[channel] - profile.low[channel])
    middle = 0.5 * (profile.high[channel] + profile.low[channel])
    wrong[channel] = {
        "railed": middle + 40 * half,
        "flat": next(m.mean[m.channels.index(channel)] for m in profile.joints if channel in m.channels),
        "nan": math.nan,
        "infinite": -math.inf,
        "out of range": middle - 1.51 * half,
    }[kind]
    return wrong


@pytest.mark.parametrize("kind", KINDS)
def test_each_channel_that_breaks_silences_its_gesture_and_moves_nothing(mode, kind):
    names = [gesture.joint for gesture in make_parameters().gestures]
    for channel in range(52):
        ride = Ride(mode, VirtualChair).armed()
        profile = ride.parameters.profile
        joint = next(joint for joint in profile.joints if channel in joint.channels)
        gesture = names.index(joint.name)
        for count, frame in enumerate(make_signals(ride.parameters, 40, seed=3, strokes=False)):
            tick = ride.feed(broken(frame, channel, kind, profile))
            assert (tick.v, tick.omega) == (0.0, 0.0)
            assert kind == "flat" or tick.activation[gesture] == 0.0
            assert kind != "flat" or count < 22 or tick.activation[gesture] == 0.0
        lost_brake = mode == "acceleration" and joint.name in STOP_TOGETHER
        assert (tick.fault is Fault.BRAKE_BAD) == lost_brake, joint.name


@pytest.mark.parametrize("kind", KINDS)
def test_channels_of_two_gestures_end_the_drive(ride, kind):
    ride.moving()
    profile = ride.parameters.profile
    first, second = (profile.joints[i].channels[0] for i in (2, 3))  # the shoulders, which are no brakes
    for frame in make_signals(ride.parameters, 40, seed=3, strokes=False):
        tick = ride.feed(broken(broken(frame, first, kind, profile), second, kind, profile))
    assert (tick.state, tick.fault) == (State.FAULT, Fault.CHANNELS_BAD)
    assert (tick.v, tick.omega) == (0.0, 0.0)


def test_with_a_broken_channel_nothing_arms(ride):
    ride.chain.arm()
    channel = ride.parameters.profile.joints[2].channels[0]
    for frame in make_signals(ride.parameters, 520, seed=3, strokes=False):
        tick = ride.feed(broken(frame, channel, "nan", ride.parameters.profile))
        assert tick.state is not State.ARMED
    assert tick.fault is Fault.CHANNELS_BAD


def test_lighter_or_heavier_filters_and_softer_ramps_change_nothing_of_a_stop(mode):
    ways = []
    for cutoff, jerk in ((1.0, 0.5), (8.0, 20.0)):
        soft = Speeds(jerk=jerk, turn_jerk=20 * jerk, deceleration=0.1, acceleration=3.0)
        ride = Ride(mode, VirtualChair, cutoff=cutoff, speeds=soft).armed()
        ride.gate.last = ride.gate.last._replace(v=0.7, omega=1.0)
        ride.gate.stop(Fault.STOP_KEY)
        ways.append([(tick.v, tick.omega) for tick in (ride.feed(f) for f in ride.bend("right_elbow", seconds=0.4))])
    assert ways[0] == ways[1]
    assert ways[0][round(STOP_TIME * RATE)] == (0.0, 0.0)


def test_the_smallest_of_set_clinic_chair_and_dial_holds(ride):
    ride.chain.arm()
    assert ride.chain.set_clinic(Speeds(forward=0.3, turn=0.4))
    assert ride.chain.set_dial(0.5)
    assert (ride.chain.limits.forward, ride.chain.limits.turn) == (0.15, 0.2)
    ride.rest(0.8)
    twists = [(tick.v, tick.omega) for tick in (ride.feed(f) for f in ride.bend("right_elbow", "right_shoulder"))]
    assert max(v for v, _ in twists) == pytest.approx(0.15, abs=0.02)
    assert max(omega for _, omega in twists) == pytest.approx(0.2, abs=0.02)
    assert not ride.chain.set_dial(1.0)
    assert not ride.chain.set_clinic(HIGHEST_SPEEDS)
    assert ride.chain.dial == 0.5


def test_turning_the_dial_down_slows_a_chair_that_drives(mode):
    ride = Ride(mode, VirtualChair).moving()
    assert ride.chain.set_dial(0.1)
    frames = ride.bend("right_elbow", seconds=1.5)
    speeds = [ride.feed(frame).v for frame in frames]
    assert speeds[0] > 0.1
    assert speeds[-1] <= 0.08 + 1e-6


def test_the_same_input_gives_the_same_commands_on_either_chair_bit_for_bit(mode):
    logs = []
    for chair in (VirtualChair, RealChair):
        ride = Ride(mode, chair).armed()
        frames = make_signals(ride.parameters, 3000, seed=9)
        logs.append([(tick.v, tick.omega, tick.u1, tick.u2, tick.state) for tick in map(ride.feed, frames)])
    assert logs[0] == logs[1]
    assert any(v for v, *_ in logs[0])


@pytest.mark.parametrize("chair", [VirtualChair, RealChair])
@pytest.mark.parametrize(
    ("axis", "joint", "changes"),
    [("v", "right_elbow", {"cruise_time": 2.0}), ("omega", "left_shoulder", {"turn_cruise_time": 2.0})],
)
def test_a_cruise_that_nobody_asks_for_runs_out_on_either_chair_and_axis(chair, axis, joint, changes):
    ride = Ride("acceleration", chair, mode_u2="acceleration", **changes).armed()
    for frame in ride.bend(joint):
        ride.feed(frame)
    posture = ride.bend(joint)[-1]
    noise = np.random.default_rng(4).normal(scale=0.002, size=(500, len(posture))).astype(np.float32)
    speeds = [abs(getattr(ride.feed(posture + wobble), axis)) for wobble in noise]
    assert speeds[150] > 0.1
    assert max(speeds[350:]) == 0.0  # the time-out of 2 s, and the way to standstill
    assert ride.gate.state is State.ARMED
