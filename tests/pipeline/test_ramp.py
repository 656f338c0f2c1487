"""Speed, acceleration and jerk of one axis: for any requests, any steps, from any reachable state."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.pipeline.ramp import SLACK, Ramp, is_reached, reach

FORWARD = Ramp(top=0.8, bottom=0.3, acceleration=0.8, deceleration=1.2, jerk=8.0)
ROUNDING = 1e-6  # of a limit: a change is a difference of speeds, divided by a short time

ramps = st.builds(
    Ramp,
    top=st.floats(0.05, 1.5),
    bottom=st.floats(0.05, 1.5),
    acceleration=st.floats(0.1, 3.0),
    deceleration=st.floats(0.1, 3.0),
    jerk=st.floats(0.5, 20.0),
)
steps = st.one_of(st.just(0.01), st.floats(1e-4, 0.1))
wishes = st.one_of(st.floats(-2, 2), st.floats(allow_nan=False, allow_infinity=False), st.just(0.0))


def followed(ramp, wishes_and_steps, speed=0.0, rate=0.0):
    """Yield (speed before, rate before, speed, rate, dt) along the way."""
    for asked, dt in wishes_and_steps:
        after = ramp.bounded(speed, rate, asked, dt)
        change = (after - speed) / dt
        yield speed, rate, after, change, dt
        speed, rate = after, change


def assert_within(ramp, before, rate, after, change, dt):
    assert -ramp.bottom <= after <= ramp.top
    assert abs(change - rate) <= ramp.jerk * dt * (1 + ROUNDING) + ROUNDING
    if before * change > 0 or before == 0.0:  # away from standstill
        assert abs(change) <= ramp.acceleration * (1 + ROUNDING)
    else:
        assert abs(change) <= max(ramp.acceleration, ramp.deceleration) * (1 + ROUNDING)
    if before * after > 0 and abs(after) < abs(before):
        assert abs(change) <= ramp.deceleration * (1 + ROUNDING) or abs(rate) > abs(change)


@given(ramps, st.lists(st.tuples(wishes, steps), max_size=120))
def test_no_wish_whatever_gets_past_speed_acceleration_and_jerk(ramp, wished):
    for step in followed(ramp, wished):
        assert_within(ramp, *step)


@pytest.mark.parametrize("seed", range(4))
def test_nor_do_twenty_five_thousand_of_them(seed):
    rng = np.random.default_rng(seed)
    ramp = Ramp(*rng.uniform((0.05, 0.05, 0.1, 0.1, 0.5), (1.5, 1.5, 3.0, 3.0, 20.0)).tolist())
    kinds = rng.choice([9.0, -9.0, 0.0, 1e308, -1e308, 5e-324], size=25_000)
    wished = np.where(rng.random(25_000) < 0.5, kinds, rng.normal(size=25_000)).repeat(1)
    widths = np.where(rng.random(25_000) < 0.7, 0.01, rng.uniform(1e-4, 0.1, 25_000))
    for step in followed(ramp, zip(wished.tolist(), widths.tolist(), strict=True)):
        assert_within(ramp, *step)


def test_what_may_be_done_is_handed_back_bit_for_bit():
    rng = np.random.default_rng(3)
    for speed, more in zip(rng.uniform(0.1, 0.5, 500).tolist(), rng.uniform(-1, 1, 500).tolist(), strict=True):
        asked = speed + 0.05 * more * 0.01
        assert FORWARD.bounded(speed, 0.0, asked, 0.01) == asked


def test_what_may_not_be_done_is_not_handed_back():
    assert FORWARD.bounded(0.1, 0.0, 0.1 + 0.081 * 0.01, 0.01) == pytest.approx(0.1 + 0.08 * 0.01, abs=1e-12)


def test_a_chair_that_brakes_softly_may_still_set_off_briskly():
    brisk = replace(FORWARD, acceleration=2.0, deceleration=0.5)
    assert max(change for *_, change, _ in followed(brisk, [(0.8, 0.01)] * 150)) == pytest.approx(2.0)
    assert min(change for *_, change, _ in followed(brisk, [(0.0, 0.01)] * 300, speed=0.8)) == pytest.approx(-0.5)


@pytest.mark.parametrize(
    ("away", "rate", "after"),
    [
        (0.125, 0.0, 0.125),  # as far as one step goes whose rate falls to 0 in the next
        (0.0625, -0.5, 0.0625),  # the rate changes by as much as it may
        (0.0625, -0.75, 0.03125),  # it would have to change by more
        (0.25, 2.0, 0.125),  # further than one step: the rate could not be 0 in the next
    ],
)
def test_the_target_is_reached_in_one_step_when_the_rate_may_be_0_in_the_next(away, rate, after):
    assert FORWARD.towards(0.0, rate, away, 0.125) == after  # a step changes the rate by at most 1


@pytest.mark.parametrize("dt", [0.0, -0.01, math.nan])
def test_without_time_nothing_changes(dt):
    assert FORWARD.bounded(0.3, 0.2, 0.8, dt) == 0.3
    assert FORWARD.towards(0.3, 0.2, 0.8, dt) == 0.3
    assert FORWARD.towards(0.3, 0.0, 0.3, dt) == 0.3


@pytest.mark.parametrize("start", [0.8, -0.3])
def test_a_limit_that_was_lowered_is_come_down_to_and_never_left_upwards(start):
    lower = replace(FORWARD, top=0.2, bottom=0.1)
    way = list(followed(lower, [(9.0 * start, 0.01)] * 400, speed=start))
    assert all(abs(after) <= abs(before) for before, _, after, _, _ in way)
    assert abs(way[-1][2]) == pytest.approx(0.2 if start > 0 else 0.1, abs=1e-6)
    assert all(abs(change - rate) <= 8.0 * dt * (1 + ROUNDING) for _, rate, _, change, dt in way)
    assert max(abs(change) for *_, change, _ in way) <= 1.2 * (1 + ROUNDING)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_wish_to_slow_down_a_little_does_not_delay_the_way_to_a_lowered_limit(side):
    lowered = replace(FORWARD, top=0.3, bottom=0.3)
    kept, eased = [side], [side]
    for _ in range(30):
        for speeds, less in ((kept, 0.0), (eased, 1e-4)):
            rate = (speeds[-1] - speeds[-2]) / 0.01 if len(speeds) > 1 else 0.0
            speeds.append(lowered.bounded(speeds[-1], rate, speeds[-1] - side * less, 0.01))
    assert eased == pytest.approx(kept)
    assert abs(eased[-1]) < 0.8


@pytest.mark.parametrize("dt", [0.001, 0.01, 0.02])
@pytest.mark.parametrize("target", [0.8, 0.35, 0.0, -0.3])
@pytest.mark.parametrize("start", [0.8, 0.1, 0.0, -0.3])
def test_a_target_is_reached_exactly_and_not_passed(start, target, dt):
    speed, rate, way = start, 0.0, [start]
    for _ in range(round(4 / dt)):
        after = FORWARD.bounded(speed, rate, FORWARD.towards(speed, rate, target, dt), dt)
        rate, speed = (after - speed) / dt, after
        way.append(speed)
    assert speed == pytest.approx(target, abs=1e-9)
    assert all((after - before) * (target - start) >= -1e-12 for before, after in pairwise(way))
    if target == 0.0:
        assert speed == 0.0
    # As fast as the limits permit, apart from the jerk-limited ends.
    quickest = abs(target - start) / (0.8 if abs(target) > abs(start) else 1.2) if start * target >= 0 else 0.0
    arrived = next(i for i, speed in enumerate(way) if speed == pytest.approx(target, abs=1e-4)) * dt
    assert quickest - dt <= arrived <= quickest + 0.3 + 8 * dt or start * target < 0


def test_away_from_standstill_and_towards_it_have_limits_of_their_own():
    up = [change for *_, change, _ in followed(FORWARD, [(0.8, 0.01)] * 150)]
    down = [change for *_, change, _ in followed(FORWARD, [(0.0, 0.01)] * 150, speed=0.8)]
    assert max(up) == pytest.approx(0.8)
    assert min(down) == pytest.approx(-1.2)
    through = list(followed(FORWARD, [(-0.3, 0.01)] * 200, speed=0.8))
    assert min(change for before, _, _, change, _ in through if before > 0.2) == pytest.approx(-1.2)
    assert min(change for before, _, _, change, _ in through if before <= 0) >= -0.8 * (1 + ROUNDING)
    back = list(followed(FORWARD, [(0.8, 0.01)] * 200, speed=-0.3))
    assert max(change for before, _, _, change, _ in back if before < -0.1) == pytest.approx(1.2, rel=0.2)
    assert max(change for before, _, _, change, _ in back if before >= 0) <= 0.8 * (1 + ROUNDING)


@given(st.floats(0, 3), st.floats(0.5, 20), st.floats(1e-4, 0.1))
def test_reach_spends_the_headroom_and_no_more(headroom, jerk, dt):
    rate = reach(headroom, jerk, dt)
    assert rate * dt + rate * rate / (2 * jerk) == pytest.approx(headroom, abs=1e-9)
    assert reach(-headroom, jerk, dt) == -rate or headroom == 0


def test_towards_a_target_speeding_up_and_slowing_down_have_limits_of_their_own():
    assert FORWARD.towards(0.2, 0.8, 0.8, 0.01) == pytest.approx(0.2 + 0.8 * 0.01)
    assert FORWARD.towards(0.6, -1.2, 0.0, 0.01) == pytest.approx(0.6 - 1.2 * 0.01)


def highest_by_roots(ramp, speed, top, dt):
    """Return the largest rate permitted at `speed`, by its definition."""
    within = max(-ramp.deceleration, reach(top - speed, ramp.jerk, dt))
    if speed >= 0.0:
        return min(ramp.acceleration, within)
    crossing = reach(ramp.acceleration * ramp.acceleration / (2.0 * ramp.jerk) - speed, ramp.jerk, dt)
    return min(ramp.deceleration, max(ramp.acceleration, crossing), within)


@given(ramps, st.one_of(st.floats(-2, 2), st.floats(-0.05, 0.05)), st.floats(0.05, 1.5), steps)
def test_beyond_standstill_slowing_down_is_speeding_up(ramp, speed, top, dt):
    assert ramp._at_most(math.inf, speed, top, dt) == highest_by_roots(ramp, speed, top, dt)


def bounded_by_roots(ramp, speed, rate, asked, dt):
    """Return what `bounded` returns, by the formula that computes every limit of the rate with its root."""
    wanted = (asked - speed) / dt
    low, high = -highest_by_roots(ramp, -speed, ramp.bottom, dt), highest_by_roots(ramp, speed, ramp.top, dt)
    permitted = min(high, max(low, wanted))
    permitted = min(rate + ramp.jerk * dt, max(rate - ramp.jerk * dt, permitted))
    following = asked if abs(permitted - wanted) <= SLACK * ramp.acceleration else speed + permitted * dt
    return min(max(ramp.top, speed), max(min(-ramp.bottom, speed), following))


@given(ramps, st.floats(-2, 2), st.floats(-5, 5), wishes, steps)
def test_limits_without_roots_are_the_limits_with_roots_bit_for_bit(ramp, speed, rate, asked, dt):
    assert ramp.bounded(speed, rate, asked, dt) == bounded_by_roots(ramp, speed, rate, asked, dt)


@given(ramps, st.lists(st.tuples(wishes, steps), max_size=120))
def test_so_they_are_on_every_way_that_a_chair_goes(ramp, wished):
    for (speed, rate, after, _, dt), (asked, _) in zip(followed(ramp, wished), wished, strict=True):
        assert after == bounded_by_roots(ramp, speed, rate, asked, dt)


@given(st.floats(0, 5), st.floats(0, 3), st.floats(0.5, 20.0), steps)
def test_a_rate_that_is_reached_without_a_root_is_not_above_the_root(rate, headroom, jerk, dt):
    highest = reach(headroom, jerk, dt)
    if is_reached(rate, headroom, jerk, dt):
        assert rate <= highest + ROUNDING**2
    else:
        assert rate >= highest * (1 - 1e-6)
