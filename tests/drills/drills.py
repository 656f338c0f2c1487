"""The drills: what is done to a chair that drives, and how long it may drive on."""

import asyncio
import os
import random
import resource
import signal
import struct
from itertools import pairwise
from pathlib import Path

import psutil
from drills.cuts import cuts
from drills.flood import sign_ins
from drills.relay import FAIR, Weather
from drills.results import Result
from drills.rig import AFTER, PARAMETERS, rig
from drills.second_socket import second_socket
from drills.session_end import session_end
from drills.strangers import odd_names, second_sender
from drills.uploads import upload_bombs
from processes.running_control import tick_with

from app.clock import monotonic
from app.faults import Fault, State

A_TICK = 0.02  # s: the loop's longest wait, or a step of the receiver and its line
HEARTBEAT = 0.05  # s between two of the drill's own
COMMAND = 0.02  # s between two commands
HELD_UP = (
    0.05  # s by which a busy machine makes commands so late that the chair slows, and rightly goes on when they come
)


async def _injure(made, result, dice, injury, recover, after=AFTER):
    """Bring the chair to cruise, injure something at a random moment, look on, and mend it."""
    await made.cruise()
    await asyncio.sleep(dice.uniform(0.0, 0.1))
    injured = monotonic()
    await injury()
    await asyncio.sleep(after)
    begun, disarmed = made.chair_stopped(injured)
    late = made.watcher.late(injured, injured + after)
    if begun is None or disarmed is None:
        result.violations.append(f"run {result.runs + 1}: the chair went on")
    elif made.went_on(injured, begun) and late < HELD_UP:
        result.violations.append(f"run {result.runs + 1}: the chair went on after it had begun to stop")
    result.add(begun, disarmed, late)
    await recover()


async def _nothing():
    pass


async def kill_control(runs, dice):
    """S3: kill -9 of the control process."""
    result = Result("kill -9 of the control process", 0.11 + COMMAND, 0.31 + COMMAND)
    async with rig() as made:

        async def again():
            await made.end_control()
            await made.start_control()

        for _ in range(runs):
            await _injure(made, result, dice, lambda: _signal(made.control.pid, signal.SIGKILL), again)
    return result


async def hold_control(runs, dice):
    """S15: SIGSTOP of the control process for 200 ms."""
    result = Result("SIGSTOP of the control process for 200 ms", 0.11 + COMMAND, 0.31 + COMMAND)
    async with rig() as made:

        async def hold():
            await _signal(made.control.pid, signal.SIGSTOP)
            await asyncio.sleep(0.2)
            await _signal(made.control.pid, signal.SIGCONT)

        for _ in range(runs):
            await _injure(made, result, dice, hold, _nothing)
    return result


async def kill_receiver(runs, dice):
    """S21: kill -9 of the receiver: its motors stand without it; the control process must notice."""
    result = Result("kill -9 of the receiver, noticed by the control process", 0.3 + A_TICK)
    async with rig() as made:
        for _ in range(runs):
            await made.cruise()
            await asyncio.sleep(dice.uniform(0.0, 0.1))
            newest = float(made.control.newest()["t"])
            killed = monotonic()
            await asyncio.to_thread(made.receiver.kill)
            await tick_with(made.control, lambda tick: tick["state"] == State.FAULT)
            ticks = made.control.since(0)
            fault = ticks[(ticks["t"] > newest) & (ticks["state"] == State.FAULT)][0]
            if fault["fault"] != Fault.CHAIR_SILENT:
                result.violations.append(f"run {result.runs + 1}: {Fault(int(fault['fault'])).name}")
            result.add(float(fault["t"]) - killed, late=made.watcher.late(killed, killed + 0.5))
            await asyncio.to_thread(made.receiver.start)
            await tick_with(made.control, lambda tick: tick["chair_age"] < 0.3 and tick["chair_state"] == 0)
    result.remark = "a receiver that is dead drives nothing: its output must stand by itself"
    return result


async def kill_web(runs, dice):
    """S14: kill -9 of the web process, and with it of the 3D scene, which lives in it."""
    result = Result("kill -9 of the web process (and of the scene in it)", 0.32)
    longest = 0.0
    async with rig(controlled=False) as made:
        for _ in range(runs):
            web = await made.start_web()
            await asyncio.sleep(dice.uniform(0.0, 0.1))
            killed = monotonic()
            web.kill()
            await asyncio.sleep(AFTER)
            await web.wait()
            begun, disarmed = made.chair_stopped(killed)
            late = made.watcher.late(killed - 0.4, killed + AFTER)
            if begun is None or (made.went_on(killed, begun) and late < HELD_UP):
                result.violations.append(f"run {result.runs + 1}: the chair went on")
            sent = [t for t, _ in made.relay.commands_since(killed - 0.3) if t <= killed + (begun or 0.0)]
            gaps = [after - before for before, after in pairwise(sent)]
            longest = max([longest, *gaps])
            if gaps and max(gaps) > 0.04 + late:
                result.violations.append(f"run {result.runs + 1}: {1e3 * max(gaps):.0f} ms between two commands")
            result.add(begun, disarmed, late)
    result.remark = f"longest time between two commands {1e3 * longest:.0f} ms (limit 40)"
    return result


async def web_silent(runs, dice):
    """S14: the web process, and the 3D scene that lives in it, says nothing any more."""
    result = Result("web process silent (held)", 0.32 + A_TICK + COMMAND)
    async with rig() as made:

        async def silence():
            made.beats = False

        async def speak():
            made.beats = True

        for _ in range(runs):
            await _injure(made, result, dice, silence, speak, after=1.0)
    return result


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

            async def injure(says=says):
                made.screen_age, made.screen = says

            await _injure(made, result, dice, injure, show)
    result.remark = "from when the web process knows it; its heartbeat adds up to 50 ms"
    return result


SCREENS = (
    ((0.31, "in view"), Fault.SCREEN_LOST),
    ((None, "in view"), Fault.SCREEN_LOST),
    ((0.0, "hidden"), Fault.SCREEN_HIDDEN),
    ((0.0, "slow"), Fault.SCREEN_SLOW),
)


async def tablet_stop(runs, dice):
    """S6: Stop, while the patient strokes on."""
    result = Result("Stop on the tablet", 0.025 + A_TICK, 0.025 + A_TICK)
    async with rig() as made:
        for _ in range(runs):
            await _injure(made, result, dice, lambda: made.control.call("stop", by="tablet"), _nothing)
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
            await _injure(made, result, dice, press, release)
    return result


async def shirt_stalls(runs, dice):
    """S4: no frame comes any more."""
    result = Result("the shirt stalls", 0.21 + A_TICK + COMMAND)
    async with rig() as made:

        async def stall():
            made.wearer.stalled = True

        async def go_on():
            made.wearer.stalled = False
            await asyncio.sleep(1.2)  # so long the frames that were lost count

        for _ in range(runs):
            await _injure(made, result, dice, stall, go_on)
    result.remark = "at 100 Hz"
    return result


async def sensors_break(runs, dice):
    """S5: a channel of each of two gestures rails, goes flat, or is no number."""
    result = Result("sensors of two gestures rail, go flat, send NaN", 0.2 + 0.02 + A_TICK + COMMAND)
    joints = PARAMETERS.profile.joints
    async with rig() as made:

        async def heal():
            made.wearer.broken = {}
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
                made.wearer.broken = broken

            await _injure(made, result, dice, break_, heal)
    result.remark = "flat counts after 200 ms; every channel and kind by itself: test_drive_modes.py"
    return result


async def disk_full(runs, dice):
    """S17: the recording can no longer be written."""
    result = Result("disk full while driving", None)
    async with rig() as made:
        for _ in range(runs):
            await made.cruise()
            process = psutil.Process(made.control.pid)
            full = monotonic()
            process.rlimit(psutil.RLIMIT_FSIZE, (1, resource.RLIM_INFINITY))
            await tick_with(made.control, lambda tick: tick["state"] == State.FAULT)
            tick = made.control.newest()
            if tick["fault"] != Fault.RECORDING_LOST:
                result.violations.append(f"run {result.runs + 1}: {Fault(int(tick['fault'])).name}")
            await asyncio.sleep(AFTER)
            begun, disarmed = made.chair_stopped(full)
            _look_for_jerks(made, full, result)
            result.add(begun, disarmed)
            process.rlimit(psutil.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
            await made.end_control()
            await made.start_control()
    result.remark = "files could grow no more; found out at the next writing to disk (0.5 s), then a ramp like any stop"
    return result


def _look_for_jerks(made, since, result):
    lines = made.receiver.since(since)
    for before, after in pairwise(lines):
        change = abs(after["v"] - before["v"])
        if change > 6.0 * (after["t"] - before["t"] + 0.012):  # the firmest stop: 1.5 m/s in 0.25 s, a step's slack
            result.violations.append(f"run {result.runs + 1}: a jerk of {change:.2f} m/s")
            return


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
                made.wearer.stroke()
                await asyncio.sleep(0.5)
            made.relay.weather = FAIR
            stops += made.receiver.newest["state"] != "armed"
            _look_for_jerks(made, began, result)
            _look_for_freedom(made, began, result)
            result.add(None, late=made.watcher.late(began, monotonic()))
    result.remark = f"3 s each; {stops} of them stopped the chair; never faster than the commands of the last 100 ms"
    return result


def _look_for_freedom(made, since, result):
    """Find a moment in which the chair went faster than any command that had reached it just before."""
    commands = [
        (t, abs(struct.unpack_from("<f", datagram, 28)[0])) for t, datagram in made.relay.commands_since(since - 0.5)
    ]
    for line in made.receiver.since(since):
        recent = [v for t, v in commands if line["t"] - 0.25 <= t <= line["t"] + 0.005 and v < 10]
        if line["v"] and line["state"] == "armed" and recent and line["v"] > max(recent) + 0.02:
            result.violations.append(f"run {result.runs + 1}: {line['v']:.2f} m/s that nobody commanded")
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
                result.violations.append(f"run {result.runs + 1}: the drive ended ({fault})")
            _look_for_freedom(made, began, result)
            _look_for_jerks(made, began, result)
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


async def wall_clock(runs, dice):
    """S16: the wall clock jumps by a day, and the time zone changes."""
    folder = Path(__file__).parent / "jumping_clock"
    before = os.environ.get("PYTHONPATH", ""), os.environ.get("TZ")
    os.environ["PYTHONPATH"] = f"{folder}{os.pathsep}{before[0]}"
    os.environ["TZ"] = "Pacific/Kiritimati"
    result = Result("wall clock jumps by a day, other time zone", None)
    try:
        async with rig() as made:
            for _ in range(runs):
                await made.cruise()
                began = monotonic()
                await asyncio.sleep(2.0)
                if made.control.newest()["state"] != State.ARMED or made.receiver.newest["state"] != "armed":
                    result.violations.append(f"run {result.runs + 1}: the drive ended")
                _look_for_jerks(made, began, result)
                result.add(None, late=made.watcher.late(began, monotonic()))
    finally:
        os.environ["PYTHONPATH"] = before[0]
        os.environ.pop("TZ")
        if before[1] is not None:
            os.environ["TZ"] = before[1]
    result.remark = "time.time() of both processes jumps at each call; the machine's own clock is not set"
    return result


async def _signal(pid, which):
    os.kill(pid, which)


DRILLS = {
    "cuts": (cuts, 1000, 4),
    "kill-control": (kill_control, 100, 1),
    "hold-control": (hold_control, 100, 1),
    "kill-receiver": (kill_receiver, 100, 1),
    "kill-web": (kill_web, 100, 1),
    "web-silent": (web_silent, 100, 1),
    "screen": (screen_gone, 100, len(SCREENS)),
    "second-socket": (second_socket, 20, 1),
    "stop": (tablet_stop, 100, 1),
    "sign-ins": (sign_ins, 30, 1),
    "switch": (chair_switch, 100, 1),
    "shirt": (shirt_stalls, 50, 1),
    "sensors": (sensors_break, 60, 3),
    "disk": (disk_full, 20, 1),
    "disk-end": (session_end, 10, 1),
    "weather": (weather, 60, 1),
    "forgeries": (forgeries, 20, 1),
    "clock": (wall_clock, 20, 1),
    "names": (odd_names, 20, 1),
    "second-sender": (second_sender, 20, 1),
    "uploads": (upload_bombs, 34, 2),
}
"""Name: the drill, its runs in full, its runs in the short form."""


def run_drill(name, runs, seed):
    """Run one drill in this process; return its result."""
    drill, *_ = DRILLS[name]
    return asyncio.run(drill(runs, random.Random(seed)))
