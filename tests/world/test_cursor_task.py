"""The task of the interface test: the cursor, the order of the targets, entries, dwelling, missing."""

import math
from collections import Counter
from itertools import cycle

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.world.cursor_task import DIRECTIONS, CursorPlan, CursorTask

DT = 0.05
PLAN = CursorPlan(seed=1)
CONTROLS = st.lists(st.tuples(st.floats(-1, 1), st.floats(-1, 1)), min_size=1, max_size=300)


def clock(task):
    """Yield the times of the ticks until the test is over."""
    number = 0
    while task.phase != "over":
        yield number * DT
        number += 1


def steer(task):
    """Return controls that bring the cursor into the target within each tick as far as it can."""
    if task.target is None:
        return 0.0, 0.0
    reach = task.plan.speed * DT
    return tuple(
        min(1.0, max(-1.0, way / reach)) for way in (task.target.ahead - task.ahead, task.target.left - task.left)
    )


def played(plan, controls=steer):
    task = CursorTask(plan)
    for t in clock(task):
        task.step(t, *controls(task))
    return task


def test_a_perfect_hand_acquires_every_target_on_the_straight_way():
    task = played(PLAN)
    assert {(one.acquired, one.entries) for one in task.attempts} == {(True, 1)}
    assert len(task.attempts) == task.acquired > 60
    for one in task.attempts:
        # To the edge of the target, which is half a width nearer, at one arm a second.
        assert one.first_entry == one.last_entry == pytest.approx(one.target.distance - 0.1, abs=0.1 + DT)
        assert one.way == pytest.approx(math.dist(one.start, one.entry))


def test_targets_go_out_and_back_and_each_block_holds_every_direction_at_every_distance():
    targets = [one.target for one in played(PLAN).attempts]
    outward, back = targets[0::2], targets[1::2]
    assert all((one.ahead, one.left) == (0.0, 0.0) for one in back)
    for out, home in zip(outward, back, strict=False):
        assert home.distance == out.distance
        assert home.direction == (-out.direction[0], -out.direction[1])
    for block in (outward[:8], outward[8:16]):
        assert Counter((one.direction, one.distance) for one in block) == dict.fromkeys(
            [(direction, distance) for direction in DIRECTIONS for distance in PLAN.distances], 1
        )


def test_the_seed_decides_the_order_and_nothing_else():
    def order(seed):
        return [one.target for one in played(CursorPlan(seed=seed)).attempts][:16]

    assert order(3) == order(3)
    assert order(3) != order(4)
    assert CursorPlan(seed=3).same_task(CursorPlan(seed=4))
    assert not CursorPlan(seed=3).same_task(CursorPlan(seed=3, width=0.3))


def test_nothing_moves_before_the_first_target_and_who_rests_misses_every_target():
    task = CursorTask(PLAN)
    task.step(0.0, 1.0, 1.0)
    task.step(2.9, 1.0, 1.0)
    assert (task.phase, task.target, task.ahead, task.left) == ("ready", None, 0.0, 0.0)
    assert task.remaining == pytest.approx(0.1)
    rested = played(PLAN, lambda _: (0.0, 0.0))
    assert [one.acquired for one in rested.attempts] == [False] * 7  # 120 s of 15 s each, the last one cut by the end
    assert all(one.first_entry is None and one.way == 0.0 for one in rested.attempts)
    assert all(one.target.ahead or one.target.left for one in rested.attempts)  # after a miss, outward again


def test_after_a_missed_target_the_cursor_is_in_the_middle():
    task = CursorTask(PLAN)
    for t in clock(task):
        task.step(t, 1.0, 1.0)
        if task.attempts:
            break
    assert task.attempts[0].end == (1.0, 1.0)  # the edge of the cross keeps it
    assert (task.ahead, task.left) == (0.0, 0.0)


def test_a_cursor_that_leaves_the_target_must_dwell_anew():
    plan = CursorPlan(seed=1, ready=0.0, distances=(0.4,), time_limit=60.0)
    task = CursorTask(plan)
    task.step(0.0, 0.0, 0.0)
    ahead, left = task.target.direction
    t = 0.0

    def move(way, seconds):
        nonlocal t
        for _ in range(round(seconds / DT)):
            t += DT
            task.step(t, way * ahead / (DT * round(seconds / DT)), way * left / (DT * round(seconds / DT)))

    move(0.4, 1.0)  # to the middle of the target
    move(0.0, 0.5)
    assert task.inside == pytest.approx(0.5 + 0.25, abs=2 * DT)  # the edge was passed a quarter of the way before
    move(0.2, 0.5)  # beyond it
    assert (task.inside, task.acquired) == (0.0, 0)
    move(-0.2, 0.5)
    move(0.0, 1.0)
    attempt = task.attempts[0]
    assert (attempt.acquired, attempt.entries) == (True, 2)
    assert attempt.first_entry == pytest.approx(0.75, abs=DT)
    assert attempt.last_entry == pytest.approx(2.25, abs=DT)
    assert attempt.way == pytest.approx(0.4 + 0.2 + 0.1, abs=0.03)


@given(CONTROLS)
def test_whatever_the_hand_does_the_figures_fit_each_other(controls):
    plan = CursorPlan(seed=5, ready=0.0, duration=10.0, time_limit=2.0, dwell=0.2)
    hand = cycle(controls)
    task = played(plan, lambda _: next(hand))
    assert -1.0 <= min(task.ahead, task.left) <= max(task.ahead, task.left) <= 1.0
    assert task.remaining == 0.0
    for one in task.attempts:
        if one.last_entry is None:
            assert (one.entries, one.first_entry, one.acquired) == (0, None, False)
            continue
        assert one.entries >= 1
        assert 0.0 <= one.first_entry <= one.last_entry <= plan.time_limit + DT
        assert math.dist(one.start, one.entry) <= one.way + 1e-9


@given(CONTROLS, st.floats(0.11, 5.0))
def test_a_pause_between_ticks_moves_the_cursor_no_further_than_a_tenth_of_a_second(controls, pause):
    task = CursorTask(CursorPlan(seed=5, ready=0.0))
    t = 0.0
    task.step(t, 0.0, 0.0)
    for u1, u2 in controls[:5]:
        before = task.ahead, task.left
        missed = len(task.attempts)
        t += pause
        task.step(t, u1, u2)
        if len(task.attempts) == missed:
            assert math.dist(before, (task.ahead, task.left)) <= 0.1 * math.hypot(u1, u2) + 1e-9


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        *(("width", 0.0), ("width", float("nan")), ("duration", 0.5)),
        *(("speed", 11.0), ("dwell", "1"), ("distances", (1.5,))),
    ],
)
def test_a_plan_has_bounds(name, wrong):
    with pytest.raises(ValidationError):
        CursorPlan(seed=1, **{name: wrong})
