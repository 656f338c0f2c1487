"""The whole chain, from the movements of a person to the motion of the chair."""

import numpy as np
import pytest

from app.faults import Fault, State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from building import make_parameters, make_signals

RATE = 100.0


class Ride:
    """A chain and its time."""

    def __init__(self, parameters):
        self.chain = Chain(RATE, parameters, VirtualChair(None, Pose(0.0, 0.0, 0.0)))
        self.steps = 0

    def feed(self, frame):
        """Send one frame, or None for a turn without one."""
        t = self.steps / RATE
        self.steps += 1
        sensed = None if frame is None else SensorFrame(self.steps, t, t, frame)
        return self.chain.step(sensed, t, Conditions())

    def arm_at_rest(self, resting):
        assert self.chain.arm()
        for frame in resting[:80]:
            tick = self.feed(frame)
        assert tick.state is State.ARMED


def armed(**changes):
    """Return parameters, and a ride that is armed with them at rest."""
    parameters = make_parameters().model_copy(update=changes)
    ride = Ride(parameters)
    ride.arm_at_rest(make_signals(parameters, strokes=False))
    return parameters, ride


def bend(parameters, n, full):
    """Return frames in which the first joint moves evenly, by `full` FS in all."""
    joint = parameters.profile.joints[0]
    frames = make_signals(parameters, n, strokes=False)
    frames[:, list(joint.channels)] += np.outer(np.linspace(0, full, n), joint.direction) * joint.span
    return frames


def test_without_a_calibration_signals_pass_and_nothing_drives():
    ride = Ride(None)
    assert not ride.chain.arm()
    values = np.ones(52, dtype=np.float32)
    for _ in range(100):
        tick = ride.feed(values)
        assert tick.values is values
        assert (tick.v, tick.omega, tick.state) == (0.0, 0.0, State.DISARMED)


def test_a_body_at_rest_does_not_move_the_chair():
    parameters, ride = armed()
    for frame in make_signals(parameters, 3000, seed=2, strokes=False):
        tick = ride.feed(frame)
        assert (tick.v, tick.omega) == (0.0, 0.0)


def test_the_way_back_to_rest_does_nothing():
    parameters, ride = armed()
    assert all(ride.feed(frame).u1 == 0.0 for frame in bend(parameters, 200, -1))


def test_frames_that_stop_coming_neutralise_after_50_ms_and_stop_after_200_ms():
    parameters, ride = armed(mode_u1="velocity")
    for frame in bend(parameters, 60, 0.8):
        tick = ride.feed(frame)
    assert tick.u1 > 0.5
    silence = [(tick.u1, tick.state) for tick in (ride.feed(None) for _ in range(25))]
    assert [u1 > 0 for u1, _ in silence[:4]] == [True] * 4
    assert all(u1 == 0 for u1, _ in silence[5:])
    assert silence[18][1] is State.ARMED
    assert silence[-1][1] is State.FAULT
    assert ride.chain.gate.fault is Fault.SHIRT_SILENT


def test_before_the_first_frame_nothing_arms():
    ride = Ride(make_parameters())
    ride.chain.arm()
    states = [ride.feed(None).state for _ in range(100)]
    assert State.ARMED not in states
    assert states[-1] is State.FAULT


def test_a_bad_channel_silences_its_gesture_and_two_bad_gestures_stop():
    parameters, ride = armed()
    frames = make_signals(parameters, 100, strokes=False)
    left, right = (parameters.profile.joints[i].channels[0] for i in (2, 3))  # the shoulders
    frames[:50, left] = np.nan
    for frame in frames[:50]:
        tick = ride.feed(frame)
        assert tick.activation[2] == 0.0
        assert np.isfinite(tick.score).all()
    assert tick.state is State.ARMED
    frames[50:, right] = 1e9
    frames[50:, left] = np.nan
    assert ride.feed(frames[50]).fault is Fault.CHANNELS_BAD


def test_a_reset_forgets_the_past_and_disarms():
    parameters, ride = armed()
    values = make_signals(parameters, 1000)
    for frame in values:
        ride.feed(frame)
    ride.chain.reset()
    tick = ride.feed(values[500])
    assert tick.state is State.DISARMED
    assert tick.rate == [0.0] * 4
    assert (tick.u1, tick.u2) == (0.0, 0.0)


def test_a_body_that_is_not_seen_is_not_seen_at_rest():
    parameters = make_parameters()
    ride = Ride(parameters)
    for i, frame in enumerate(make_signals(parameters, 200, strokes=False)):
        ride.feed(frame if i % 2 else None)  # half of the frames are lost
    assert ride.chain.arm()
    states = [ride.feed(frame if i % 2 else None).state for i, frame in enumerate(bend(parameters, 90, 1.2))]
    assert State.ARMED not in states


@pytest.mark.parametrize(("mode", "limit"), [("acceleration", 0.2), ("velocity", 1.5)])
def test_losses_that_go_on_stop_and_a_chair_that_cruises_sooner(mode, limit):
    parameters, ride = armed(mode_u1=mode)
    for frame in bend(parameters, 60, 0.8):
        tick = ride.feed(frame)
    assert tick.v > 0.1
    frames = make_signals(parameters, 300, strokes=False) + (
        bend(parameters, 60, 0.8)[-1] - bend(parameters, 60, 0)[-1]
    )
    seen = [(ride.feed(frame if i % 2 else None).fault, ride.chain._loss.too_lossy) for i, frame in enumerate(frames)]
    silenced = [lossy for _, lossy in seen].index(True)
    stopped = [fault for fault, _ in seen].index(Fault.SHIRT_LOSSY)
    assert (stopped - silenced) / RATE == pytest.approx(limit, abs=0.02)
    assert ride.chain.gate.stops == 1
    assert ride.chain.gate.last == (0.0, 0.0)


def test_one_burst_of_losses_is_no_fault():
    parameters, ride = armed()
    for i, frame in enumerate(make_signals(parameters, 400, strokes=False)):
        tick = ride.feed(None if 100 <= i < 118 else frame)
    assert (tick.state, tick.fault) == (State.ARMED, Fault.NONE)


def test_a_channel_that_comes_back_moves_nothing():
    parameters, ride = armed()
    joint = parameters.profile.joints[0]
    frames = make_signals(parameters, 150, strokes=False)
    frames[40:, list(joint.channels)] += np.array(joint.direction, dtype=np.float32) * joint.span * 0.5
    frames[30:60, joint.channels[0]] = np.nan  # the limb moved while the channel was bad
    assert all(ride.feed(frame).v == 0.0 for frame in frames)
