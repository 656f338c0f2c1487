"""A run of the interface test in the control process: no chair is armed, and the recording gives the same figures."""

from types import SimpleNamespace

import pytest
from pipeline.commanded_loop import CommandedLoop

from app.faults import State
from app.features.interface_tests.service import measure_interface_test
from app.hardware.base import BodyView
from app.recording.reader import read_run
from app.scoring.interface_test.interface_measures import replay_task
from app.world.cursor_task import CursorPlan
from building import make_signals

PLAN = CursorPlan(seed=4, ready=0.5, duration=8.0, time_limit=7.0, dwell=0.1, width=0.9, distances=(0.5,))


@pytest.fixture
def control():
    made = CommandedLoop()
    strokes = make_signals(made.parameters, 2000, seed=2)
    made.setup.shirt = type(made.setup.shirt)(
        made.clock, [i / 100 for i in range(2000)], strokes, layout=made.parameters.profile.layout
    )
    made.eyes = BodyView()
    made.setup.simulated_shirt = SimpleNamespace(view=made.eyes, body=None)
    yield made
    made.close()


def asked(tmp_path, **more):
    fields = {"run_id": "r", "folder": str(tmp_path / "r"), "kind": "interface_test", "cues": [], "meta": {}}
    return {**fields, "test": PLAN.model_dump(mode="json"), **more}


def test_no_chair_is_armed_during_the_test_and_nothing_moves(control, tmp_path):
    control.done("run", **asked(tmp_path))
    control.live(1.0)
    assert "two-minute test is running" in control.refused("arm", hash=control.setup.hash)
    control.live(4.0)
    tick = control.ring.newest()
    assert (int(tick["state"]), float(tick["v"]), float(tick["omega"])) == (State.DISARMED, 0.0, 0.0)
    task = control.loop.run.task
    assert abs(task.ahead) + abs(task.left) > 0.1  # the strokes move the cursor
    assert max(abs(task.ahead), abs(task.left)) <= 1.0
    control.notify("stop")
    control.live(0.1)
    assert int(control.ring.newest()["state"]) == State.FAULT


def test_the_recording_gives_the_figures_that_were_seen(control, tmp_path):
    control.done("run", **asked(tmp_path))
    control.live(9.0)
    task = control.loop.run.task
    assert task.phase == "over"
    control.done("end_run")
    run = read_run(tmp_path / "r")
    assert run.meta["interface_test"] == PLAN.model_dump(mode="json")
    plan = CursorPlan.model_validate(run.meta["interface_test"])
    again = replay_task(plan, *(run.columns[name] for name in ("run_t", "u1", "u2")))
    assert again.attempts == task.attempts
    assert any(one.entries for one in again.attempts)
    measures = measure_interface_test(tmp_path / "r", PLAN)
    assert (measures["complete"], measures["acquired"]) == (True, task.acquired)
    assert measures["acquired"] + measures["missed"] == len(task.attempts)


def test_a_run_of_the_test_and_no_other_has_its_plan(control, tmp_path):
    assert "plan of a test" in control.refused("run", **asked(tmp_path, test=None))
    assert "plan of a test" in control.refused("run", **asked(tmp_path, kind="drive"))
    wide = PLAN.model_dump(mode="json") | {"width": 2.0}
    assert "width" in control.refused("run", **asked(tmp_path, test=wide))
    assert not (tmp_path / "r").exists()


def test_a_simulated_body_sees_cursor_and_target_only_during_the_test(control, tmp_path):
    eyes = control.eyes
    control.live(0.1)
    assert eyes.cursor is None
    control.done("run", **asked(tmp_path))
    control.live(0.2)
    assert eyes.cursor.target is None
    control.live(1.0)
    assert eyes.cursor.target is not None
    assert eyes.cursor.radius == PLAN.width / 2
    control.done("end_run")
    control.live(0.1)
    assert eyes.cursor is None
