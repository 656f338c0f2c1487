"""S3: the network is cut at a random moment. Each chair has its own sender, so that several are cut at once."""

import asyncio
import random
import tempfile
from contextlib import asynccontextmanager, closing
from itertools import pairwise
from pathlib import Path

from drills.results import SIDE_BY_SIDE, Result, Watcher, shares, waited
from processes.chair_process import ReceiverProcess

from app.clock import monotonic
from app.hardware.chair.key import read_key
from app.hardware.chair.packet import DRIVE, ChairCommand, decode_telemetry, encode_command, encode_hello

PERIOD = 0.02  # s between two commands
LOOK_ON = 0.62  # s of observation after a cut
PATIENCE = 2.0  # s for an arming, and for a speed to be reached
LINE_EVERY = 0.15  # s: longest time between two lines of the receiver
SPEED, ALMOST = 0.8, 0.799  # m/s: a command carries them as float32
ARMED = 2  # of a telemetry


class Sender(asyncio.DatagramProtocol):
    """Drives a receiver at 50 Hz."""

    def __init__(self, key, dice):
        self._key, self._dice = key, dice
        self._sequence = self._epoch = 0
        self.nonce = None
        self.state = None

    def connection_made(self, transport):
        self._transport = transport

    def datagram_received(self, datagram, _address):
        telemetry = decode_telemetry(datagram, self._key)
        if telemetry is not None:
            self.nonce, self.state = telemetry.nonce, telemetry.state

    def ask(self):
        self._transport.sendto(encode_hello(self._key.id))

    def begin(self):
        self._epoch = self._dice.randrange(1, 2**32)

    def command(self, v, flags=DRIVE):
        self._sequence += 1
        t = monotonic()
        command = ChairCommand(
            flags, self._key.id, self._epoch, self._sequence, int(t * 1e9), v, 0.0, 1.5, 2.5, b"practise"
        )
        self._transport.sendto(encode_command(command, self._key, self.nonce))
        return t

    async def drive(self, v, until):
        """Send one speed until a condition holds; return when the last command was sent, None when it never held."""
        due = last = monotonic()
        patience = due + PATIENCE
        while not until():
            if monotonic() > patience:
                return None
            last = self.command(v)
            due = max(due + PERIOD, monotonic())
            await asyncio.sleep(due - monotonic())
        return last


@asynccontextmanager
async def sender_of(receiver, dice):
    """Yield what drives this receiver; afterwards both are closed."""
    key = read_key(receiver.key_file)
    address = ("127.0.0.1", receiver.config()["port"])
    loop = asyncio.get_running_loop()
    transport, sender = await loop.create_datagram_endpoint(lambda: Sender(key, dice), remote_addr=address)
    try:
        yield sender
    finally:
        transport.close()
        await asyncio.to_thread(receiver.close)


async def driven(receiver, sender, dice, speed, almost):
    """Arm and drive for a moment, at `almost` a speed at least; return when the last command was sent."""
    while True:  # a busy machine may disarm the chair
        while sender.nonce is None or sender.state != 0:
            sender.ask()
            await asyncio.sleep(0.05)
        sender.begin()
        if await sender.drive(0.0, lambda: sender.state == ARMED) is not None:
            length = monotonic() + dice.uniform(0.3, 0.4)
            last = await sender.drive(speed, lambda end=length: monotonic() > end and receiver.newest["v"] > almost)
            if last is not None:
                return last
        sender.nonce = None


async def cuts(runs, dice):
    """Cut, in all `runs` times."""
    result = Result("network cut at a random moment", 0.11, 0.31)
    with closing(Watcher()) as watcher:
        await asyncio.gather(*(_cut(result, watcher, share, dice.random()) for share in shares(runs)))
    result.remark = f"{SIDE_BY_SIDE} chairs side by side; from the last command that was sent"
    return result


async def _cut(result, watcher, runs, seed):
    dice = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="bodydrive-cut-") as folder:
        receiver = await asyncio.to_thread(ReceiverProcess, Path(folder))
        async with sender_of(receiver, dice) as sender:
            for _ in range(runs):
                await _one(result, watcher, receiver, sender, dice)


async def _one(result, watcher, receiver, sender, dice):
    cut = await driven(receiver, sender, dice, SPEED, ALMOST)
    before = waited(receiver.pid)
    await asyncio.sleep(LOOK_ON)
    late = max(watcher.late(cut, cut + LOOK_ON), waited(receiver.pid) - before)
    lines = receiver.since(cut - LINE_EVERY)
    # A first step can be very short and reduce the speed very little, so any decrease counts as the beginning.
    said = [(before, after) for before, after in pairwise(lines) if after["t"] > cut]
    begun = next((after["t"] - cut for before, after in said if after["v"] < before["v"]), None)
    disarmed = next((after["t"] - cut for _, after in said if after["state"] == "disarmed"), None)
    if begun is None or disarmed is None or receiver.newest["v"]:
        result.violated("the chair went on")
    result.add(begun, disarmed, late)
