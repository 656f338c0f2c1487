"""The recording of a real control process, and that decoding it gives its numbers again."""

import numpy as np
import pytest
from processes.running_control import ROOM, SIMULATED, armed, refusal, running, tick_with, worn

from app.faults import Fault, State
from app.pipeline.replay.exact_rerun import Rerun, replay_run
from app.pipeline.replay.rerun import decode_run
from app.recording.reader import read_run
from building import make_parameters
from event_loop import in_event_loop

SOURCE = {"shirt": "simulator", "body": "person", "chair": "virtual", "simulated": True}


@in_event_loop
async def test_a_run_with_cues_is_recorded(tmp_path):
    cues = [
        {"start": 0.1, "end": 0.3, "kind": "rest"},
        {"start": 0.3, "end": 0.6, "kind": "move", "joint": "right_elbow", "repetition": 1},
    ]
    async with running() as control:
        answer = await control.call("shirt", config=SIMULATED)
        assert answer["sample_rate"] == 200.0
        channels = len(answer["layout"]["channels"])
        await control.call("body", config={"kind": "person", "skill": "practised", "seed": 1})
        folder = str(tmp_path / "run")
        begun = await control.call("run", run_id="r1", folder=folder, kind="prompt", cues=cues, meta={"step": "x"})
        assert begun["source"] == SOURCE
        await tick_with(control, lambda tick: tick["run_t"] > 0.8)
        status = await control.call("status")
        assert status["recording"]["run_id"] == "r1"
        assert status["shirt"]["kind"] == "simulator"
        assert status["shirt"]["alive"]
        ended = await control.call("end_run")
        after = await tick_with(control, lambda tick: tick["run"] == 0)
        assert np.isnan(after["run_t"])
    assert begun["run"] == 1
    run = read_run(tmp_path / "run")
    assert (run.damage, run.rows, run.dropped) == (None, ended["rows"], ended["dropped"])
    assert ended["dropped"] == 0
    assert run.meta["meta"] == {"step": "x"}
    assert run.meta["compiled"] is False
    assert run.meta["source"] == SOURCE
    assert [cue["kind"] for cue in run.meta["cues"]] == ["rest", "move"]
    run_t, cue = run.columns["run_t"], run.columns["cue"]
    expected = np.select([(run_t >= 0.1) & (run_t < 0.3), (run_t >= 0.3) & (run_t < 0.6)], [0, 1], -1)
    assert cue.tolist() == expected.tolist()
    frames = run.frames()
    assert frames["values"].shape == (len(frames["t"]), channels)
    assert np.isfinite(frames["values"]).all()
    assert (np.diff(frames["frame_seq"].astype(int)) == 1).all()


@pytest.mark.parametrize("dynamics", ["unicycle", "wheelchair"])
@in_event_loop
async def test_a_drive_is_recorded_and_decoding_the_recording_gives_the_same_drive(tmp_path, dynamics):
    parameters = make_parameters()
    async with running() as control, worn(control, parameters) as shirt:
        await control.call("chair", config={"kind": "virtual", "dynamics": dynamics})
        await control.call("world", floorplan=ROOM, path="ahead")
        await tick_with(control, lambda tick: tick["has_frame"])
        await control.call("run", run_id="d", folder=str(tmp_path / "run"), kind="drive", cues=[], meta={})
        await armed(control, parameters.hash)
        start = control.newest()
        assert (start["x"], start["y"], start["theta"]) == (1.0, 0.5, 0.0)
        shirt.stroke()
        await tick_with(control, lambda tick: tick["x"] > 1.3)
        assert "armed" in await refusal(control, "parameters", parameters=None)
        assert "armed" in await refusal(control, "world", floorplan=None, path=None)
        await control.call("stop", by="key")
        stopped = await tick_with(control, lambda tick: tick["v"] == 0.0)
        assert (stopped["state"], stopped["fault"]) == (State.FAULT, Fault.STOP_KEY)
        sentence = await refusal(control, "arm", hash=parameters.hash)
        assert "keyboard" in sentence
        # Continue must resume the parameters that were armed and recorded.
        assert "recorded" in await refusal(control, "parameters", parameters=None)
        assert "recorded" in await refusal(control, "world", floorplan=None, path=None)
        assert "another stop" in await refusal(control, "clear", stops=int(stopped["stops"]) - 1)
        await control.call("clear", stops=int(stopped["stops"]))
        await tick_with(control, lambda tick: tick["state"] == State.ARMED)
        await control.call("end_run")
        assert control.newest()["state"] == State.DISARMED
    run = read_run(tmp_path / "run")
    assert (run.damage, run.meta["dynamics"]) == (None, dynamics)
    assert run.meta["source"] == {"shirt": "udp", "body": None, "chair": "virtual", "simulated": False}
    exact = replay_run(run, parameters)
    for name in Rerun.__slots__:
        np.testing.assert_array_equal(run.columns[name], getattr(exact, name), err_msg=name)
    again = decode_run(run, parameters)
    frames = run.frames()
    for name in ("score", "rate", "activation", "u1", "u2"):
        np.testing.assert_allclose(frames[name], getattr(again, name), rtol=0, atol=1e-6, err_msg=name)
    if run.rows == len(frames["t"]):  # turns without a frame, on a busy machine, have no place in a file of frames
        for name in ("v", "omega", "x", "y", "theta"):
            np.testing.assert_allclose(frames[name], getattr(again, name), rtol=0, atol=1e-6, err_msg=name)
    assert frames["x"].max() > 1.3
