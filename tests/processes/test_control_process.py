"""A real control process, commanded and killed."""

import asyncio
import json
import os
import signal
import socket
import subprocess
import sys
from contextlib import closing

import numpy as np
import pytest
from processes.running_control import PATIENCE, ROOM, SIMULATED, linked, refusal, running, tick_with, until, worn
from processes.udp_shirt import RATE, free_port, shirt_config

from app.faults import Fault, State
from app.pipeline.process import main
from app.process.command_channel import LinkLost
from app.process.supervisor import ControlProcess, launch
from app.recording.reader import read_run
from building import make_parameters
from event_loop import in_event_loop


@in_event_loop
async def test_what_cannot_be_done_is_refused_in_one_sentence(tmp_path):
    parameters = make_parameters()
    document = parameters.model_dump(mode="json")
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
        assert "other sensors" in await refusal(control, "parameters", parameters=document)
        assert "nobody" in await refusal(control, "move", joints={"right_elbow": 0.5})
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


@in_event_loop
async def test_without_a_heartbeat_nothing_is_armed():
    parameters = make_parameters()
    async with running(screen=None) as control, worn(control, parameters):
        await tick_with(control, lambda tick: tick["has_frame"])
        await control.call("arm", hash=parameters.hash)
        tick = await tick_with(control, lambda tick: tick["state"] == State.FAULT)
        assert tick["fault"] == Fault.WEB_SILENT
        assert not np.any(control.since(0)["state"] == State.ARMED)


@in_event_loop
async def test_a_control_process_that_is_killed_is_noticed_and_replaced_disarmed(tmp_path):
    folder = tmp_path / "run"
    async with linked() as (control, opened, states):
        await control.call("run", run_id="r", folder=str(folder), kind="free", cues=[], meta={})
        await asyncio.sleep(1.0)
        os.kill(opened[0].pid, signal.SIGKILL)
        await asyncio.wait_for(opened[0].died(), PATIENCE)
        with pytest.raises(LinkLost):
            await opened[0].call("status")
        await until(lambda: states == ["lost", "alive"])
        status = await control.call("status")
        assert status["shirt"]["kind"] == "simulator"  # the setup is loaded again
        assert status["recording"] is None
        assert (await tick_with(control, lambda tick: tick["has_frame"]))["state"] == State.DISARMED
        run = read_run(folder)
        assert run.rows > 0.3 * RATE  # the part on the disk is kept
        assert "cut" in str(run.damage)


@in_event_loop
async def test_closing_ends_the_process_and_leaves_no_memory_behind():
    control = await ControlProcess.start()
    assert not [name for name in shared_memory() if f"-{os.getpid()}-" in name]
    await control.close()
    with pytest.raises(ProcessLookupError):
        os.kill(control.pid, 0)


def shared_memory():
    return os.listdir("/dev/shm") if os.path.isdir("/dev/shm") else []


IN_ONE_PROCESS = """
import json, socket, sys, threading
from app.pipeline.process import main

ours, theirs = socket.socketpair()
answers = []

def ask():
    lines, commands = ours.makefile(), json.loads(sys.argv[1])
    for opening in commands[:2]:  # while a device is opened, these commands are refused
        ours.sendall(json.dumps(opening).encode() + b"\\n")
        answers.append(json.loads(next(lines)))
    for command in commands[2:]:
        ours.sendall(json.dumps(command).encode() + b"\\n")
    answers.extend(json.loads(line) for line in lines)

asking = threading.Thread(target=ask)
asking.start()
code = main(["--link-fd", str(theirs.detach()), "--ring", sys.argv[2]])
asking.join()
print(json.dumps({"code": code, "answers": answers, "modules": sorted({name.split(".")[0] for name in sys.modules})}))
"""


def test_a_new_process_that_nobody_comes_to_use_ends_and_leaves_no_memory_behind():
    with closing(launch()) as new:
        assert new.process.poll() is None
    assert new.process.returncode is not None
    assert new.ring not in shared_memory()


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
    forbidden = "fastapi starlette uvicorn viser sqlalchemy alembic sklearn scipy shapely matplotlib typer"
    assert set(forbidden.split()) & set(seen["modules"]) == set()
    assert read_run(tmp_path / "r").damage is None


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
