import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.shirts import small_layout

from app.hardware.base import HardwareError
from app.hardware.body.visitor import Visitor
from app.hardware.shirt.simulator import LONGEST_LAG, TRANSITION_TIME, Pace, SimulatedShirt, SimulatorConfig
from app.layout import ShirtLayout


class StillBody:
    """A body with a constant posture."""

    def __init__(self, joints, place):
        self.joints = joints
        self._posture = np.full(len(joints), place)

    def step(self, _dt, _view):
        return self._posture

    def reset(self):
        pass


def open_shirt(clock, **fields):
    shirt = SimulatedShirt(SimulatorConfig(kind="simulator", **fields), clock)
    shirt.open()
    return shirt


def read(shirt, count):
    return np.array([shirt.read(1.0).values for _ in range(count)], dtype=np.float64)


def test_the_standard_shirt_is_the_papers():
    shirt = open_shirt(FakeClock())
    assert len(shirt.layout.channels) == 52
    assert shirt.read(1.0).values.shape == (52,)


def test_frames_keep_their_deadlines_and_do_not_drift():
    clock = FakeClock(5.0)
    shirt = open_shirt(clock)
    times = []
    for i in range(50):
        times.append(shirt.read(1.0).t)
        clock.time += 0.004 * (i % 2)  # the loop is busy now and then
    np.testing.assert_allclose(times[::2], 5.0 + 0.02 * np.arange(25), atol=1e-9)


def test_after_a_long_standstill_what_was_missed_is_counted_as_lost():
    clock = FakeClock()
    shirt = open_shirt(clock)
    shirt.read(1.0)
    clock.time += 5.0
    frame = shirt.read(1.0)
    assert shirt.lost == 499
    assert frame.seq == 500
    assert frame.t_device == pytest.approx(5.0)
    assert shirt.read(1.0).seq == 501


def test_a_short_hold_up_loses_nothing():
    clock = FakeClock()
    pace = Pace(clock, 100.0)
    clock.time += LONGEST_LAG - 0.005
    count = 0
    while pace.is_due():
        assert pace.wait(0.0)
        count += 1
    assert count == 100
    assert pace.missed() == 0


def test_body_and_fabric_find_each_other_by_the_joints_names():
    def values(joints):
        shirt = open_shirt(FakeClock(), layout=small_layout())
        shirt.body = StillBody(joints, 1.0)
        return read(shirt, round(TRANSITION_TIME * 100) + 50)[-1]

    rest = values(())
    bent = values(("right_elbow",))
    assert np.abs(bent - rest).max() > 0.1
    np.testing.assert_array_equal(values(("left_wrist", "right_elbow", "head")), bent)
    np.testing.assert_array_equal(values(("left_wrist",)), rest)


def test_when_another_body_slips_in_no_limb_jumps():
    shirt = open_shirt(FakeClock(), layout=small_layout())
    shirt.body = StillBody(("right_elbow",), 1.0)
    first = read(shirt, 150)
    shirt.body = Visitor()
    second = read(shirt, 150)
    both = np.concatenate((first, second))
    span = np.ptp(both, axis=0).max()
    assert span > 0.2
    assert np.abs(np.diff(both, axis=0)).max() < 0.05 * span


def test_the_visitors_keys_reach_the_channels():
    shirt = open_shirt(FakeClock(), layout=small_layout())
    shirt.body = visitor = Visitor()
    rest = read(shirt, 120)[-20:].mean(axis=0)
    visitor.move({"right_elbow": 1.0})
    assert np.abs(read(shirt, 60)[-1] - rest).max() > 0.15


def test_the_same_seed_gives_the_same_frames_at_another_time():
    one, other = open_shirt(FakeClock(0.0), seed=4), open_shirt(FakeClock(999.0), seed=4)
    np.testing.assert_array_equal(read(one, 20), read(other, 20))


def test_a_dead_channel_that_is_not_there_is_one_sentence():
    with pytest.raises(HardwareError, match="no channel 'sleeve' that could be dead"):
        open_shirt(FakeClock(), dead_channels=("sleeve",))


def test_a_shirt_for_other_joints_is_another_document():
    channels = [{"name": name, "joint": "head"} for name in "ab"]
    hat = {"name": "hat", "channels": channels, "joints": [{"name": "head", "label": "Head"}]}
    shirt = open_shirt(FakeClock(), layout=ShirtLayout.model_validate(hat))
    assert shirt.joints == ("head",)
    assert read(shirt, 3).shape == (3, 2)
