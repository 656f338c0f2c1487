"""The driven line and the plots of the error: points are kept every few centimetres, sizes stay bounded."""

import math

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose
from app.scene.role_servers import quiet_server
from app.scene.trajectory import JUMP, PIECE, STEP, PointFilter, TrajectoryLine, TrajectoryPieces, line_segments


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
