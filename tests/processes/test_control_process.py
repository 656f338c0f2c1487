"""A real control process, started, commanded, and killed."""

import asyncio
import json
import os
import signal
import socket
import subprocess
import sys
from contextlib import asynccontextmanager, suppress

import numpy as np
import pytest
from processes.wearer import RATE, Wearer, free_port, shirt_config

from app.faults import Fault, State
from app.link import LinkLost, LinkRefused
from app.pipeline.process import main
from app.pipeline.rerun import decode_run
from app.recording_reader import read_run
from app.session.control import Control
from app.supervisor import ControlProcess
from building import make_parameters

PATIENCE = 20.0  # s

SIMULATED = {"kind": "simulator", "sample_rate": 200.0, "seed": 1, "layout": None, "dead_channels": []}
ROOM = {
    "name": "room",
    "title": "Room",
    "walls": [[[-2.0, -2.0], [30.0, -2.0], [30.0, 2.0], [-2.0, 2.0], [-2.0, -2.0]]],
    "paths": [{"name": "ahead", "title": "Ahead", "points": [[1.0, 0.5], [20.0, 0.5]], "instruction": "Drive ahead."}],
}


@asynccontextmanager
async def running():
    """Yield a control process that hears a heartbeat."""
    control = await ControlProcess.start()
    heart = asyncio.create_task(beat(control))
    try:
        yield control
    finally:
        heart.cancel()
        await asyncio.gather(heart, return_exceptions=True)
        await control.close()


async def beat(control):
    with suppress(LinkLost):
        while True:
            control.tell("heartbeat", screen=True)
            await asyncio.sleep(0.05)


async def tick_with(control, condition):
    for _ in range(int(PATIENCE / 0.01)):
        tick = control.newest()
        if tick is not None and condition(tick):
            return tick
        await asyncio.sleep(0.01)
    raise AssertionError(f"it did not happen within {PATIENCE:g} s, the newest tick is {tick}")


async def refusal(control, do, **fields):
    with pytest.raises(LinkRefused) as refused:
        await control.call(do, **fields)
    sentence = str(refused.value)
    assert sentence.strip()
    assert "\n" not in sentence
    return sentence


async def armed(control, digest):
    """Arm, again when this busy machine held something up, and wait for permission."""
    for _ in range(5):
        await control.call("clear")
        await control.call("arm", hash=digest)
        tick = await tick_with(control, lambda tick: tick["state"] in (State.ARMED, State.FAULT))
        if tick["state"] == State.ARMED:
            return
    raise AssertionError(f"the chair could not be armed: {Fault(int(tick['fault']))}")


def test_a_run_with_cues_is_recorded(tmp_path):
    cues = [
        {"start": 0.1, "end": 0.3, "kind": "rest"},
        {"start": 0.3, "end": 0.6, "kind": "move", "joint": "right_elbow", "repetition": 1},
    ]

    async def story():
        async with running() as control:
            answer = await control.call("shirt", config=SIMULATED)
            assert answer["sample_rate"] == 200.0
            channels = len(answer["layout"]["channels"])
            await control.call("body", config={"kind": "person", "skill": "practised", "seed": 1})
            folder = str(tmp_path / "run")
            number = (
                await control.call("run", run_id="r1", folder=folder, kind="prompt", cues=cues, meta={"step": "x"})
            )["run"]
            await tick_with(control, lambda tick: tick["run_t"] > 0.8)
            status = await control.call("status")
            assert status["recording"]["run_id"] == "r1"
            assert status["shirt"]["kind"] == "simulator"
            assert status["shirt"]["alive"]
            ended = await control.call("end_run")
            after = await tick_with(control, lambda tick: tick["run"] == 0)
            assert np.isnan(after["run_t"])
            return channels, number, ended

    channels, number, ended = asyncio.run(story())
    assert number == 1
    run = read_run(tmp_path / "run")
    assert (run.words, run.rows, run.dropped) == ("", ended["rows"], ended["dropped"])
    assert ended["dropped"] == 0
    assert run.meta["meta"] == {"step": "x"}
    assert [cue["kind"] for cue in run.meta["cues"]] == ["rest", "move"]
    run_t, cue = run.columns["run_t"], run.columns["cue"]
    expected = np.select([(run_t >= 0.1) & (run_t < 0.3), (run_t >= 0.3) & (run_t < 0.6)], [0, 1], -1)
    assert cue.tolist() == expected.tolist()
    frames = run.frames()
    assert frames["values"].shape == (len(frames["t"]), channels)
    assert np.isfinite(frames["values"]).all()
    assert (np.diff(frames["frame_seq"].astype(int)) == 1).all()


def test_a_drive_is_recorded_and_decoding_the_recording_gives_the_same_drive(tmp_path):
    parameters = make_parameters()

    async def story():
        port = free_port()
        async with running() as control:
            await control.call("shirt", config=shirt_config(parameters, port))
            digest = (await control.call("parameters", parameters=parameters.model_dump(mode="json")))["hash"]
            assert digest == parameters.hash
            await control.call("world", floorplan=ROOM, path="ahead")
            wearer = Wearer(parameters, port)
            try:
                await tick_with(control, lambda tick: tick["has_frame"])
                await control.call("run", run_id="d", folder=str(tmp_path / "run"), kind="drive", cues=[], meta={})
                await armed(control, digest)
                start = control.newest()
                assert (start["x"], start["y"], start["theta"]) == (1.0, 0.5, 0.0)
                wearer.stroke()
                await tick_with(control, lambda tick: tick["x"] > 1.3)
                assert "armed" in await refusal(control, "parameters", parameters=None)
                assert "armed" in await refusal(control, "world", floorplan=None, path=None)
                await control.call("stop", by="key")
                stopped = await tick_with(control, lambda tick: tick["v"] == 0.0)
                assert (stopped["state"], stopped["fault"]) == (State.FAULT, Fault.STOP_KEY)
                sentence = await refusal(control, "arm", hash=digest)
                assert "keyboard" in sentence
                # Continue must find what was armed and is written in the recording, not something else.
                assert "recorded" in await refusal(control, "parameters", parameters=None)
                assert "recorded" in await refusal(control, "world", floorplan=None, path=None)
                await control.call("clear")
                await tick_with(control, lambda tick: tick["state"] == State.ARMED)
                await control.call("end_run")
                assert control.newest()["state"] == State.DISARMED
            finally:
                wearer.close()

    asyncio.run(story())
    run = read_run(tmp_path / "run")
    assert run.words == ""
    again = decode_run(run, parameters)
    frames = run.frames()
    for name in ("score", "rate", "activation", "u1", "u2"):
        np.testing.assert_allclose(frames[name], getattr(again, name), rtol=0, atol=1e-6, err_msg=name)
    if run.rows == len(frames["t"]):  # turns without a frame, on a busy machine, have no place in a file of frames
        for name in ("v", "omega", "x", "y", "theta"):
            np.testing.assert_allclose(frames[name], getattr(again, name), rtol=0, atol=1e-6, err_msg=name)
    assert frames["x"].max() > 1.3


def test_what_cannot_be_done_is_refused_in_one_sentence(tmp_path):
    parameters = make_parameters()
    document = parameters.model_dump(mode="json")

    async def story():
        async with running() as control:
            folder = str(tmp_path / "run")
            run = {"run_id": "r", "folder": folder, "kind": "rest", "cues": [], "meta": {}}
            assert "calibrate first" in await refusal(control, "arm", hash="0" * 64)
            assert "No shirt" in await refusal(control, "run", **run)
            assert "no command 'fly'" in await refusal(control, "fly")
            assert "there is no shirt of the kind 'coat'" in await refusal(control, "shirt", config={"kind": "coat"})
            assert "simulated shirt" in await refusal(control, "body", config={"kind": "visitor"})
            assert "begin a run" in await refusal(control, "end_run")
            await control.call("shirt", config=SIMULATED)
            assert "other channels" in await refusal(control, "parameters", parameters=document)
            assert "Nobody" in await refusal(control, "move", joints={"right_elbow": 0.5})
            await control.call("body", config={"kind": "visitor"})
            assert "no joint 'tail'" in await refusal(control, "move", joints={"tail": 0.5})
            assert "joints.right_elbow" in await refusal(control, "move", joints={"right_elbow": 1.5})
            assert "folder" in await refusal(control, "run", **{**run, "folder": "relative"})
            await control.call("run", **run)
            assert "already" in await refusal(control, "run", **run)
            assert "already" in await refusal(control, "shirt", config=SIMULATED)
            await control.call("end_run")
            assert "recording of this name" in await refusal(control, "run", **run)
            await control.call("shirt", config=shirt_config(parameters, free_port()))
            assert (await control.call("status"))["shirt"]["alive"] is False
            document["gestures"][0]["dead_zone"] = -1.0
            assert "gestures[0].dead_zone" in await refusal(control, "parameters", parameters=document)
            document["gestures"][0]["dead_zone"] = 0.2
            await control.call("parameters", parameters=document)
            assert "changed meanwhile" in await refusal(control, "arm", hash="0" * 64)
            assert (await control.call("shirt", config=SIMULATED))["hash"] is None

    asyncio.run(story())


def test_without_a_heartbeat_nothing_is_armed():
    parameters = make_parameters()

    async def story():
        port = free_port()
        control = await ControlProcess.start()
        wearer = Wearer(parameters, port)
        try:
            await control.call("shirt", config=shirt_config(parameters, port))
            await control.call("parameters", parameters=parameters.model_dump(mode="json"))
            await tick_with(control, lambda tick: tick["has_frame"])
            await control.call("arm", hash=parameters.hash)
            tick = await tick_with(control, lambda tick: tick["state"] == State.FAULT)
            assert tick["fault"] == Fault.WEB_SILENT
            assert not np.any(control.since(0)["state"] == State.ARMED)
        finally:
            wearer.close()
            await control.close()

    asyncio.run(story())


def test_a_control_process_that_is_killed_is_noticed_and_replaced_disarmed(tmp_path):
    async def story():
        opened = []

        async def open_link():
            opened.append(await ControlProcess.start())
            return opened[-1]

        control = Control(open_link)
        states = []

        async def note(state):
            states.append(state)

        control.on_change.append(note)
        await control.start()
        try:
            await control.load("shirt", config=SIMULATED)
            folder = tmp_path / "run"
            await control.call("run", run_id="r", folder=str(folder), kind="free", cues=[], meta={})
            await asyncio.sleep(1.0)
            os.kill(opened[0].pid, signal.SIGKILL)
            await asyncio.wait_for(opened[0].died(), PATIENCE)
            with pytest.raises(LinkLost):
                await opened[0].call("status")
            for _ in range(int(PATIENCE / 0.02)):
                if states == ["lost", "alive"]:
                    break
                await asyncio.sleep(0.02)
            assert states == ["lost", "alive"]
            status = await control.call("status")
            assert status["shirt"]["kind"] == "simulator"  # what was loaded is loaded again
            assert status["recording"] is None
            assert (await tick_with(control, lambda tick: tick["has_frame"]))["state"] == State.DISARMED
            run = read_run(folder)
            assert run.rows > 0.3 * RATE  # what was on disk by then is there
            assert "cut" in run.words
        finally:
            await control.close()

    asyncio.run(story())


def test_closing_ends_the_process_and_leaves_no_memory_behind():
    async def story():
        control = await ControlProcess.start()
        assert not [name for name in shared_memory() if f"-{os.getpid()}-" in name]
        await control.close()
        with pytest.raises(ProcessLookupError):
            os.kill(control.pid, 0)

    asyncio.run(story())


def shared_memory():
    return os.listdir("/dev/shm") if os.path.isdir("/dev/shm") else []


IN_ONE_PROCESS = """
import json, socket, sys
from app.pipeline.process import main

ours, theirs = socket.socketpair()
for line in json.loads(sys.argv[1]):
    ours.sendall(json.dumps(line).encode() + b"\\n")
code = main(["--link-fd", str(theirs.detach()), "--ring", sys.argv[2]])
answers = [json.loads(line) for line in ours.makefile()]
print(json.dumps({"code": code, "answers": answers, "modules": sorted({name.split(".")[0] for name in sys.modules})}))
"""


def test_in_use_it_loads_no_web_database_or_fitting_library(tmp_path):
    commands = [
        {"id": 1, "do": "shirt", "config": SIMULATED},
        {"id": 2, "do": "body", "config": {"kind": "person", "skill": "novice", "seed": 1}},
        {"id": 3, "do": "world", "floorplan": ROOM, "path": "ahead"},
        {"id": 4, "do": "run", "run_id": "r", "folder": str(tmp_path / "r"), "kind": "drive", "cues": [], "meta": {}},
        {"id": 5, "do": "end_run"},
        {"id": 6, "do": "quit"},
    ]
    name = f"bodydrive-test-{os.getpid()}"
    told = subprocess.run(
        [sys.executable, "-c", IN_ONE_PROCESS, json.dumps(commands), name], capture_output=True, text=True, check=True
    )
    seen = json.loads(told.stdout)
    assert seen["code"] == 0
    assert [answer["id"] for answer in seen["answers"] if answer["ok"]] == [1, 2, 3, 4, 6, 5]
    forbidden = "fastapi starlette uvicorn viser sqlalchemy alembic sklearn scipy pandas shapely matplotlib typer"
    assert not set(forbidden.split()) & set(seen["modules"])
    assert read_run(tmp_path / "r").words == ""


@pytest.mark.parametrize("arguments", [["--link-fd", "0", "--ring", "x", "--report", "nowhere"], []])
def test_a_wrong_command_line_is_refused(arguments, capsys):
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    assert "error:" in capsys.readouterr().err


def test_memory_that_cannot_be_had_is_one_sentence(capsys):
    ours, theirs = socket.socketpair()
    with ours:
        assert main(["--link-fd", str(theirs.detach()), "--ring", "no/such/folder"]) == 2
    assert capsys.readouterr().err.startswith("The control process cannot start: ")
