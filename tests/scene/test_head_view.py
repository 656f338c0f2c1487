import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.scene.head_view import AHEAD, EASE_TIME, FASTEST_TURN, LIMITS, LOST_AFTER, HeadView

DT = 1 / 60
anything = st.floats(allow_nan=True, allow_infinity=True)
angle = st.one_of(anything, st.floats(-4, 4))
ages = st.one_of(anything, st.floats(0, 1))
steps = st.lists(st.tuples(angle, angle, angle, ages), max_size=60)


def follow(view, angles, seconds, age=0.0):
    for _ in range(round(seconds / DT)):
        view.step(DT, *angles, age)
    return view.shown


@given(steps, st.floats(0, 1), st.one_of(anything, st.floats(0, 0.2)))
def test_nothing_ever_jumps_or_leaves_the_limits(inputs, share, dt):
    view = HeadView(share)
    reach = FASTEST_TURN * (dt if 0 < dt < math.inf else 0.0)
    for entry in inputs:
        before = view.shown
        after = view.step(dt, *entry)
        assert all(map(math.isfinite, after))
        assert all(abs(a - b) <= reach + 1e-9 for a, b in zip(before, after, strict=True))
        assert all(abs(a) <= most for a, most in zip(after, LIMITS, strict=True))


@settings(max_examples=60)
@given(steps, st.sampled_from([(math.nan, 0.0), (0.3, LOST_AFTER + 0.01), (0.3, math.nan), (math.inf, 0.1)]))
def test_a_lost_head_is_back_straight_ahead_after_about_a_second(inputs, loss):
    view = HeadView(1.0)
    for entry in inputs:
        view.step(DT, *entry)
    yaw, age = loss
    follow(view, (yaw, 0.1, 0.1), EASE_TIME + 0.5, age)
    assert view.shown == pytest.approx(AHEAD, abs=1e-12)


@given(steps)
def test_left_and_right_are_treated_alike(inputs):
    one, other = HeadView(0.7), HeadView(0.7)
    for yaw, pitch, roll, age in inputs:
        a = one.step(DT, yaw, pitch, roll, age)
        b = other.step(DT, -yaw, pitch, -roll, age)
        assert a == pytest.approx((-b.yaw, b.pitch, -b.roll), abs=1e-12)


def test_a_head_that_is_known_is_shown_without_lag():
    view = HeadView(1.0)
    follow(view, AHEAD, 2 * EASE_TIME)
    for number in range(300):
        t = number * DT
        angles = (0.9 * math.sin(3 * t), 0.4 * math.sin(5 * t), 0.2 * math.sin(2 * t))
        assert view.step(DT, *angles, 0.01) == pytest.approx(angles, abs=1e-9)


def test_a_loss_begins_gently_and_goes_straight_back():
    view = HeadView()
    follow(view, (1.2, 0.0, 0.0), 2.0)
    seen = [view.step(DT, math.nan, 0.0, 0.0, 0.0).yaw for _ in range(60)]
    assert seen[0] > 1.19
    assert 0.5 < seen[29] < 0.7
    assert seen == sorted(seen, reverse=True)
    assert seen[-1] == pytest.approx(0.0, abs=1e-3)


def test_a_head_that_comes_back_elsewhere_is_taken_up_gently():
    view = HeadView()
    follow(view, (1.0, 0.0, 0.0), 2.0)
    follow(view, (1.0, 0.0, 0.0), 2.0, age=9.0)
    first = view.step(DT, -1.0, 0.0, 0.0, 0.0).yaw
    assert -0.01 < first <= 0
    assert follow(view, (-1.0, 0.0, 0.0), EASE_TIME).yaw == pytest.approx(-1.0, abs=1e-9)


@pytest.mark.parametrize("share", [0.0, 0.5, 1.0])
def test_roll_is_shown_by_its_share(share):
    view = HeadView(share)
    assert follow(view, (0.0, 0.0, 0.4), 2.0).roll == pytest.approx(0.4 * share)


def test_another_share_of_roll_does_not_tilt_the_picture_at_once():
    view = HeadView(0.0)
    follow(view, (0.0, 0.0, 1.0), 2.0)
    view.roll_share = 1.0
    assert view.step(DT, 0.0, 0.0, 1.0, 0.0).roll < 0.01


def test_half_a_turn_is_the_same_on_both_sides():
    assert follow(HeadView(), (math.pi, 0, 0), 2.0).yaw == LIMITS.yaw
    assert follow(HeadView(), (-math.pi, 0, 0), 2.0).yaw == -LIMITS.yaw
