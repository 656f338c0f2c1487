"""The loop on a fake clock: a tick for each frame, ticks without frames, late ticks, cues, the scene's time."""

import math
import threading

import numpy as np
import pytest
from fake_clock import FakeClock
from hypothesis import given
from hypothesis import strategies as st
from pipeline.scripted_shirt import RATE, ScriptedShirt

from app.cues import Cue, cue_index
from app.faults import State
from app.hardware.base import BodyView, LeaderView
from app.messages import ALIVE, NO_CUE
from app.pipeline.loop import LONGEST_WAIT, ControlLoop
from app.pipeline.open_run import OpenRun
from app.pipeline.setup import Setup
from app.world.movers import Track

WAIT = 10.0  # s


class Writer:
    """The part of a run's writer that the loop uses."""

    damage = ""


def loop_with(ring, times, clock=None):
    clock = clock or FakeClock()
    setup = Setup(clock)
    setup.shirt = ScriptedShirt(clock, times) if times is not None else None
    return ControlLoop(setup, ring, None, clock)


def ticks_of(loop, turns):
    for _ in range(turns):
        loop.turn()
    return loop.ring.since(0)[0]


def test_one_frame_one_tick(ring):
    times = [i / RATE for i in range(50)]
    ticks = ticks_of(loop_with(ring, times), 50)
    assert ticks["has_frame"].all()
    assert ticks["t"].tolist() == times
    assert ticks["frame_seq"].tolist() == list(range(1, 51))
    assert ticks["late"].max() == 0


def test_without_frames_ticks_go_on(ring):
    ticks = ticks_of(loop_with(ring, [0.01, 0.02]), 7)
    assert ticks["has_frame"].tolist() == [1, 1, 0, 0, 0, 0, 0]
    np.testing.assert_allclose(np.diff(ticks["t"])[2:], LONGEST_WAIT)
    assert ticks["late"].max() == 0


def test_without_a_shirt_ticks_go_on(ring):
    ticks = ticks_of(loop_with(ring, None), 10)
    np.testing.assert_allclose(np.diff(ticks["t"]), LONGEST_WAIT)
    assert ticks["late"].max() == 0


def test_a_tick_later_than_a_period_is_counted(ring):
    clock = FakeClock()
    loop = loop_with(ring, [0.01, 0.02, 0.03], clock)
    ticks_of(loop, 3)
    clock.time += LONGEST_WAIT + 1 / RATE  # as if the process had been suspended
    loop.turn()
    loop.turn()
    assert ring.since(0)[0]["late"].tolist() == [0, 0, 0, 1, 1]
    clock.time += 1.0
    loop.begin_anew()
    loop.turn()
    assert loop.late == 1


def test_what_waited_is_taken_at_once(ring):
    clock = FakeClock()
    loop = loop_with(ring, [i / RATE for i in range(20)], clock)
    clock.time = 0.2
    ticks = ticks_of(loop, 20)
    assert ticks["has_frame"].all()
    assert set(ticks["t"]) == {0.2}


def test_a_shirt_is_alive_while_it_sends(ring):
    loop = loop_with(ring, [0.01])
    assert not loop.shirt_alive
    loop.turn()
    assert loop.shirt_alive
    for _ in range(100):
        loop.turn()
    assert not loop.shirt_alive
    assert loop.shirt_silent


def test_a_new_shirt_is_silent_only_after_it_had_time_for_a_frame(ring):
    clock = FakeClock()
    loop = loop_with(ring, [], clock)
    clock.time += ALIVE
    assert loop.shirt_silent
    loop.new_shirt()
    assert not loop.shirt_silent
    clock.time += 0.9 * ALIVE
    assert not loop.shirt_silent
    clock.time += 0.2 * ALIVE
    assert loop.shirt_silent


def test_cues_are_in_the_ticks_and_before_the_body_s_eyes(ring):
    times = [i / RATE for i in range(60)]
    loop = loop_with(ring, times)
    view = BodyView()
    loop.setup.simulated_shirt = type("SimulatedShirt", (), {"view": view, "body": None})()
    cues = (Cue(start=0.1, end=0.2, kind="rest"), Cue(start=0.2, end=0.4, kind="move", joint="right_elbow"))
    loop.run = OpenRun("r", 3, "prompt", cues, 0.0, Writer())
    seen = []
    for _ in times:
        loop.turn()
        seen.append((view.cue, view.cue_elapsed))
    ticks = ring.since(0)[0]
    assert ticks["run_t"].tolist() == times
    assert ticks["cue"].tolist() == [cue_index(cues, t) for t in times]
    assert [cue for cue, _ in seen] == [None if i == NO_CUE else cues[i] for i in ticks["cue"]]
    assert seen[25][1] == pytest.approx(0.05)
    assert set(ticks["run"]) == {3}
    assert not view.driving


def test_outside_a_run_there_is_no_run_time(ring):
    ticks = ticks_of(loop_with(ring, [0.0]), 1)
    assert ticks["run"].tolist() == [0]
    assert math.isnan(ticks["run_t"][0])
    assert ticks["cue"].tolist() == [NO_CUE]


@given(
    st.lists(st.tuples(st.floats(0, 10), st.floats(0.01, 5)), max_size=6),
    st.lists(st.floats(0, 16), min_size=1, max_size=60),
)
def test_the_cue_of_a_moment_is_that_of_the_list(spans, moments):
    cues = [Cue(start=start, end=start + length, kind="free") for start, length in spans]
    run = OpenRun("r", 1, "free", cues, 0.0, Writer())
    for moment in sorted(moments):
        assert run.cue_at(moment) == cue_index(cues, moment)


def test_a_shirt_whose_driver_fails_is_let_go_and_the_ticks_go_on(ring):
    loop = loop_with(ring, [0.01, 0.02])
    ticks_of(loop, 2)

    def fail(_timeout):
        raise RuntimeError("the cable\nburnt")

    loop.setup.shirt.read = fail
    ticks = ticks_of(loop, 5)
    assert ticks["has_frame"].tolist() == [1, 1, 0, 0, 0, 0, 0]
    assert loop.setup.shirt is None
    assert str(loop.setup.shirt_description) == "The shirt failed (the cable burnt): choose it again."


def test_a_failed_shirt_that_takes_long_to_close_holds_up_no_tick(ring):
    """Safety: a loop without a tick for two seconds is replaced."""
    loop = loop_with(ring, [])
    closed, closed_by = threading.Event(), []

    def close():
        closed_by.append(threading.current_thread())
        closed.set()

    def fail(_timeout):
        raise OSError("gone")

    loop.setup.shirt.read, loop.setup.shirt.close = fail, close
    ticks_of(loop, 3)
    assert closed.wait(WAIT)
    assert closed_by != [threading.current_thread()]


ANNA = {"name": "anna", "kind": "person", "points": [[2, 0], [6, 0]], "pace": [[0, 0.5]]}
BEHIND = {"name": "behind", "title": "Behind her", "points": [[0, 0], [6, 0]], "instruction": "Go."}
ALONE = {"name": "alone", "title": "Alone", "points": [[0, 0], [0, 6]], "instruction": "Go."}
FOLLOW = {"kind": "follow", "leader": "anna"}
WORLD = {"name": "p", "title": "P", "walls": [], "movers": [ANNA], "paths": [BEHIND | {"task": FOLLOW}, ALONE]}


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
