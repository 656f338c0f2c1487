"""Drills of the shirt: no frame comes, frames are kept back, or sensors break."""

import asyncio
from contextlib import suppress

from drills.injury import A_TICK, COMMAND, injure_at_random
from drills.results import Result
from drills.rig import PARAMETERS, rig
from processes.running_control import clear

from app.clock import monotonic
from app.faults import State
from app.process.command_channel import LinkRefused


async def shirt_stalls(runs, dice):
    """S4: no frame comes any more."""
    result = Result("the shirt stalls", 0.21 + A_TICK + COMMAND)
    async with rig() as made:

        async def stall():
            made.shirt.stalled = True

        async def go_on():
            made.shirt.stalled = False
            await asyncio.sleep(1.2)  # until the lost frames no longer count

        for _ in range(runs):
            await injure_at_random(made, result, dice, stall, go_on)
    result.remark = "at 100 Hz"
    return result


async def shirt_kept_back(runs, dice):
    """S4, S23: the shirt's own signed frames are kept back for 0.3 to 3 s; they arm nothing and move nothing."""
    result = Result("the shirt's own frames are kept back, then it is armed and moved", 0.21 + A_TICK + COMMAND)
    asked = 0
    async with rig() as made:

        async def keep_back():
            made.shirt.kept_back = dice.uniform(0.3, 3.0)

        async def try_to_drive():
            nonlocal asked
            number = int(made.control.newest()["number"])
            until = monotonic() + made.shirt.kept_back + 2.0  # the neutral check, and the stroke on its way
            made.shirt.rest()
            while monotonic() < until:
                with suppress(LinkRefused):
                    await clear(made.control)
                    await made.control.call("arm", hash=PARAMETERS.hash)
                    asked += 1
                made.shirt.stroke()
                await asyncio.sleep(0.1)
            ticks = made.control.since(number)
            if (ticks["state"] == State.ARMED).any() or ticks["v"].any():
                result.violations.append(f"run {result.runs}: frames of the past armed or drove")
            made.shirt.rest()
            made.shirt.kept_back = 0.0
            await asyncio.sleep(1.2)  # until the lost frames no longer count

        for _ in range(runs):
            await injure_at_random(made, result, dice, keep_back, try_to_drive)
    result.remark = f"armed {asked} times meanwhile"
    return result


async def sensors_break(runs, dice):
    """S5: a channel of each of two gestures rails, goes flat, or is no number."""
    result = Result("sensors of two gestures rail, go flat, send NaN", 0.2 + 0.02 + A_TICK + COMMAND)
    joints = PARAMETERS.profile.joints
    async with rig() as made:

        async def heal():
            made.shirt.broken = {}
            await asyncio.sleep(0.3)

        for run in range(runs):
            kind = ("rail", "flat", "nan")[run % 3]
            pair = dice.sample(range(len(joints)), 2)

            async def break_(kind=kind, pair=pair):
                broken = {}
                for joint in (joints[i] for i in pair):
                    place = dice.randrange(len(joint.channels))
                    value = {"rail": 1e4, "flat": joint.mean[place], "nan": float("nan")}[kind]
                    broken[joint.channels[place]] = value
                made.shirt.broken = broken

            await injure_at_random(made, result, dice, break_, heal)
    result.remark = "flat counts after 200 ms; every channel and kind by itself: test_drive_modes.py"
    return result
