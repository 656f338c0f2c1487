"""The drills of strangers: odd names of equipment, and somebody else who sends the shirt's frames."""

import asyncio
import socket
import struct
import zlib
from contextlib import suppress
from itertools import pairwise

import numpy as np
from drills.results import Result
from drills.rig import PARAMETERS, rig
from odd_values import odd_values
from processes.running_control import tick_with
from processes.wearer import RATE

from app.clock import monotonic
from app.faults import Fault, State
from app.hardware.chair.key import Key
from app.hardware.shirt.packet import encode
from app.hardware.shirt.sender import signed_frame
from app.link import LinkRefused

WHILE_DRIVING, WHILE_STANDING = 40, 20  # odd values in a run
LONGEST_GAP = 0.04  # s between two commands to the chair (S14)
FORGING = 1.5  # s of forged frames while the chair drives
HELD_UP = 0.1  # s: the gate stops for a shirt that is silent for 0.2 s
SILENCE = 2.6  # s without the shirt: longer than a sender was ever waited for
COUNTED = 1.2  # s for which lost frames count


async def odd_names(runs, dice):
    """S28: somebody types odd addresses, paths and names while the chair drives, and while it stands."""
    result = Result("odd equipment names while the chair drives", None)
    asked, longest = 0, 0.0
    async with rig() as made:
        for _ in range(runs):
            await made.cruise()
            began = monotonic()
            for value in dice.sample(odd_values(), WHILE_DRIVING):
                asked += await _ask_oddly(made, value)
            await asyncio.sleep(0.1)
            late = made.watcher.late(began, monotonic())
            sent = [t for t, _ in made.relay.commands_since(began)]
            longest = max([longest, *(after - before for before, after in pairwise(sent))])
            _look_whether_it_drives(made, result, late)
            if longest > LONGEST_GAP + late:
                result.violations.append(f"run {result.runs + 1}: {1e3 * longest:.0f} ms between two commands")
            result.add(None, late=late)
            await made.control.call("end_run")
            for value in dice.sample(odd_values(), WHILE_STANDING):
                asked += await _ask_oddly(made, value)
            await made.control.call("shirt", config=made.shirt_config)
            await made.control.call("parameters", parameters=PARAMETERS.model_dump(mode="json"))
            await tick_with(made.control, lambda tick: tick["has_frame"] and tick["chair_age"] < 0.3)
            await made.show_switch()
            await made.begin_run()
        # One control process did all this: a new one would have ended the rig's link with LinkLost.
    result.remark = f"{asked} commands, no restart; longest time between two commands {1e3 * longest:.0f} ms (limit 40)"
    return result


async def _ask_oddly(made, value):
    """Ask for equipment with this text in every field that takes one; return how many commands that were."""
    layout = made.shirt_config["layout"]
    commands = [
        ("shirt", {"kind": "udp", "host": value, "port": 0, "layout": layout}),
        ("shirt", {"kind": "replay", "file": value}),
        ("shirt", {"kind": "udp", "port": 0, "layout": {**layout, "name": value}, "key_file": value}),
        ("body", {"kind": "recorded", "file": value}),
        ("head", {"kind": "opentrack", "host": value, "port": 0}),
        ("head", {"kind": "flock_of_birds", "device": value}),
        ("chair", made.receiver.config(host=value)),
        ("chair", made.receiver.config(key_file=value)),
        ("chair", made.receiver.config(port=made.relay.port)),  # one that opened is not the rig's
    ]
    for do, config in commands:
        with suppress(LinkRefused):
            await made.control.call(do, config=config)
    return len(commands)


async def second_sender(runs, dice):
    """S23: somebody else sends to the shirt's port while the chair drives, and after the shirt fell silent."""
    result = Result("a second shirt sender while driving, and after the shirt fell silent", None)
    sent = 0
    async with rig() as made:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as forger:
            for _ in range(runs):
                await made.cruise()
                began, number = monotonic(), int(made.control.newest()["number"])
                sent += await _forge(made, dice, forger, began + FORGING)
                _look_whether_it_drives(made, result, made.watcher.late(began, monotonic()))
                made.wearer.stalled = True
                silent = monotonic() + 0.1  # so long its last frames may be on their way
                sent += await _forge(made, dice, forger, silent + SILENCE)
                ticks = made.control.since(number)
                frames = ticks[ticks["has_frame"] == 1]
                # A frame of the shirt's own says the time at which it was the shirt's turn to send it.
                if not np.allclose(frames["t_device"], frames["frame_seq"] / RATE, atol=1e-5):
                    result.violations.append(f"run {result.runs + 1}: a frame of somebody else was taken")
                if (frames["t"] > silent).any():
                    result.violations.append(f"run {result.runs + 1}: after the shirt fell silent a frame was taken")
                if made.control.newest()["state"] == State.ARMED or made.receiver.newest["v"]:
                    result.violations.append(f"run {result.runs + 1}: the chair drives without its shirt")
                result.add(None, late=made.watcher.late(began, monotonic()))
                made.wearer.stalled = False
                await tick_with(made.control, lambda tick: tick["has_frame"])
                await asyncio.sleep(COUNTED)
    result.remark = f"{sent} frames, none was taken; 12,000 by themselves: test_signed_shirt.py"
    return result


async def _forge(made, dice, forger, until):
    """Send forged frames until a moment; return how many."""
    sent = 0
    while monotonic() < until:
        for datagram in dice.choices(made.wearer.recent, k=20):
            forger.sendto(_forged(dice, datagram), ("127.0.0.1", made.shirt_port))
            sent += 1
        await asyncio.sleep(0.01)
    return sent


def _forged(dice, datagram):
    """Return a frame that the shirt does not send now: repeated, cut, unsigned, with another key, or changed."""
    channels = len(PARAMETERS.profile.layout.channels)
    kind = dice.randrange(5)
    if kind == 0:
        return datagram
    if kind == 1:
        return datagram[: dice.randrange(len(datagram))]
    if kind == 2:
        return encode(dice.randrange(2**32), 1.0, np.full(channels, dice.uniform(-3, 3), np.float32))
    if kind == 3:
        return signed_frame(Key(1, dice.randbytes(32)), 2, dice.randrange(2**32), 0, [dice.uniform(-3, 3)] * channels)
    changed = bytearray(datagram)
    changed[dice.randrange(len(changed) - 4)] ^= 1 << dice.randrange(8)
    changed[-4:] = struct.pack("<I", zlib.crc32(changed[:-4]))
    return bytes(changed)


def _look_whether_it_drives(made, result, late):
    """Note a drive that ended, unless the machine was `late` (s) for so long that the shirt could not send."""
    if late > HELD_UP:
        return
    if made.control.newest()["state"] != State.ARMED or made.receiver.newest["state"] != "armed":
        fault = Fault(int(made.control.newest()["fault"])).name
        result.violations.append(f"run {result.runs + 1}: the drive ended ({fault})")
