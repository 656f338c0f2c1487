"""Drills of the machine: its disk is full, or its wall clock jumps."""

import asyncio
import os
import resource
import sys
from pathlib import Path

import psutil
from drills.injury import look_for_jerks
from drills.results import Result
from drills.rig import AFTER, rig
from processes.running_control import tick_with

from app.clock import monotonic
from app.faults import Fault, State


async def disk_full(runs, dice):
    """S17: the recording can no longer be written."""
    result = Result("disk full while driving", None)
    async with rig() as made:
        for _ in range(runs):
            await made.cruise()
            process = psutil.Process(made.control.pid)
            full = monotonic()
            process.rlimit(psutil.RLIMIT_FSIZE, (1, resource.RLIM_INFINITY))
            await tick_with(made.control, lambda tick: tick["state"] == State.FAULT)
            tick = made.control.newest()
            if tick["fault"] != Fault.RECORDING_LOST:
                result.violated(f"{Fault(int(tick['fault'])).name}")
            await asyncio.sleep(AFTER)
            begun, disarmed = made.chair_stopped(full)
            look_for_jerks(made, full, result)
            result.add(begun, disarmed)
            process.rlimit(psutil.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
            await made.end_control()
            await made.start_control()
    result.remark = "files could grow no more; found out at the next writing to disk (0.5 s), then a ramp like any stop"
    return result


async def wall_clock(runs, dice):
    """S16: the wall clock jumps by a day, and the time zone changes."""
    folder = Path(__file__).parent / "jumping_clock"
    before = os.environ.get("PYTHONPATH", ""), os.environ.get("TZ")
    os.environ["PYTHONPATH"] = f"{folder}{os.pathsep}{before[0]}"
    os.environ["TZ"] = "Pacific/Kiritimati"
    result = Result("wall clock jumps by a day, other time zone", None)
    try:
        result.violations += [f"{words} does not jump: the drill shows nothing" for words in await _steady_clocks()]
        async with rig() as made:
            for _ in range(runs):
                await made.cruise()
                began = monotonic()
                await asyncio.sleep(2.0)
                if made.control.newest()["state"] != State.ARMED or made.receiver.newest["state"] != "armed":
                    result.violated("the drive ended")
                look_for_jerks(made, began, result)
                result.add(None, late=made.watcher.late(began, monotonic()))
    finally:
        os.environ["PYTHONPATH"] = before[0]
        os.environ.pop("TZ")
        if before[1] is not None:
            os.environ["TZ"] = before[1]
    result.remark = "UTC and time.time() of both processes jump at each look; the machine's own clock is not set"
    return result


async def _steady_clocks():
    """Return the clocks that do not jump in a process of this environment."""
    script = "; ".join(
        (
            "import time",
            "from app.clock import utc_now",
            "print(max(abs((utc_now() - utc_now()).total_seconds()) for _ in range(8)))",
            "print(max(abs(time.time() - time.time()) for _ in range(8)))",
        )
    )
    process = await asyncio.create_subprocess_exec(sys.executable, "-c", script, stdout=asyncio.subprocess.PIPE)
    said, _ = await process.communicate()
    steps = dict(zip(("utc_now()", "time.time()"), map(float, said.split()), strict=True))
    return [name for name, step in steps.items() if step < 3000.0]
