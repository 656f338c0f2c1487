"""The progress of a trial, and its end."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.faults import Fault, State
from app.messages import TICK
from app.session.calibration.step_check import check_frames
from app.session.real_drive import DriveWatch
from app.session.run_watch import HALT_LIMIT
from app.session.trial import TrialWatch
from app.world.floorplan import FloorPlan, PrescribedPath

LINE = ((0.0, 0.0), (10.0, 0.0))


def watch_of(points=LINE, goal_radius=0.5, time_limit=600.0, task=None, movers=()):
    words = {"name": "main", "title": "Main", "instruction": "Go.", "goal_radius": goal_radius}
    asked = {} if task is None else {"task": task}
    path = PrescribedPath(points=points, time_limit=time_limit, **words, **asked)
    return TrialWatch(FloorPlan(name="p", title="P", walls=(), paths=(path,), movers=movers), path)


def ticks(t, x, y, state=State.ARMED):
    rows = np.zeros(len(np.atleast_1d(x)), TICK)
    rows["t"], rows["x"], rows["y"], rows["state"] = t, x, y, state
    return rows


def test_the_goal_ends_a_trial_and_the_area_is_that_beside_the_path():
    watch = watch_of(goal_radius=0.6, time_limit=60.0)
    x = np.linspace(0, 10, 201)
    assert watch.update(ticks(x, x, 0.5 + 0 * x)) == "goal"
    assert watch.place.done == pytest.approx(9.7, abs=0.1)
    assert watch.place.cross_track == pytest.approx(0.5)
    assert watch.place.e_diff == pytest.approx(0.5 * watch.place.done, rel=0.01)


def test_the_goal_counts_only_after_most_of_the_way():
    watch = watch_of(((0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 0.2)), goal_radius=0.6, time_limit=60.0)
    assert watch.update(ticks([0.0, 1.0], [0.0, 0.1], [0.0, 0.2])) is None


def test_time_runs_from_the_first_permitted_motion():
    watch = watch_of(time_limit=10.0)
    assert watch.update(ticks([100.0], [0.0], [0.0], State.CHECKING)) is None
    assert watch.update(ticks([120.0, 130.0], [0.0, 0.0], [0.0, 0.0])) is None
    assert watch.update(ticks([130.1], [0.0], [0.0])) == "time-out"


def test_the_clock_stands_while_motion_is_not_permitted():
    watch = watch_of(time_limit=10.0)
    for t, state in [(0.0, 2), (1.0, 2), (2.0, 3), (100.0, 3), (100.5, 0), (101.0, 1), (101.5, 2), (109.9, 2)]:
        assert watch.update(ticks([t], [0.0], [0.0], State(state))) is None
    assert watch.place.t == pytest.approx(1.0 + 0.5 + 8.4)


def test_pauses_are_counted_and_wait_as_long_as_a_halt():
    watch = watch_of(time_limit=10.0)

    def take(t, state, fault=Fault.NONE):
        rows = ticks([t], [0.0], [0.0], state)
        rows["fault"] = fault
        return watch.update(rows)

    assert take(0.0, State.DISARMED, Fault.SCREEN_SLOW) is None
    assert (watch.paused, watch.pauses) == (True, 0)  # the trial has not begun
    take(1.0, State.ARMED)
    for t in (2.0, 5.0):
        take(t, State.DISARMED, Fault.SCREEN_SLOW)
        assert watch.paused
        take(t + 1.0, State.DISARMED, Fault.SCREEN_SLOW)
        take(t + 2.0, State.CHECKING)
        assert not watch.paused
    assert watch.pauses == 2
    assert watch.place.t == 0.0
    assert take(10.0, State.DISARMED, Fault.SCREEN_LOST) is None
    assert take(309.9, State.DISARMED, Fault.SCREEN_LOST) is None
    assert watch.halt.remaining == pytest.approx(0.1)
    assert take(310.0, State.DISARMED, Fault.SCREEN_LOST) == "fault"


@pytest.mark.parametrize("watch", [watch_of(), DriveWatch()], ids=["trial", "drive"])
def test_a_stop_halts_for_five_minutes_says_so_and_then_ends_it(watch):
    assert HALT_LIMIT >= 180.0
    assert watch.update(ticks([0.0], [0.0], [0.0])) is None
    assert watch.halt.remaining is None
    assert watch.update(ticks([1.0, 60.0], [0.0, 0.0], [0.0, 0.0], State.FAULT)) is None
    assert watch.halt.remaining == 241.0
    assert watch.update(ticks([300.9], [0.0], [0.0], State.FAULT)) is None
    assert watch.update(ticks([301.0], [0.0], [0.0], State.CHECKING)) is None  # a person went on
    assert watch.halt.remaining is None
    assert watch.update(ticks([302.0, 601.9], [0.0, 0.0], [0.0, 0.0], State.FAULT)) is None
    assert watch.halt.remaining == pytest.approx(0.1)
    assert watch.update(ticks([602.0], [0.0], [0.0], State.FAULT)) == "fault"


def test_a_halt_before_the_first_motion_waits_as_long():
    watch = watch_of(time_limit=10.0)
    assert watch.update(ticks([0.0, 200.0], [0.0, 0.0], [0.0, 0.0], State.FAULT)) is None
    assert watch.update(ticks([300.0], [0.0], [0.0], State.FAULT)) == "fault"


def test_neither_the_time_limit_nor_the_goal_ends_a_trial_that_is_halted():
    watch = watch_of(goal_radius=0.6, time_limit=60.0)
    x = np.linspace(0, 9.3, 201)
    assert watch.update(ticks(5 * x, x, 0 * x)) is None
    assert watch.update(ticks([47.0, 147.0], [9.4, 9.4], [0.0, 0.0], State.FAULT)) is None
    assert watch.update(ticks([148.0], [9.4], [0.0], State.CHECKING)) == "goal"  # a person went on


def test_what_was_halted_is_no_part_of_the_time_limit():
    watch = watch_of(time_limit=60.0)
    assert watch.update(ticks([0.0, 10.0], [0.0, 0.0], [0.0, 0.0])) is None
    for begin in (20.0, 130.0):
        assert watch.update(ticks([begin, begin + 100.0], [0.0, 0.0], [0.0, 0.0], State.FAULT)) is None
        assert watch.update(ticks([begin + 101.0], [0.0], [0.0])) is None
    assert watch.update(ticks([279.0], [0.0], [0.0])) is None  # 60 s of its own
    assert watch.update(ticks([279.1], [0.0], [0.0])) == "time-out"


@given(st.lists(st.tuples(st.floats(-50, 50), st.floats(-50, 50)), min_size=1, max_size=60))
def test_whatever_is_driven_the_place_stays_on_the_path_and_the_area_never_falls(points):
    watch = watch_of()
    area = 0.0
    for number, (x, y) in enumerate(points):
        if watch.update(ticks([float(number)], [x], [y])) is not None:
            break
        assert 0.0 <= watch.place.done <= 10.0
        assert watch.place.e_diff >= area
        area = watch.place.e_diff


def test_a_leader_is_seen_where_the_scene_s_time_puts_him():
    guide = {"name": "guide", "kind": "person", "points": ((2.0, 0.0), (10.0, 0.0)), "pace": ((0.0, 0.5),)}
    watch = watch_of(task={"kind": "follow", "leader": "guide"}, movers=(guide,))
    rows = ticks([0.0, 4.0], [0.0, 1.0], [0.0, 0.0])
    rows["scene_t"] = [0.0, 4.0]
    assert watch.update(rows) is None
    assert watch.place.leader == (4.0, 0.0, 0.0)
    assert watch.place.leader_distance == pytest.approx(3.0)


def test_the_stages_of_a_course_are_gone_through_one_after_the_other():
    stages = [
        {"title": "Ahead", "instruction": "Go.", "points": ((0.0, 0.0), (3.0, 0.0))},
        {"title": "On", "instruction": "Go on.", "points": ((3.0, 0.0), (6.0, 0.0))},
    ]
    watch = watch_of(task={"kind": "course", "stages": stages})
    x = np.linspace(0, 3, 31)
    assert watch.update(ticks(x, x, 0 * x)) is None
    assert (watch.place.stage, watch.progress.part.title) == (1, "On")
    assert watch.update(ticks(x + 3, x + 3, 0 * x)) == "goal"
    assert watch.place.e_diff == 0.0


def test_a_whole_recording_does_and_a_gap_or_a_thin_one_is_said_in_words():
    t = np.arange(0, 5, 0.01)
    assert check_frames(t, 5.0, 100.0) is None
    assert "silent for 0.4 seconds" in str(check_frames(t[(t < 2.0) | (t > 2.4)], 5.0, 100.0))
    assert "Only 50 %" in str(check_frames(t[::2], 5.0, 100.0))
    assert "Only 0 %" in str(check_frames(np.empty(0), 5.0, 100.0))
    assert "silent" in str(check_frames(t[t < 4.7], 5.0, 100.0))
