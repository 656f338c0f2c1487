"""A real control process for tests, with a heartbeat."""

import asyncio
from contextlib import asynccontextmanager, suppress

import pytest

from app.faults import Fault, State
from app.process.command_channel import LinkLost, LinkRefused
from app.process.supervisor import ControlProcess

PATIENCE = 60.0  # s

SIMULATED = {"kind": "simulator", "sample_rate": 200.0, "seed": 1, "layout": None, "dead_channels": []}
ROOM = {
    "name": "room",
    "title": "Room",
    "walls": [[[-2.0, -2.0], [30.0, -2.0], [30.0, 2.0], [-2.0, 2.0], [-2.0, -2.0]]],
    "paths": [{"name": "ahead", "title": "Ahead", "points": [[1.0, 0.5], [20.0, 0.5]], "instruction": "Drive ahead."}],
}


@asynccontextmanager
async def running():
    """Yield a control process that gets heartbeats."""
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
            control.send("heartbeat", screen_age=0.0)
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


async def clear(control):
    """Clear a fault with the count of stops in the newest tick."""
    tick = control.newest()
    with suppress(LinkRefused):  # after another stop the next tick shows it
        await control.call("clear", stops=0 if tick is None else int(tick["stops"]))


async def armed(control, digest):
    """Arm, again after a fault on a busy machine, and wait until the gate is armed."""
    for _ in range(5):
        await clear(control)
        await control.call("arm", hash=digest)
        tick = await tick_with(control, lambda tick: tick["state"] in (State.ARMED, State.FAULT))
        if tick["state"] == State.ARMED:
            return
    raise AssertionError(f"the chair could not be armed: {Fault(int(tick['fault']))}")
