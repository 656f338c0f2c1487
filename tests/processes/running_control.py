"""A real control process for tests, with a heartbeat."""

import asyncio
from contextlib import asynccontextmanager, suppress

import pytest
from processes.udp_shirt import UdpShirtSender, free_port, shirt_config

from app.faults import Fault, State
from app.process.command_channel import LinkLost, LinkRefused
from app.process.supervisor import ControlProcess
from app.session.control_link import ControlLink

PATIENCE = 60.0  # s

SIMULATED = {"kind": "simulator", "sample_rate": 200.0, "seed": 1, "layout": None, "dead_channels": []}
ROOM = {
    "name": "room",
    "title": "Room",
    "walls": [[[-2.0, -2.0], [30.0, -2.0], [30.0, 2.0], [-2.0, 2.0], [-2.0, -2.0]]],
    "paths": [{"name": "ahead", "title": "Ahead", "points": [[1.0, 0.5], [20.0, 0.5]], "instruction": "Drive ahead."}],
}


IN_VIEW = {"screen_age": 0.0, "screen": "in view"}


@asynccontextmanager
async def running(screen=IN_VIEW):
    """Yield a control process that gets heartbeats, which say of the screen what stands in `screen`; None: none."""
    control = await ControlProcess.start()
    heart = asyncio.create_task(beat(control, screen) if screen else asyncio.sleep(0))
    try:
        yield control
    finally:
        heart.cancel()
        await asyncio.gather(heart, return_exceptions=True)
        await control.close()


async def beat(control, screen=IN_VIEW):
    with suppress(LinkLost):
        while True:
            control.send("heartbeat", **screen)
            await asyncio.sleep(0.05)


@asynccontextmanager
async def linked():
    """Yield a link to a control process with the simulated shirt, the processes that it starts, and its states."""
    opened, states = [], []

    async def start_process():
        opened.append(await ControlProcess.start())
        return opened[-1]

    async def note(state):
        states.append(state)

    control = ControlLink(start_process)
    await control.start()
    try:
        control.on_change.append(note)
        await control.load("shirt", config=SIMULATED)
        await until(lambda: control.newest() is not None)
        yield control, opened, states
    finally:
        await control.close()


@asynccontextmanager
async def worn(control, parameters, key_file=None):
    """Give a control process a shirt over UDP and parameters; yield the shirt, which sends."""
    port = free_port()
    shirt = UdpShirtSender(parameters, port, key_file)
    try:
        await control.call("shirt", config=shirt_config(parameters, port, key_file))
        loaded = await control.call("parameters", parameters=parameters.model_dump(mode="json"))
        assert loaded["hash"] == parameters.hash
        yield shirt
    finally:
        await asyncio.to_thread(shirt.close)


async def until(condition):
    for _ in range(int(PATIENCE / 0.01)):
        if condition():
            return
        await asyncio.sleep(0.01)
    raise AssertionError(f"it did not happen within {PATIENCE:g} s")


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
