"""The scene's time in the loop: it runs while the chair is armed, and the body sees what it moves."""

import pytest
from pipeline.commanded_loop import CommandedLoop

from app.faults import State
from app.hardware.base import BodyView, LeaderView
from app.world.movers import Track

WORLD = {
    "name": "p",
    "title": "P",
    "walls": [],
    "movers": [{"name": "anna", "kind": "person", "points": [[2, 0], [6, 0]], "pace": [[0, 0.5]]}],
    "paths": [
        {
            "name": "behind",
            "title": "Behind her",
            "points": [[0, 0], [6, 0]],
            "instruction": "Go.",
            "task": {"kind": "follow", "leader": "anna"},
        },
        {"name": "alone", "title": "Alone", "points": [[0, 0], [0, 6]], "instruction": "Go."},
    ],
}


@pytest.fixture
def control():
    made = CommandedLoop()
    yield made
    made.close()


def newest(control) -> tuple[State, float]:
    tick = control.ring.newest()
    return State(int(tick["state"])), float(tick["scene_t"])


def test_it_counts_armed_time_and_begins_anew_with_each_drive(control, tmp_path):
    control.done("world", floorplan=WORLD, path="alone")
    control.live(0.5)
    assert newest(control) == (State.DISARMED, 0.0)
    control.done("run", run_id="one", folder=str(tmp_path / "one"), kind="drive")
    control.done("arm", hash=control.parameters.hash)
    control.live(3.0)
    ticks = control.ring.since(0)[0]
    armed = ticks[ticks["state"] == int(State.ARMED)]
    assert ticks["scene_t"][ticks["state"] != int(State.ARMED)].max() == 0.0, "not while it is checked"
    assert armed["scene_t"][-1] == pytest.approx(armed["t"][-1] - armed["t"][0] + 0.01, abs=1e-6)
    control.done("stop", by="tablet")
    control.live(0.5)
    state, held = newest(control)
    assert state is State.FAULT
    assert held == pytest.approx(float(armed["scene_t"][-1]), abs=0.011)
    control.live(0.5)
    assert newest(control)[1] == held
    control.notify("end_run")
    control.done("run", run_id="two", folder=str(tmp_path / "two"), kind="drive")
    control.live(0.05)
    assert newest(control)[1] == 0.0


def test_whom_to_follow_is_before_the_body_s_eyes(control):
    view = BodyView()
    control.setup.simulated_shirt = type("SimulatedShirt", (), {"view": view, "body": None})()
    control.done("world", floorplan=WORLD, path="behind")
    control.live(0.1)
    track = Track(control.setup.floorplan.mover_named("anna"))
    assert view.leader == LeaderView(*track.at(0.0))
    control.setup.chair.state.scene_t = 3.0
    control.live(0.05)
    assert view.leader == LeaderView(*track.at(3.0))
    control.done("world", floorplan=WORLD, path="alone")
    control.live(0.05)
    assert view.leader is None
