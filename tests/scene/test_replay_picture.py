"""The replay of a trial in 3D: shown at any time, forwards and backwards, and closed."""

import numpy as np
import pytest

from app.scene.replay import Replay, ReplayPoses
from app.scene.viewer_page import client_page
from app.world.scene import find_place

N = 200


@pytest.fixture
def poses():
    t = np.arange(N) / 20
    x = 0.5 * t
    nothing = np.full((N, 3), np.nan)
    return ReplayPoses(t, x, 0 * t, np.full(N, 3.1) + 0.01 * t, np.full(N, 0.5), t, nothing)


@pytest.fixture
def replay(poses):
    plan = find_place("follow_me.easy")
    shown = Replay(plan, plan.paths[0].name, poses)
    yield shown
    shown.stop()


def test_chair_movers_and_moment_are_those_of_one_moment_forwards_and_back(replay):
    view = replay._view
    places = {}
    for t in (2.0, 7.525, 2.0):
        replay.show(t, "chase")
        assert view._chair.position[0] == pytest.approx(0.5 * t)
        assert replay._moment.position[0] == pytest.approx(t)
        places.setdefault(t, []).append(tuple(view._movers[0].position))
    assert places[2.0][0] == places[2.0][1] != places[7.525][0]


def test_a_moment_beyond_the_ends_is_the_end_and_the_heading_takes_the_short_way(replay):
    replay.show(1e4, "top")
    assert replay._view._chair.position[0] == pytest.approx(0.5 * (N - 1) / 20)
    assert replay._view.view == "top"
    replay.show(-1e4, "eye")
    assert replay._view._chair.position[0] == 0.0
    assert not replay._view._bodies["body_0"].visible


def test_cones_stand_again_when_time_goes_back():
    plan = find_place("obstacles.easy")
    path = plan.paths[0]
    cone = plan.cones[0].position
    t = np.arange(N) / 20
    x = np.linspace(cone[0] - 2.0, cone[0] + 2.0, N)
    shown = Replay(plan, path.name, ReplayPoses(t, x, np.full(N, cone[1]), 0 * t, 0 * t, t, np.full((N, 3), np.nan)))
    try:
        shown.show(9.9, "chase")
        assert shown._state.cones.lying == 1
        shown.show(0.0, "chase")
        assert shown._state.cones.lying == 0
    finally:
        shown.stop()


def test_the_mark_stands_on_the_picture_itself():
    assert b'content: "Replay"' in client_page("Replay")
    assert b"body::after" not in client_page()
