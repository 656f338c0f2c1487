"""Faults of each output at random moments: no far end holds its speed. And Stop on the tablet, up to the far end."""

import asyncio
import math
import os
import random
import tempfile
from contextlib import closing
from itertools import pairwise
from pathlib import Path
from unittest.mock import patch

from drills.far_chairs import FAR_ENDS, LINE_EVERY, NETWORK, FarChair
from drills.injury import injure_at_random, nothing
from drills.network_cuts import driven, sender_of
from drills.results import Result, Watcher, shares, waited
from drills.rig import rig

from app.clock import monotonic
from app.hardware.chair.packet import STOP

OF_EVERY_OUTPUT = ("silence", "stop", "switch")
LOOK_ON = 0.75  # s of observation after a fault
SPEED, ALMOST = 0.3, 0.29  # m/s: what is commanded without a chair document; LUCI takes whole percents
LONGEST_HOLD = 0.3  # s
STOP_LIMIT = 0.06  # s


def shares_of_outputs(runs):
    """Return, for each output that this machine has, how many of the runs are its own."""
    return dict(zip(FAR_ENDS, shares(runs, len(FAR_ENDS)), strict=False))


async def output_faults(runs, dice):
    """S3, S6, S21: each fault that can reach the far end, of each output, in turn."""
    result = Result("faults of each output, seen at its far end", LONGEST_HOLD)
    outputs = shares_of_outputs(runs)
    with closing(Watcher()) as watcher, patch.dict(os.environ, NETWORK):
        of_outputs = (_faults_of(name, result, watcher, share, dice.random()) for name, share in outputs.items())
        await asyncio.gather(*of_outputs)
    result.remark = (
        f"{', '.join(f'{name} {share}' for name, share in outputs.items())}; the second time is that of standstill. "
        "Left out: what cuts a WHILL, LUCI or ROS 2 off, so that only they themselves can stop"
    )
    return result


async def _faults_of(output, result, watcher, runs, seed):
    dice = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="bodydrive-output-") as folder:
        chair = await asyncio.to_thread(FarChair, Path(folder), output)
        faults = (*OF_EVERY_OUTPUT, *chair.far.faults)
        async with sender_of(chair, dice) as sender:
            for run in range(runs):
                await _one(f"{output}, {faults[run % len(faults)]}", result, watcher, chair, sender, dice)


async def _one(name, result, watcher, chair, sender, dice):
    fault = name.rpartition(" ")[2]
    await driven(chair, sender, dice, SPEED, ALMOST)
    before = waited(chair.pid)
    injured = monotonic()
    if fault == "stop":
        sender.command(0.0, STOP)
    elif fault == "switch":
        chair.press(True)
    elif fault == "kill":
        await asyncio.to_thread(chair.kill)
    elif fault != "silence":
        chair.far.set(fault, True)
    if fault in ("silence", "stop"):
        await asyncio.sleep(LOOK_ON)
    else:  # the sender knows nothing of it
        await sender.drive(SPEED, lambda: monotonic() > injured + LOOK_ON)
    late = watcher.late(injured, injured + LOOK_ON)
    if fault != "kill":
        late = max(late, waited(chair.pid) - before)
    lines = chair.since(injured - LINE_EVERY - late)
    after = [(one, other) for one, other in pairwise(lines) if other["t"] > injured]
    begun = next((other["t"] - injured for one, other in after if other["v"] < one["v"]), None)
    stood = chair.standing_since(injured)
    if begun is None or stood is None:
        result.violated(f"{name}: the chair went on")
    elif any(other["v"] > one["v"] for one, other in after):
        result.violated(f"{name}: the chair became faster")
    result.add(begun, None if stood is None else stood - injured, late)
    await _recover(fault, chair, sender)


async def _recover(fault, chair, sender):
    if fault == "switch":
        chair.press(False)
    elif fault == "kill":
        await asyncio.to_thread(chair.start)
    elif fault not in OF_EVERY_OUTPUT:
        chair.far.set(fault, False)
    sender.nonce = None


async def stop_at_outputs(runs, dice):
    """S6: Stop on the tablet, up to the first slower command at the far end of each output."""
    result = Result("Stop on the tablet, seen at the far end of each output", STOP_LIMIT)
    said = []
    for output, share in shares_of_outputs(runs).items():
        first = len(result.begun)
        await _stops_of(output, result, share, dice)
        times = sorted(result.begun[first:])
        if times:
            said.append(f"{output} {1e3 * times[math.ceil(0.99 * len(times)) - 1]:.0f} ms")
    result.remark = f"p99 of the first slower command: {', '.join(said)}; the second time is that of standstill"
    return result


async def _stops_of(output, result, runs, dice):
    with patch.dict(os.environ, NETWORK):
        async with rig(output=output) as made:
            for _ in range(runs):
                await injure_at_random(made, result, dice, lambda: made.control.call("stop", by="tablet"), nothing)
