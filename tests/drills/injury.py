"""One injected fault while a chair cruises, and the checks of all drills: jerks, and drives that ended."""

import asyncio
from itertools import pairwise

from drills.rig import AFTER

from app.clock import monotonic
from app.faults import Fault, State

A_TICK = 0.02  # s: the longest wait of the control loop, or a step of the receiver and its line
HEARTBEAT = 0.05  # s between two heartbeats of the drill
COMMAND = 0.02  # s between two commands
LATE_MACHINE = 0.05  # s: with this lateness of the machine the chair may slow and speed up again
STARVED_SHIRT = 0.1  # s: with this lateness the shirt may not send, and the gate stops after 0.2 s


async def injure_at_random(made, result, dice, injury, recover, after=AFTER):
    """Bring the chair to cruise, inject the fault at a random moment, observe, and recover."""
    await made.cruise()
    await asyncio.sleep(dice.uniform(0.0, 0.1))
    injured = monotonic()
    await injury()
    await asyncio.sleep(after)
    begun, disarmed = made.chair_stopped(injured)
    late = made.watcher.late(injured, injured + after)
    if begun is None or disarmed is None:
        result.violated("the chair went on")
    elif made.went_on(injured, begun) and late < LATE_MACHINE:
        result.violated("the chair went on after it had begun to stop")
    result.add(begun, disarmed, late)
    await recover()


def setting(target, **values):
    """Return what injures or recovers by setting attributes."""

    async def set_all():
        for name, value in values.items():
            setattr(target, name, value)

    return set_all


async def nothing():
    """Inject or recover nothing."""


def look_for_jerks(made, since, result):
    """Add a violation when the speed of the chair changed faster than in the fastest stop since `since` (s)."""
    lines = made.receiver.since(since)
    for before, after in pairwise(lines):
        change = abs(after["v"] - before["v"])
        if change > 6.0 * (after["t"] - before["t"] + 0.012):  # the fastest stop: 1.5 m/s in 0.25 s, plus one step
            result.violated(f"a jerk of {change:.2f} m/s")
            return


def look_whether_it_drives(made, result, late):
    """Add a violation when the chair no longer drives, unless the machine was too `late` (s)."""
    if late > STARVED_SHIRT:
        return
    if made.control.newest()["state"] != State.ARMED or made.receiver.newest["state"] != "armed":
        fault = Fault(int(made.control.newest()["fault"])).name
        result.violated(f"the drive ended ({fault})")
