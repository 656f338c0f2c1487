"""When a trial is over, and what is seen of it meanwhile."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.faults import State
from app.messages import TICK
from app.session.calibration_judge import judge_frames
from app.session.trial_watch import TrialWatch
from app.world.path import Path

LINE = Path([(0.0, 0.0), (10.0, 0.0)])


def ticks(t, x, y, state=State.ARMED):
    rows = np.zeros(len(np.atleast_1d(x)), TICK)
    rows["t"], rows["x"], rows["y"], rows["state"] = t, x, y, state
    return rows


def test_the_goal_ends_a_trial_and_the_area_is_that_beside_the_path():
    watch = TrialWatch(LINE, goal_radius=0.6, time_limit=60.0)
    x = np.linspace(0, 10, 201)
    assert watch.take(ticks(x, x, 0.5 + 0 * x)) == "goal"
    assert watch.place.done == pytest.approx(9.7, abs=0.1)
    assert watch.place.cross_track == pytest.approx(0.5)
    assert watch.place.e_diff == pytest.approx(0.5 * watch.place.done, rel=0.01)


def test_the_goal_counts_only_after_most_of_the_way():
    loop = Path([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 0.2)])
    watch = TrialWatch(loop, goal_radius=0.6, time_limit=60.0)
    assert watch.take(ticks([0.0, 1.0], [0.0, 0.1], [0.0, 0.2])) is None


def test_time_runs_from_the_first_permitted_motion():
    watch = TrialWatch(LINE, goal_radius=0.5, time_limit=10.0)
    assert watch.take(ticks([100.0], [0.0], [0.0], State.CHECKING)) is None
    assert watch.take(ticks([120.0, 130.0], [0.0, 0.0], [0.0, 0.0])) is None
    assert watch.take(ticks([130.1], [0.0], [0.0])) == "time-out"


def test_a_stop_pauses_for_twenty_seconds_then_ends():
    watch = TrialWatch(LINE, goal_radius=0.5, time_limit=600.0)
    assert watch.take(ticks([0.0], [0.0], [0.0])) is None
    assert watch.take(ticks([1.0, 20.9], [0.0, 0.0], [0.0, 0.0], State.FAULT)) is None
    assert watch.take(ticks([21.0], [0.0], [0.0], State.CHECKING)) is None
    assert watch.take(ticks([22.0, 41.9], [0.0, 0.0], [0.0, 0.0], State.FAULT)) is None
    assert watch.take(ticks([42.0], [0.0], [0.0], State.FAULT)) == "fault"


@given(st.lists(st.tuples(st.floats(-50, 50), st.floats(-50, 50)), min_size=1, max_size=60))
def test_whatever_is_driven_the_place_stays_on_the_path_and_the_area_never_falls(points):
    watch = TrialWatch(LINE, goal_radius=0.5, time_limit=600.0)
    area = 0.0
    for number, (x, y) in enumerate(points):
        if watch.take(ticks([float(number)], [x], [y])) is not None:
            break
        assert 0.0 <= watch.place.done <= LINE.length
        assert watch.place.e_diff >= area
        area = watch.place.e_diff


def test_a_whole_recording_does():
    assert judge_frames(np.arange(0, 5, 0.01), 5.0, 100.0) is None


def test_a_gap_and_a_thin_recording_are_said_in_words():
    t = np.arange(0, 5, 0.01)
    assert "silent for 0.4 seconds" in judge_frames(t[(t < 2.0) | (t > 2.4)], 5.0, 100.0)
    assert "Only 50 %" in judge_frames(t[::2], 5.0, 100.0)
    assert "Only 0 %" in judge_frames(np.empty(0), 5.0, 100.0)
    assert "silent" in judge_frames(t[t < 4.7], 5.0, 100.0)
