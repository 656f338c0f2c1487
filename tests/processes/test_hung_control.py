"""A control process that hangs: the chair stops, and the process is killed and replaced."""

import asyncio
import os
import signal

import psutil
import pytest
from processes.running_control import linked, until

from app.clock import monotonic
from app.faults import State
from app.refusals import Unavailable
from app.session import control_link as control_module
from app.session.control_link import HANG_LIMIT, STOP_LIMIT
from event_loop import in_event_loop

LOAD = 1.0  # s of lateness of a busy machine


@in_event_loop
async def test_stop_is_answered_and_a_new_one_takes_its_place():
    async with linked() as (control, opened, states):
        assert await control.stop()
        os.kill(opened[0].pid, signal.SIGSTOP)
        before = monotonic()
        assert not await control.stop()
        assert monotonic() - before < STOP_LIMIT + LOAD
        await until(lambda: len(opened) == 2 and control.state == "alive")
        assert monotonic() - before > HANG_LIMIT - 0.5  # a short pause is no reason to kill
        assert states[0] == "lost"
        assert not psutil.pid_exists(opened[0].pid)
        await until(lambda: control.newest() is not None and control.newest()["has_frame"])
        tick = control.newest()
        assert (State(int(tick["state"])), float(tick["v"])) == (State.DISARMED, 0.0)
        assert await control.stop()


@in_event_loop
async def test_a_run_that_is_asked_of_one_that_stands_still_is_open_nowhere(tmp_path):
    async with linked() as (control, opened, _):
        os.kill(opened[0].pid, signal.SIGSTOP)
        run = {"run_id": "a", "folder": str(tmp_path / "a"), "kind": "rest", "cues": [], "meta": {}}
        with pytest.raises(Unavailable):
            await control.call("run", **run)
        await until(lambda: len(opened) == 2 and control.state == "alive")
        assert (await control.call("status"))["recording"] is None
        await until(lambda: control.newest() is not None and control.newest()["has_frame"])
        assert (await control.call("run", **{**run, "run_id": "b", "folder": str(tmp_path / "b")}))["run"] == 1
        assert (await control.call("end_run"))["dropped"] == 0


@in_event_loop
async def test_a_short_pause_is_left_to_the_gate(monkeypatch):
    monkeypatch.setattr(control_module, "HANG_LIMIT", 30.0)  # this machine may be busy
    async with linked() as (control, opened, _):
        os.kill(opened[0].pid, signal.SIGSTOP)
        await asyncio.sleep(0.2)
        os.kill(opened[0].pid, signal.SIGCONT)
        number = int(control.newest()["number"])
        await until(lambda: int(control.newest()["number"]) > number + 10)
        assert len(opened) == 1
