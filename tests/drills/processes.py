"""Drills of the processes: one of them is killed, suspended or silent while the chair drives."""

import asyncio
import os
import signal

from drills.injury import A_TICK, COMMAND, LATE_MACHINE, injure_at_random, nothing, setting
from drills.results import Result
from drills.rig import AFTER, rig
from processes.running_control import tick_with

from app.clock import monotonic
from app.faults import Fault, State


async def kill_control(runs, dice):
    """S3: kill -9 of the control process."""
    result = Result("kill -9 of the control process", 0.11 + COMMAND, 0.31 + COMMAND)
    async with rig() as made:

        async def again():
            await made.end_control()
            await made.start_control()

        for _ in range(runs):
            await injure_at_random(made, result, dice, lambda: _signal(made.control.pid, signal.SIGKILL), again)
    return result


async def hold_control(runs, dice):
    """S15: SIGSTOP of the control process for 200 ms."""
    result = Result("SIGSTOP of the control process for 200 ms", 0.11 + COMMAND, 0.31 + COMMAND)
    async with rig() as made:

        async def hold():
            await _signal(made.control.pid, signal.SIGSTOP)
            await asyncio.sleep(0.2)
            await _signal(made.control.pid, signal.SIGCONT)

        for _ in range(runs):
            await injure_at_random(made, result, dice, hold, nothing)
    return result


async def kill_receiver(runs, dice):
    """S21: kill -9 of the receiver: its motors stand without it; the control process must notice."""
    result = Result("kill -9 of the receiver, noticed by the control process", 0.3 + A_TICK)
    async with rig() as made:
        for _ in range(runs):
            await made.cruise()
            await asyncio.sleep(dice.uniform(0.0, 0.1))
            newest = float(made.control.newest()["t"])
            killed = monotonic()
            await asyncio.to_thread(made.receiver.kill)
            await tick_with(made.control, lambda tick: tick["state"] == State.FAULT)
            ticks = made.control.since(0)
            fault = ticks[(ticks["t"] > newest) & (ticks["state"] == State.FAULT)][0]
            if fault["fault"] != Fault.CHAIR_SILENT:
                result.violated(f"{Fault(int(fault['fault'])).name}")
            result.add(float(fault["t"]) - killed, late=made.watcher.late(killed, killed + 0.5))
            await asyncio.to_thread(made.receiver.start)
            await tick_with(made.control, lambda tick: tick["chair_age"] < 0.3 and tick["chair_state"] == 0)
    result.remark = "a receiver that is dead drives nothing: its output must stand by itself"
    return result


async def kill_web(runs, dice):
    """S14: kill -9 of the web process, and with it of the 3D scene, which lives in it."""
    result = Result("kill -9 of the web process (and of the scene in it)", 0.32)
    longest = 0.0
    async with rig(controlled=False) as made:
        for _ in range(runs):
            web = await made.start_web()
            await asyncio.sleep(dice.uniform(0.0, 0.1))
            killed = monotonic()
            web.kill()
            await asyncio.sleep(AFTER)
            await web.wait()
            begun, disarmed = made.chair_stopped(killed)
            late = made.watcher.late(killed - 0.4, killed + AFTER)
            if begun is None or (made.went_on(killed, begun) and late < LATE_MACHINE):
                result.violated("the chair went on")
            gap = made.relay.longest_gap(killed - 0.3, killed + (begun or 0.0))
            longest = max(longest, gap)
            if gap > 0.04 + late:
                result.violated(f"{1e3 * gap:.0f} ms between two commands")
            result.add(begun, disarmed, late)
    result.remark = f"longest time between two commands {1e3 * longest:.0f} ms (limit 40)"
    return result


async def web_silent(runs, dice):
    """S14: the web process, and the 3D scene that lives in it, says nothing any more."""
    result = Result("web process silent (held)", 0.32 + A_TICK + COMMAND)
    async with rig() as made:
        for _ in range(runs):
            await injure_at_random(made, result, dice, setting(made, beats=False), setting(made, beats=True), after=1.0)
    return result


async def _signal(pid, which):
    os.kill(pid, which)
