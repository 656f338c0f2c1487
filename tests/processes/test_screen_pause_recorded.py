"""A slow screen pauses a real control process, which goes on by itself; its recording tells the pause from driving."""

import asyncio

import numpy as np
import pytest
from processes.running_control import IN_VIEW, ROOM, armed, running, tick_with, worn

from app.faults import Fault, State
from app.pipeline.replay.exact_rerun import Rerun, replay_run
from app.recording.reader import read_run
from app.session.recordings import measure_again
from building import make_parameters
from event_loop import in_event_loop


@in_event_loop
async def test_a_slow_screen_pauses_the_drive_and_the_recording_says_so(tmp_path):
    parameters, folder, screen = make_parameters(), tmp_path / "run", {**IN_VIEW}
    async with running(screen) as control, worn(control, parameters) as shirt:
        await control.call("world", floorplan=ROOM, path="ahead")
        await tick_with(control, lambda tick: tick["has_frame"])
        await control.call("run", run_id="d", folder=str(folder), kind="drive", cues=[], meta={})
        await armed(control, parameters.hash)
        shirt.stroke()
        await tick_with(control, lambda tick: tick["x"] > 1.3)
        screen["screen"] = "slow"
        paused = await tick_with(control, lambda tick: tick["v"] == 0.0)
        assert (paused["state"], paused["fault"]) == (State.DISARMED, Fault.SCREEN_SLOW)
        await asyncio.sleep(1.0)
        screen["screen"] = "in view"
        await tick_with(control, lambda tick: tick["state"] == State.ARMED)
        shirt.stroke()
        await tick_with(control, lambda tick: tick["x"] > paused["x"] + 0.2)
        await control.call("end_run")
        stops = int(control.newest()["stops"])
    run = read_run(folder)
    measures = measure_again(folder)
    rows = run.columns
    driven = rows["t"][np.flatnonzero(rows["state"] == State.ARMED)[-1]] - rows["t"][rows["state"] == State.ARMED][0]
    if int(paused["stops"]) == stops:  # a busy machine may have stopped the chair besides
        assert (measures["halts"], measures["person_stops"]) == (0, 0)
    assert measures["pauses"] >= 1
    assert measures["pause_time"] >= 1.0 + 1.0 + 0.5  # slow, then punctual for a second, then at rest
    lost = measures["pause_time"] + measures["halt_time"] + measures["person_stop_time"]
    assert measures["time"] == pytest.approx(driven - lost, abs=0.05)
    exact = replay_run(run, parameters)
    for name in Rerun.__slots__:
        np.testing.assert_array_equal(rows[name], getattr(exact, name), err_msg=name)
