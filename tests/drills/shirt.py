"""Drills of the shirt: no frame comes, frames are kept back, sensors break or stick, or a connector is loose."""

import asyncio
from contextlib import suppress
from itertools import pairwise

from drills.injury import A_TICK, COMMAND, injure_at_random, setting
from drills.results import Result
from drills.rig import PARAMETERS, rig
from processes.running_control import clear
from processes.udp_shirt import RATE

from app.clock import monotonic
from app.faults import State
from app.process.command_channel import LinkRefused

LOOSE_TIME = 8.0  # s
LOOSE_SPEED, LOOSE_WAY = 0.1, 0.5  # m/s and m that a loose connector may give
STUCK_TIME = 0.3  # s over which the range of a stuck sensor is looked at


async def shirt_stalls(runs, dice):
    """S4: no frame comes any more."""
    result = Result("the shirt stalls", 0.21 + A_TICK + COMMAND)
    async with rig() as made:

        async def go_on():
            made.shirt.stalled = False
            await asyncio.sleep(1.2)  # until the lost frames no longer count

        for _ in range(runs):
            await injure_at_random(made, result, dice, setting(made.shirt, stalled=True), go_on)
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
    result.remark = f"arming was asked for {asked} times meanwhile, and never reached"
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


async def sensors_stick(runs, dice):
    """S5, S22: all sensors of the joints that brake stick, and show a bit of noise."""
    result = Result("sensors of the brake stick with a bit of noise", STUCK_TIME + 0.2 + A_TICK + COMMAND)
    joints = {gesture.name: gesture.joint for gesture in PARAMETERS.gestures}
    brakes = {joints[name] for one in PARAMETERS.bindings if one.control in {"u1-", "stop"} for name in one.gestures}
    async with rig() as made:

        async def stick():
            made.shirt.stick([i for joint in PARAMETERS.profile.joints if joint.name in brakes for i in joint.channels])

        async def heal():
            made.shirt.stuck = {}
            await asyncio.sleep(0.3)

        for _ in range(runs):
            await injure_at_random(made, result, dice, stick, heal)
    result.remark = "a tenth of the noise of a good sensor"
    return result


async def loose_connector(runs, dice):
    """S30: all channels of the joint that drives jump to and fro while its wearer rests."""
    result = Result(f"a connector of the joint that drives is loose for {LOOSE_TIME:g} s", None)
    elbow = next(joint for joint in PARAMETERS.profile.joints if joint.name == "right_elbow")
    fastest = longest = 0.0
    async with rig() as made:
        for run in range(runs):
            while not await made.arm():
                pass
            size = dice.uniform(0.043, 0.3)
            changes = {
                channel: size * elbow.span * weight
                for channel, weight in zip(elbow.channels, elbow.direction, strict=True)
            }
            began = monotonic()
            made.shirt.loose = round(dice.uniform(0.25, 1.0) * RATE), changes
            await asyncio.sleep(LOOSE_TIME)
            lines = made.receiver.since(began)
            speed = max(abs(line["v"]) for line in lines)
            way = sum(abs(before["v"]) * (after["t"] - before["t"]) for before, after in pairwise(lines))
            if speed > LOOSE_SPEED or way > LOOSE_WAY:
                result.violations.append(f"run {run + 1}: {size:.3f} FS gave {speed:.2f} m/s and {way:.2f} m")
            fastest, longest = max(fastest, speed), max(longest, way)
            result.add(None, made.chair_stopped(began)[1], made.watcher.late(began, monotonic()))
            made.shirt.loose = None
            await asyncio.sleep(2.5)  # until its last jump no longer counts
    result.remark = f"0.043 to 0.3 FS, 0.5 to 2 Hz; at most {fastest:.2f} m/s, {longest:.2f} m"
    return result
