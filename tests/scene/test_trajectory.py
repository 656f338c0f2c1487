"""The driven line and the plots of the error: points are kept every few centimetres, sizes stay bounded."""

import math

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose
from app.scene.plots import ERROR_SHOWN, MOST_POINTS, ErrorSamples, PlotSeries, trajectory_ranges, trajectory_samples
from app.scene.role_servers import quiet_server
from app.scene.trajectory import JUMP, PIECE, STEP, PointFilter, TrajectoryLine, TrajectoryPieces, line_segments
from app.world.path import Path


def test_a_chair_that_stands_adds_one_point():
    pieces = TrajectoryPieces()
    assert [pieces.add(Pose(1.0, 2.0, 0.0), 0.1 * number) for number in range(100)] == [True] + [False] * 99


def test_points_are_kept_every_five_centimetres_or_five_degrees():
    point_filter = PointFilter()
    assert point_filter.keep(Pose(0, 0, 0))
    assert not point_filter.keep(Pose(0.049, 0, 0))
    assert point_filter.keep(Pose(0.051, 0, 0))
    assert not point_filter.keep(Pose(0.051, 0, math.radians(4.9)))
    assert point_filter.keep(Pose(0.051, 0, math.radians(5.1)))


def test_the_heading_may_pass_half_a_turn():
    point_filter = PointFilter()
    point_filter.keep(Pose(0, 0, math.pi - 0.01))
    assert not point_filter.keep(Pose(0, 0, -math.pi + 0.01))


def test_pieces_are_closed_at_their_length_and_join_without_a_gap():
    pieces = TrajectoryPieces()
    for number in range(3 * PIECE):
        pieces.add(Pose(0.06 * number, 0.0, 0.0), 0.1 * number)
    assert [len(piece) for piece in pieces.points[:-1]] == [PIECE] * (len(pieces.points) - 1)
    assert len(pieces.points) == 4
    for before, after in zip(pieces.points[:-1], pieces.points[1:], strict=True):
        assert before[-1] == after[0]


@pytest.mark.parametrize(("pause", "points"), [(0.1, [[(0, 0)], [(2 * JUMP, 0)]]), (1.5, [[(0, 0), (2 * JUMP, 0)]])])
def test_a_chair_that_is_put_elsewhere_has_not_driven_there_and_one_without_poses_for_a_while_has(pause, points):
    pieces = TrajectoryPieces()
    pieces.add(Pose(0, 0, 0), 0.0)
    pieces.add(Pose(2 * JUMP, 0, 0), pause)
    assert pieces.points == points


@given(st.lists(st.tuples(st.floats(-0.4, 0.4), st.floats(-0.4, 0.4)), max_size=200))
def test_no_driven_place_is_farther_than_a_step_from_a_kept_point(moves):
    pieces, x, y = TrajectoryPieces(), 0.0, 0.0
    for dx, dy in [(0.0, 0.0), *moves]:
        x, y = x + dx, y + dy
        pieces.add(Pose(x, y, 0.0), 0.0)
        kept = np.array(pieces.points[-1][-1])
        assert np.hypot(*(kept - (x, y))) < STEP or pieces.points[-1][-1] == (x, y)


def test_segments_join_neighbouring_points():
    segments = line_segments([(0, 0), (1, 0), (1, 2)])
    assert segments.shape == (2, 2, 3)
    assert segments[0, 1] == pytest.approx(segments[1, 0])
    assert line_segments([(0, 0)]).shape == (0, 2, 3)
    assert line_segments([]).shape == (0, 2, 3)


def bytes_sent(server, trajectory, steps):
    """Bytes of the messages that a server would send for these steps, flushed after each."""
    sent, count = 0, 0
    queue = server._websock_server.queue_message

    def counted(message):
        nonlocal sent, count
        sent, count = sent + len(msgspec.msgpack.encode(message.as_serializable_dict(), enc_hook=bytes)), count + 1
        queue(message)

    server._websock_server.queue_message = counted
    for number in steps:
        trajectory.add(Pose(0.06 * number, 0.0, 0.0), 0.25 * number)
    server._websock_server.queue_message = queue
    return sent, count


def test_an_update_of_a_long_trajectory_sends_no_more_than_one_of_a_short():
    server = quiet_server()
    try:
        trajectory = TrajectoryLine(server)
        short = bytes_sent(server, trajectory, range(PIECE))
        bytes_sent(server, trajectory, range(PIECE, 20_000 - PIECE))
        long = bytes_sent(server, trajectory, range(20_000 - PIECE, 20_000))
    finally:
        server.stop()
    assert short[0] > 100_000
    assert long[0] <= 1.05 * short[0]
    assert long[1] <= short[1] + 5


CORNER = Path([(0, 0), (10, 0), (10, 5), (0, 5)])


def test_the_error_is_signed_and_the_newest_is_at_zero_seconds():
    driven = PlotSeries(CORNER)
    for step in range(50):
        driven.add(Pose(0.05 * step, 0.2, 0.0), 0.1 * step + 0.05)
    before_now, zero, error = driven.error.plotted()
    assert before_now[[0, -1]] == pytest.approx([-30.0, 0.0])
    assert 300 <= len(before_now) <= 600
    assert not zero.any()
    assert error[-40:] == pytest.approx(0.2)
    assert np.isnan(error[:200]).all()


def test_old_errors_leave_and_silence_leaves_a_gap():
    samples = ErrorSamples()
    samples.add(0.05, 0.3)
    samples.add(10.05, -0.4)
    error = samples.plotted()[2]
    assert error[-1] == -0.4
    assert error[-101] == 0.3
    assert np.isfinite(error).sum() == 2
    samples.add(100.05, 5.0)
    assert samples.plotted()[2][-1] == ERROR_SHOWN
    assert np.isfinite(samples.plotted()[2]).sum() == 1


def test_a_crossing_of_the_path_is_not_mistaken_for_where_the_chair_is():
    line = Path([(0, 0), (6, 0), (6, 3), (3, 3), (3, -3)])  # crosses itself at (3, 0)
    driven = PlotSeries(line)
    for step in range(60):
        driven.add(Pose(0.05 * step + 0.02, 0.1, 0.0), 0.1 * step + 0.05)
    assert driven.error.plotted()[2][-1] == pytest.approx(0.1)


def test_the_trajectory_stays_bounded_and_keeps_both_ends():
    driven = PlotSeries(None)
    for step in range(5000):
        driven.add(Pose(0.06 * step, 0.0, 0.0), 0.1 * step)
    assert len(driven.points) <= MOST_POINTS
    assert driven.points[0] == (0.0, 0.0)
    assert driven.points[-1] == (0.06 * 4999, 0.0)


def test_a_chair_that_is_put_elsewhere_begins_anew():
    driven = PlotSeries(CORNER)
    driven.add(Pose(0, 0, 0), 0.0)
    driven.add(Pose(10, 5, 0), 0.1)
    assert driven.points == [(10, 5)]
    assert np.isfinite(driven.error.plotted()[2]).sum() == 1


def test_path_and_trajectory_share_one_row_of_x_that_lies_inside_the_range():
    x_range, y_range = trajectory_ranges(CORNER, 2.2)
    assert (x_range[1] - x_range[0]) / (y_range[1] - y_range[0]) == pytest.approx(2.2)
    x, prescribed, actual = trajectory_samples(CORNER, [(1.0, 1.0), (99.0, 2.0)], x_range)
    assert len(x) == len(prescribed) == len(actual) == 6
    assert x_range[0] < x.min()
    assert x.max() < x_range[1]
    assert np.isnan(prescribed[4:]).all()
    assert np.isnan(actual[:4]).all()
    assert actual[4:] == pytest.approx([1.0, 2.0])
