"""Drills of immediate stops: the screen that armed the chair, Stop on the tablet, the chair's own switch."""

from drills.injury import A_TICK, COMMAND, HEARTBEAT, injure_at_random, nothing, setting
from drills.results import Result
from drills.rig import rig
from processes.running_control import tick_with

from app.faults import Fault

SCREENS = (
    ((0.31, "in view"), Fault.SCREEN_LOST),
    ((None, "in view"), Fault.SCREEN_LOST),
    ((0.0, "hidden"), Fault.SCREEN_HIDDEN),
    ((0.0, "slow"), Fault.SCREEN_SLOW),
)


async def screen_gone(runs, dice):
    """S7: the screen that armed the chair is out of reach, is hidden, or stands still; each has its own fault."""
    result = Result("screen out of reach, hidden, standing still, in turn", HEARTBEAT + A_TICK + COMMAND)
    async with rig() as made:

        async def show():
            fault = Fault(int(made.control.newest()["fault"]))
            if fault is not wanted:
                result.violations.append(f"run {result.runs}: {fault.name} instead of {wanted.name}")
            made.screen_age, made.screen = 0.0, "in view"

        for run in range(runs):
            says, wanted = SCREENS[run % len(SCREENS)]
            injury = setting(made, screen_age=says[0], screen=says[1])
            await injure_at_random(made, result, dice, injury, show)
    result.remark = "from when the web process knows it; its heartbeat adds up to 50 ms"
    return result


async def tablet_stop(runs, dice):
    """S6: Stop, while the patient strokes on."""
    result = Result("Stop on the tablet", 0.025 + A_TICK, 0.025 + A_TICK)
    async with rig() as made:
        for _ in range(runs):
            await injure_at_random(made, result, dice, lambda: made.control.call("stop", by="tablet"), nothing)
    return result


async def chair_switch(runs, dice):
    """S6, S21: the chair's own stop switch."""
    result = Result("the chair's own stop switch", 0.02 + A_TICK, 0.02 + A_TICK)
    async with rig() as made:

        async def press():
            made.receiver.press(True)

        async def release():
            made.receiver.press(False)
            await tick_with(made.control, lambda tick: tick["stop_input"] == 0 and tick["chair_state"] == 0)

        for _ in range(runs):
            await injure_at_random(made, result, dice, press, release)
    return result
