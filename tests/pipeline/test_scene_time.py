"""The scene's time in the loop: it goes on while the chair is armed, and what it moves is before the body's eyes."""

import pytest
from office import Office

from app.faults import State
from app.hardware.base import BodyView, LeaderView
from app.world.scenery import Track

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
def office():
    made = Office()
    yield made
    made.close()


def newest(office) -> tuple[State, float]:
    tick = office.ring.newest()
    return State(int(tick["state"])), float(tick["scene_t"])


def test_it_counts_armed_time_and_begins_anew_with_each_drive(office, tmp_path):
    office.done("world", floorplan=WORLD, path="alone")
    office.live(0.5)
    assert newest(office) == (State.DISARMED, 0.0)
    office.done("run", run_id="one", folder=str(tmp_path / "one"), kind="drive")
    office.done("arm", hash=office.parameters.hash)
    office.live(3.0)
    ticks = office.ring.since(0)[0]
    armed = ticks[ticks["state"] == int(State.ARMED)]
    assert ticks["scene_t"][ticks["state"] != int(State.ARMED)].max() == 0.0, "not while it is checked"
    assert armed["scene_t"][-1] == pytest.approx(armed["t"][-1] - armed["t"][0] + 0.01, abs=1e-6)
    office.done("stop", by="tablet")
    office.live(0.5)
    state, held = newest(office)
    assert state is State.FAULT
    assert held == pytest.approx(float(armed["scene_t"][-1]), abs=0.011)
    office.live(0.5)
    assert newest(office)[1] == held
    office.tell("end_run")
    office.done("run", run_id="two", folder=str(tmp_path / "two"), kind="drive")
    office.live(0.05)
    assert newest(office)[1] == 0.0


def test_whom_to_follow_is_before_the_body_s_eyes(office):
    view = BodyView()
    office.setup.simulated_shirt = type("SimulatedShirt", (), {"view": view, "body": None})()
    office.done("world", floorplan=WORLD, path="behind")
    office.live(0.1)
    track = Track(office.setup.floorplan.mover_named("anna"))
    assert view.leader == LeaderView(*track.at(0.0))
    office.setup.chair.state.scene_t = 3.0
    office.live(0.05)
    assert view.leader == LeaderView(*track.at(3.0))
    office.done("world", floorplan=WORLD, path="alone")
    office.live(0.05)
    assert view.leader is None
