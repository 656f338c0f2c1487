"""Faults of each output at random moments: no far end holds its speed. And Stop on the tablet, up to the far end."""

import asyncio
import math
import random
import tempfile
from contextlib import closing
from itertools import pairwise
from pathlib import Path

from drills.far_chairs import FAR_ENDS, LINE_EVERY, FarChair
from drills.injury import injure_at_random, nothing
from drills.network_cuts import Sender
from drills.results import Result, Watcher, waited
from drills.rig import rig

from app.clock import monotonic
from app.hardware.chair.key import read_key
from app.hardware.chair.packet import STOP

OF_EVERY_OUTPUT = ("silence", "stop", "switch")
LOOK_ON = 0.75  # s of observation after a fault
SPEED, ALMOST = 0.3, 0.29  # m/s: what is commanded without a chair document; LUCI takes whole percents
ARMED = 2  # of a telemetry
LONGEST_HOLD = 0.3  # s
STOP_LIMIT = 0.06  # s


def distributed(runs):
    """Return, for each output that this machine has, how many of the runs are its own."""
    names = list(FAR_ENDS)
    return {name: len(range(number, runs, len(names))) for number, name in enumerate(names) if number < runs}


async def output_faults(runs, dice):
    """S3, S6, S21: each fault that can reach the far end, of each output, in turn."""
    result = Result("faults of each output, seen at its far end", LONGEST_HOLD)
    shares = distributed(runs)
    with closing(Watcher()) as watcher:
        of_outputs = (_faults_of(name, result, watcher, share, dice.random()) for name, share in shares.items())
        await asyncio.gather(*of_outputs)
    result.remark = (
        f"{', '.join(f'{name} {share}' for name, share in shares.items())}; the second time is that of standstill. "
        "Left out: what cuts a WHILL, LUCI or ROS 2 off, so that only they themselves can stop"
    )
    return result


async def _faults_of(output, result, watcher, runs, seed):
    dice = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="bodydrive-output-") as folder:
        chair = await asyncio.to_thread(FarChair, Path(folder), output)
        address = ("127.0.0.1", chair.config()["port"])
        loop = asyncio.get_running_loop()
        key = read_key(chair.key_file)
        transport, sender = await loop.create_datagram_endpoint(lambda: Sender(key, dice), remote_addr=address)
        faults = (*OF_EVERY_OUTPUT, *chair.far.faults)
        try:
            for run in range(runs):
                await _one(f"{output}, {faults[run % len(faults)]}", result, watcher, chair, sender, dice)
        finally:
            transport.close()
            await asyncio.to_thread(chair.close)


async def _driven(chair, sender, dice):
    """Arm and drive for a moment."""
    while True:  # a busy machine may disarm the chair
        while sender.nonce is None or sender.state != 0:
            sender.ask()
            await asyncio.sleep(0.05)
        sender.begin()
        if await sender.drive(0.0, lambda: sender.state == ARMED) is not None:
            length = monotonic() + dice.uniform(0.3, 0.4)
            moves = await sender.drive(SPEED, lambda end=length: monotonic() > end and chair.newest["v"] > ALMOST)
            if moves is not None:
                return
        sender.nonce = None


async def _one(name, result, watcher, chair, sender, dice):
    fault = name.rpartition(" ")[2]
    await _driven(chair, sender, dice)
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
    for output, share in distributed(runs).items():
        first = len(result.begun)
        await _stops_of(output, result, share, dice)
        times = sorted(result.begun[first:])
        if times:
            said.append(f"{output} {1e3 * times[math.ceil(0.99 * len(times)) - 1]:.0f} ms")
    result.remark = f"p99 of the first slower command: {', '.join(said)}; the second time is that of standstill"
    return result


async def _stops_of(output, result, runs, dice):
    async with rig(output=output) as made:
        for _ in range(runs):
            await injure_at_random(made, result, dice, lambda: made.control.call("stop", by="tablet"), nothing)
