"""The drill of a second sender, which sends forged frames of the shirt."""

import asyncio
import socket
import struct
import zlib

import numpy as np
from drills.injury import look_whether_it_drives
from drills.results import Result
from drills.rig import PARAMETERS, rig
from processes.running_control import tick_with
from processes.udp_shirt import RATE

from app.clock import monotonic
from app.faults import State
from app.hardware.chair.key import Key
from app.hardware.shirt.packet import encode
from app.hardware.shirt.sender import signed_frame

FORGERY_TIME = 1.5  # s of forged frames while the chair drives
SILENCE = 2.6  # s without a frame of the shirt: longer than the 2 s after which a second sender once became the shirt
LOSS_MEMORY = 1.2  # s for which the chain counts lost frames


async def second_sender(runs, dice):
    """S23: a second sender sends to the port of the shirt while the chair drives, and after the shirt fell silent."""
    result = Result("a second shirt sender while driving, and after the shirt fell silent", None)
    sent = 0
    async with rig() as made:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as forger:
            for _ in range(runs):
                await made.cruise()
                began, number = monotonic(), int(made.control.newest()["number"])
                sent += await _forge(made, dice, forger, began + FORGERY_TIME)
                look_whether_it_drives(made, result, made.watcher.late(began, monotonic()))
                made.shirt.stalled = True
                silent = monotonic() + 0.1  # until then the last frames of the shirt may arrive
                sent += await _forge(made, dice, forger, silent + SILENCE)
                ticks = made.control.since(number)
                frames = ticks[ticks["has_frame"] == 1]
                # In a frame of the shirt, the device time belongs to the sequence number.
                if not np.allclose(frames["t_device"], frames["frame_seq"] / RATE, atol=1e-5):
                    result.violated("a frame of somebody else was taken")
                if (frames["t"] > silent).any():
                    result.violated("after the shirt fell silent a frame was taken")
                if made.control.newest()["state"] == State.ARMED or made.receiver.newest["v"]:
                    result.violated("the chair drives without its shirt")
                result.add(None, late=made.watcher.late(began, monotonic()))
                made.shirt.stalled = False
                await tick_with(made.control, lambda tick: tick["has_frame"])
                await asyncio.sleep(LOSS_MEMORY)
    result.remark = f"{sent} frames, none was taken; 12,000 by themselves: test_signed_shirt.py"
    return result


async def _forge(made, dice, forger, until):
    """Send forged frames until the time `until` (monotonic s); return their number."""
    sent = 0
    while monotonic() < until:
        for datagram in dice.choices(made.shirt.recent, k=20):
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
