"""Drills of the network between control process and receiver: datagrams are lost, late or forged."""

import asyncio
import random
import struct

from drills.injury import look_for_jerks
from drills.relay import FAIR, Weather
from drills.results import Result
from drills.rig import PARAMETERS, rig
from processes.running_control import clear, tick_with

from app.clock import monotonic
from app.faults import Fault, State
from app.process.command_channel import LinkRefused

STOP_INPUT_AT = 48  # byte of a telemetry
TELLINGS = 10  # of a recorded telemetry, 0.1 s apart

WEATHERS = {
    "drop 10 %": Weather(drop=0.1),
    "duplicate 30 %, reorder within 30 ms": Weather(duplicate=0.3, delay=0.03),
    "corrupt 20 %": Weather(corrupt=0.2),
    "bursts up to 0.4 s": Weather(burst=0.02, burst_time=0.4),
    "all of it": Weather(drop=0.05, duplicate=0.1, corrupt=0.1, delay=0.05, burst=0.01, burst_time=0.4),
    "delayed by up to 250 ms": Weather(delay=0.25),
}


async def weather(runs, dice):
    """S3, S8: a bad network. It may stop the chair; nothing but a valid, newest command drives it."""
    result = Result("lossy network: " + "; ".join(WEATHERS), None)
    stops = 0
    async with rig(seed=dice.randrange(1000)) as made:
        for run in range(runs):
            made.relay.weather = FAIR
            await made.cruise()
            made.relay.weather = list(WEATHERS.values())[run % len(WEATHERS)]
            began = monotonic()
            for _ in range(6):
                made.shirt.stroke()
                await asyncio.sleep(0.5)
            made.relay.weather = FAIR
            stops += made.receiver.newest["state"] != "armed"
            look_for_jerks(made, began, result)
            _look_for_freedom(made, began, result)
            result.add(None, late=made.watcher.late(began, monotonic()))
    result.remark = f"3 s each; {stops} of them stopped the chair; never faster than the commands of the last 100 ms"
    return result


def _look_for_freedom(made, since, result):
    """Find a moment at which the chair was faster than every recent command that had reached it."""
    commands = [
        (t, abs(struct.unpack_from("<f", datagram, 28)[0])) for t, datagram in made.relay.commands_since(since - 0.5)
    ]
    for line in made.receiver.since(since):
        recent = [v for t, v in commands if line["t"] - 0.25 <= t <= line["t"] + 0.005 and v < 10]
        if line["v"] and line["state"] == "armed" and recent and line["v"] > max(recent) + 0.02:
            result.violated(f"{line['v']:.2f} m/s that nobody commanded")
            return


async def forgeries(runs, dice):
    """S13: thousands of forged, replayed and broken commands a second, while the chair drives."""
    result = Result("forged, replayed, old and broken commands while driving", None)
    sent = 0
    async with rig() as made:
        for _ in range(runs):
            await made.cruise()
            began = monotonic()
            captured = [datagram for _, datagram in made.relay.passed[-3000:]]
            while monotonic() - began < 2.0:
                for _ in range(40):
                    made.relay.inject(_forged(dice, dice.choice(captured)))
                    sent += 1
                await asyncio.sleep(0.01)
            if made.control.newest()["state"] != State.ARMED or made.receiver.newest["state"] != "armed":
                fault = Fault(int(made.control.newest()["fault"])).name
                result.violated(f"the drive ended ({fault})")
            _look_for_freedom(made, began, result)
            look_for_jerks(made, began, result)
            result.add(None, late=made.watcher.late(began, monotonic()))
    result.remark = f"{sent} of them, none had an effect; 12,000 by themselves: test_receiver_forgeries.py"
    return result


def _forged(dice, datagram):
    kind = dice.randrange(4)
    if kind == 0:
        return datagram  # a replay
    if kind == 1:
        return datagram[: dice.randrange(len(datagram))]
    changed = bytearray(datagram)
    if kind == 2:
        changed[dice.randrange(len(changed))] ^= 1 << dice.randrange(8)
    else:
        changed[28:36] = random.Random(dice.random()).randbytes(8)
    return bytes(changed)


async def recorded_switch(runs, dice):
    """S10, S13: a recorded telemetry that shows the switch pressed, in place of a chair that is cut off."""
    result = Result("a recording of the chair's pressed switch, then arming in acceleration mode", None)
    refused = old = 0
    async with rig(seed=dice.randrange(1000)) as made:
        for run in range(runs):
            pressed = next(told for told in reversed(made.relay.told) if told[STOP_INPUT_AT])
            if run % 2:
                await made.cruise()  # the chair has another nonce afterwards
            await made.end_control()
            await made.start_control(switch=False)
            made.relay.cut = True
            await asyncio.sleep(0.4)  # until another nonce than the newest is taken
            for _ in range(TELLINGS):  # again: on a busy machine the silence may begin later
                made.relay.notify(pressed)
                await asyncio.sleep(0.1)
            old += made.control.newest()["stop_input"] != 1  # a newer one of the same nonce came before the cut
            made.relay.cut = False
            await tick_with(made.control, lambda tick: tick["stop_input"] == 0 and tick["chair_state"] == 0)
            number, began = int(made.control.newest()["number"]), monotonic()
            try:
                await clear(made.control)
                await made.control.call("arm", hash=PARAMETERS.hash)
                made.shirt.stroke()
                await tick_with(made.control, lambda tick: tick["state"] in (State.ARMED, State.FAULT))
            except LinkRefused:
                refused += 1
            if (made.control.since(number)["state"] == State.ARMED).any():
                result.violated("armed by a recording of the switch")
            result.add(None, late=made.watcher.late(began, monotonic()))
            made.shirt.rest()
            await made.show_switch()
    result.remark = (
        f"{refused} refused at once; the others did not become ready; {old} recordings were too old to be seen"
    )
    return result
