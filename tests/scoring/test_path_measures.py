import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.scoring.path_measures import area_between, log_dimensionless_jerk, path_measures, sparc, winding_numbers

STRAIGHT = [(0.0, 0.0), (10.0, 0.0)]
X = np.linspace(0, 10, 1001)

place = st.floats(-5, 5).map(lambda value: round(value, 3))
line = st.lists(st.tuples(place, place), min_size=2, max_size=12).map(lambda points: np.array(points, dtype=float))


def score(points, path=STRAIGHT, dt=0.01, **given):
    points = np.asarray(points, dtype=float)
    return path_measures(np.arange(len(points)) * dt, points[:, 0], points[:, 1], path, **given)


def circle_on_the_way(radius=1.0, n=2000):
    angle = np.linspace(0, 2 * np.pi, n)
    before, after = np.linspace([0, 0], [5, 0], 200), np.linspace([5, 0], [10, 0], 200)
    return np.vstack([before, np.c_[5 + radius * np.sin(angle), radius * (1 - np.cos(angle))], after])


# E_diff


@pytest.mark.parametrize(
    ("driven", "area"),
    [
        (np.c_[X, np.full_like(X, 0.5)], 5.0),
        (np.c_[X, np.sin(2 * X)], 6.295),
        (circle_on_the_way(), 3.14),
        (np.c_[X, np.zeros_like(X)], 0.0),
    ],
)
def test_e_diff_has_the_figures_of_its_definition(driven, area):
    assert score(driven)["e_diff"] == pytest.approx(area, abs=2e-3)


def test_a_loop_driven_twice_counts_twice():
    once, twice = circle_on_the_way(), circle_on_the_way()
    twice = np.vstack([twice[:2200], twice[200:]])
    assert area_between(twice, np.array(STRAIGHT)) == pytest.approx(
        2 * area_between(once, np.array(STRAIGHT)), rel=1e-3
    )


def test_areas_left_and_right_do_not_cancel():
    assert area_between(np.array([(0, 0), (0, 1), (5, 1), (5, -1), (10, -1), (10, 0)]), np.array(STRAIGHT)) == 10


@given(line, line)
def test_e_diff_backwards_is_the_same(driven, path):
    assert area_between(driven[::-1], path[::-1]) == pytest.approx(area_between(driven, path), abs=1e-4)
    assert area_between(path, driven) == pytest.approx(area_between(driven, path), abs=1e-4)


@given(line, line, st.floats(-100, 100), st.floats(-100, 100), st.floats(-math.pi, math.pi))
def test_e_diff_does_not_depend_on_where_the_origin_is(driven, path, dx, dy, angle):
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    moved = area_between(driven @ turn.T + (dx, dy), path @ turn.T + (dx, dy))
    assert moved == pytest.approx(area_between(driven, path), abs=1e-4)


@given(line)
def test_the_path_itself_leaves_no_area(path):
    assert area_between(path, path) == pytest.approx(0, abs=1e-5)
    halfway = np.repeat(path, 3, axis=0)
    halfway[1:-1:3] = (halfway[0:-2:3] + halfway[2::3]) / 2  # the same line with more points, some of them twice
    assert area_between(halfway, path) == pytest.approx(0, abs=1e-5)


def test_simplifying_stays_within_its_tolerance():
    generator = np.random.default_rng(3)
    s = np.linspace(0, 10, 12_000)
    driven = np.c_[s, 0.4 * np.sin(s) + 0.1 * np.sin(7 * s) + 0.5] + 1e-5 * generator.normal(size=(len(s), 2))
    exact = np.sum((driven[1:, 1] + driven[:-1, 1]) / 2 * np.diff(driven[:, 0]))
    assert np.all(driven[:, 1] > 0)  # on one side all the way, so that the trapezium rule is exact
    assert area_between(driven, np.array(STRAIGHT)) == pytest.approx(exact, abs=1e-4 * 20)


@given(st.integers(-3, 3).filter(bool), st.floats(0.1, 3), st.floats(-0.05, 0.05), st.floats(-0.05, 0.05))
def test_winding_numbers_of_circles(turns, radius, x, y):
    angle = np.linspace(0, 2 * np.pi * turns, 60 * abs(turns) + 1)
    ring = radius * np.c_[np.cos(angle), np.sin(angle)]
    ring[-1] = ring[0]
    assert winding_numbers(ring, np.array([(x, y), (4.0, 0.0)])).tolist() == [turns, 0]


# Dist, cross-track, time, goal


def test_a_straight_drive_beside_the_path():
    measures = score(np.c_[X, np.full_like(X, -0.5)], dt=0.02)
    assert measures["dist"] == pytest.approx(10)
    assert measures["path_length"] == 10
    assert measures["dist_ratio"] == pytest.approx(1)
    assert measures["cross_track_rms"] == pytest.approx(0.5)
    assert measures["cross_track_max"] == pytest.approx(0.5)
    assert measures["cross_track_mean"] == pytest.approx(-0.5)  # right of the path
    assert measures["time"] == pytest.approx(20)
    assert measures["mean_speed"] == pytest.approx(0.5)
    assert measures["stops"] == 0
    assert measures["reached"] is True


def test_rows_after_the_goal_do_not_count():
    driven = np.vstack([np.linspace([0, 0.3], [10, 0.3], 1001), np.linspace([10, 0.3], [30, 25], 3000)])
    measures = score(driven)
    assert measures["reached"] is True
    assert measures["dist"] == pytest.approx(10, abs=0.3)
    assert measures["time"] == pytest.approx(10, abs=0.3)
    assert measures["e_diff"] == pytest.approx(3, abs=0.2)


@pytest.mark.parametrize(("end", "reached"), [(9.501, True), (9.4, False)])
def test_a_trial_that_ended_at_the_goals_edge_is_reached_and_one_before_it_is_not(end, reached):
    measures = score(np.linspace([0, 0], [end, 0], 900))
    assert measures["reached"] is reached
    assert measures["dist"] == pytest.approx(end)


def test_few_rows_are_cut_between_them():
    measures = score([(0, 0), (20, 0)], dt=10)
    assert measures["reached"] is True
    assert (measures["dist"], measures["time"]) == pytest.approx((10, 5))


def test_a_closed_path_is_not_done_at_its_start():
    round_trip = [(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0), (0.0, 0.0)]
    whole = np.vstack([np.linspace(a, b, 300) for a, b in pairwise(round_trip)])
    measures = score(whole, path=round_trip)
    assert measures["reached"] is True
    assert measures["dist"] == pytest.approx(20)
    assert measures["e_diff"] == pytest.approx(0, abs=1e-6)
    assert score(whole[:290], path=round_trip)["reached"] is False
    assert score(np.zeros((50, 2)), path=round_trip)["reached"] is False


@pytest.mark.parametrize("rows", [1, 2])
def test_a_trajectory_of_one_or_two_rows(rows):
    measures = score([(1.0, 1.0)] * rows)
    assert measures["dist"] == 0
    assert measures["reached"] is False
    assert measures["sparc"] is None
    assert measures["ldlj"] is None
    assert measures["stops"] == 0


def test_standing_still_and_repeated_rows():
    driven = np.vstack([np.zeros((300, 2)), np.c_[X, np.zeros_like(X)], [(10, 0)] * 200])
    measures = score(driven)
    assert measures["dist"] == pytest.approx(10)
    assert measures["reached"] is True
    assert measures["stops"] == 0  # neither waiting for the start nor having arrived is a stop
    twice = path_measures(np.repeat(np.arange(1001), 2) * 0.01, np.repeat(X, 2), np.zeros(2002), STRAIGHT)
    assert twice["dist"] == pytest.approx(10)


def test_stops_are_counted_between_movements():
    waits = [
        (0, 200),
        (3, 100),
        (6, 20),
        (7, 100),
    ]  # at x (m), for rows of 10 ms: three of half a second, one at the start
    pieces, x = [], 0.0
    for at, rows in [*waits, (10, 100)]:
        if at > x:
            pieces.append(np.linspace(x, at, int((at - x) * 100)))
        pieces.append(np.full(rows, float(at)))
        x = at
    x_all = np.concatenate(pieces)
    assert score(np.c_[x_all, np.zeros_like(x_all)])["stops"] == 2


def test_contacts_and_commands():
    t = np.arange(1000)
    touching = ((t > 100) & (t < 200)) | ((t > 210) & (t < 260)) | ((t > 400) & (t < 450))
    u1 = ((t % 200) < 50).astype(float)
    u2 = np.where(t < 500, 0.5, -0.5) * ((t % 100) < 50)
    measures = score(
        np.c_[np.linspace(0, 10, 1000), np.zeros(1000)], in_contact=touching, u1=u1, u2=u2, contacts=t // 334
    )
    assert measures["collisions"] == 2  # as the chair counted them
    assert measures["contact_time"] == pytest.approx(1.97)
    assert measures["turn_reversals"] == 1
    assert measures["pulses_per_metre"] == pytest.approx((5 + 10) / 10)
    counted = score(np.c_[np.linspace(0, 10, 1000), np.zeros(1000)], in_contact=touching)
    assert counted["collisions"] == 2  # 0.1 s apart is the same contact, 1.4 s is a new one
    assert "turn_reversals" not in counted


def test_a_trembling_control_is_one_pulse():
    u2 = 0.3 + 0.04 * np.sin(np.arange(1000))
    u2[500:520] = 0.07  # between OFF and ON: the pulse goes on
    measures = score(np.c_[np.linspace(0, 10, 1000), np.zeros(1000)], u2=u2)
    assert measures["pulses_per_metre"] == pytest.approx(0.1)
    assert measures["turn_reversals"] == 0


@pytest.mark.parametrize(
    ("t", "x", "y", "extra", "words"),
    [
        ([], [], [], {}, "no rows"),
        ([0, 1], [0], [0, 0], {}, "x has 1 rows and t has 2"),
        ([0, 1], [0, math.nan], [0, 0], {}, "x has no finite number in row 2"),
        ([0, math.inf], [0, 1], [0, 0], {}, "t has no finite number in row 2"),
        ([0, 2, 1], [0, 1, 2], [0, 0, 0], {}, "t goes backwards in row 3"),
        ([0, 1], [0, 1], [0, 0], {"u1": [0]}, "u1 has 1 rows"),
    ],
)
def test_bad_input_is_named(t, x, y, extra, words):
    with pytest.raises(ValueError, match=words):
        path_measures(t, x, y, STRAIGHT, **extra)


@given(st.lists(st.tuples(place, place), min_size=1, max_size=40), line.filter(lambda p: np.ptp(p, axis=0).max() > 0.1))
@settings(max_examples=50, deadline=None)
def test_any_trajectory_has_measures(driven, path):
    measures = score(driven, path=path)
    assert all(value is None or math.isfinite(value) for value in measures.values())
    assert measures["dist"] >= 0
    assert measures["cross_track_rms"] <= measures["cross_track_max"] + 1e-12


# Smoothness

BELL = np.exp(-5 * np.arange(-1, 1, 0.01) ** 2)


def test_smoothness_has_the_published_figures():
    assert sparc(BELL, 100.0) == pytest.approx(-1.41403, abs=5e-6)
    assert log_dimensionless_jerk(BELL, 100.0) == pytest.approx(-5.81636, abs=5e-6)


@given(st.floats(0.01, 100))
def test_smoothness_does_not_depend_on_size(scale):
    assert sparc(scale * BELL, 100.0) == pytest.approx(sparc(BELL, 100.0))
    assert log_dimensionless_jerk(scale * BELL, 100.0) == pytest.approx(log_dimensionless_jerk(BELL, 100.0))


def test_two_movements_are_less_smooth_than_one():
    two = np.concatenate([BELL, BELL])
    assert sparc(two, 100.0) < sparc(BELL, 100.0)
    assert log_dimensionless_jerk(two, 100.0) < log_dimensionless_jerk(BELL, 100.0)


@pytest.mark.parametrize("speed", [np.zeros(0), np.zeros(1), np.zeros(100)])
def test_without_movement_there_is_no_smoothness(speed):
    assert sparc(speed, 100.0) is None
    assert log_dimensionless_jerk(speed, 100.0) is None


def test_a_constant_speed_has_no_jerk():
    assert score(np.c_[X, np.zeros_like(X)])["ldlj"] is None
