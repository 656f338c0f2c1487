"""The drill of random schedules: holds, stalls, cuts, strokes and stops, one after another and at the same time."""

import asyncio
import os
import signal
from itertools import pairwise
from random import Random
from typing import NamedTuple

from drills.injury import A_TICK, COMMAND, look_for_jerks
from drills.results import SIDE_BY_SIDE, Result, shares
from drills.rig import rig

from app.clock import monotonic

LASTS = 2.5  # s of a schedule
SLOWING = 0.11 + A_TICK  # s after which S3 lets the chair only slow
SILENT = 0.21 + A_TICK + COMMAND  # s after which S4 does
STOPPED = A_TICK + COMMAND  # s after which a stop does
ROUNDING = 1e-6  # m/s


class Forbidden(NamedTuple):
    """A time in which the chair may not become faster, and why."""

    begin: float  # monotonic s
    end: float
    why: str


async def schedules(runs, dice):
    """S3, S4, S6, S15: a random schedule for each cruising chair; the chair never becomes faster where it must slow."""
    result = Result("random schedules of holds, stalls, cuts, strokes and stops", None)
    counts = dict.fromkeys(ACTS, 0)
    await asyncio.gather(*(_schedules(share, Random(dice.random()), result, counts) for share in shares(runs)))
    did = ", ".join(f"{count} x {name}" for name, count in counts.items())
    result.remark = f"{SIDE_BY_SIDE} chairs side by side; {did}"
    return result


async def _schedules(runs, dice, result, counts):
    async with rig(seed=dice.randrange(1000)) as made:
        for _ in range(runs):
            await made.cruise()
            began = monotonic()
            forbidden = []
            # Acts of one kind follow one another: two holds of one process at once end when the first one ends.
            await asyncio.gather(*(_repeat(made, dice, name, began + LASTS, forbidden, counts) for name in ACTS))
            await asyncio.sleep(SILENT)
            late = made.watcher.late(began, monotonic())
            lines = made.receiver.since(began)
            result.violations += [f"run {result.runs + 1}: {words}" for words in faster(lines, forbidden, late)]
            look_for_jerks(made, began, result)
            result.add(None, late=late)


def faster(lines, forbidden, late):
    """Return in words where the chair became faster though it must slow; `late`: how late this machine was (s)."""
    found = []
    for begin, end, why in forbidden:
        inside = [line for line in lines if begin + late <= line["t"] <= end]
        for before, after in pairwise(inside):
            if abs(after["v"]) > abs(before["v"]) + ROUNDING:
                found.append(f"from {before['v']:.3f} to {after['v']:.3f} m/s {after['t'] - begin:.3f} s into {why}")
    return found


async def _repeat(made, dice, name, until, forbidden, counts):
    while True:
        await asyncio.sleep(dice.uniform(0.1, 1.5))
        if monotonic() > until:
            return
        counts[name] += 1
        found = await ACTS[name](made, dice)
        if found is not None and found.begin < found.end:
            forbidden.append(found)


async def _hold(made, dice):
    pid = made.control.pid
    os.kill(pid, signal.SIGSTOP)
    began = monotonic()
    await asyncio.sleep(dice.uniform(0.02, 0.4))
    ended = monotonic()
    os.kill(pid, signal.SIGCONT)
    return Forbidden(began + SLOWING, ended, "a hold of the control process")


async def _cut(made, dice):
    began = monotonic()
    made.relay.cut = True
    await asyncio.sleep(dice.uniform(0.02, 0.4))
    ended = monotonic()
    made.relay.cut = False
    return Forbidden(began + SLOWING, ended, "a cut of the network")


async def _stall(made, dice):
    made.shirt.stalled = True
    began = monotonic()
    await asyncio.sleep(dice.uniform(0.02, 0.5))
    ended = monotonic()
    made.shirt.stalled = False
    return Forbidden(began + SILENT, ended, "a stall of the shirt")


async def _stroke(made, _dice):
    made.shirt.stroke()


async def _stop(made, _dice):
    await made.control.call("stop", by="tablet")
    return Forbidden(monotonic() + STOPPED, monotonic() + LASTS, "a stop")


ACTS = {"hold": _hold, "cut": _cut, "stall": _stall, "stroke": _stroke, "stop": _stop}
