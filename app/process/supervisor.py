"""Starts and ends the control process, and notices when it dies."""

import asyncio
import os
import socket
import sys
import uuid
from contextlib import suppress
from dataclasses import dataclass
from subprocess import DEVNULL, Popen, TimeoutExpired

import numpy as np

from app.process.command_channel import ANSWER_LIMIT, ControlClient, LinkLost, Message
from app.process.ring import TickRing, Ticks
from app.texts import Text

START_LIMIT = 20.0  # s: enough for a cold start from a slow disk
# s, of commands whose answers have a limit of their own. `end_run` answers after the recording has been made compact.
LIMITS = {"end_run": 120.0, "stop": 2.0}
QUIT_LIMIT = 3.0  # s, in which the chair stops and an open recording is closed


@dataclass(frozen=True, slots=True)
class Launch:
    """A new control process, which loads its libraries before it takes commands; it ends when `link` is closed."""

    process: Popen[bytes]
    link: socket.socket  # our end
    ring: str  # name of the shared memory that it makes

    def close(self) -> None:
        """End the process, if it still runs."""
        self.link.close()
        try:
            self.process.wait(QUIT_LIMIT)
        except TimeoutExpired:
            self.process.kill()
            self.process.wait()


def launch(*options: str) -> Launch:
    """Launch a control process with these command line options; raise OSError when the system refuses."""
    ours, theirs = socket.socketpair()
    ring = f"bodydrive-{os.getpid()}-{uuid.uuid4().hex[:12]}"
    command = [sys.executable, "-m", "app.pipeline.process", "--link-fd", str(theirs.fileno()), "--ring", ring]
    try:
        process = Popen(
            [*command, *options],
            pass_fds=[theirs.fileno()],
            stdin=DEVNULL,
            start_new_session=True,  # Ctrl-C reaches the web process only, which then ends this process in order
        )
    except OSError:
        ours.close()
        raise
    finally:
        theirs.close()
    return Launch(process, ours, ring)


class ControlProcess:
    """The web process's handle of one running control process."""

    def __init__(self, process: Popen[bytes], client: ControlClient, ring: TickRing) -> None:
        self._process = process
        self.client = client
        self.ring = ring

    @classmethod
    async def start(cls, *options: str) -> "ControlProcess":
        """Start a control process with these command line options, and return when it takes commands.

        Raises
        ------
        LinkLost
            When it does not start.
        OSError
            When the system refuses another process.
        """
        return await cls.after(launch(*options))

    @classmethod
    async def after(cls, launch: Launch) -> "ControlProcess":
        """Return the handle of a new process when it takes commands; raise LinkLost when it never does."""
        client = await ControlClient.open(launch.link)
        try:
            await client.call("status", limit=START_LIMIT)
            ring = TickRing.attach(launch.ring)
        except (LinkLost, OSError) as error:
            await client.close()
            await _end(launch.process)
            raise LinkLost(Text("drives-process-not-started")) from error
        # Both processes have the memory open: without a name it is freed however the processes end.
        ring.unlink()
        return cls(launch.process, client, ring)

    @property
    def pid(self) -> int:
        """Number of the process."""
        return self._process.pid

    async def call(self, do: str, **fields: object) -> Message:
        """Send a command and return its answer; raise LinkRefused or LinkLost."""
        return await self.client.call(do, limit=LIMITS.get(do, ANSWER_LIMIT), **fields)

    def send(self, do: str, **fields: object) -> None:
        """Send a command without waiting for an answer; raise LinkLost when the process has ended."""
        self.client.send(do, **fields)

    def newest(self) -> np.void | None:
        """Return the newest tick, None before the first."""
        return self.ring.newest()

    def since(self, number: int) -> Ticks:
        """Return the ticks after `number` that the ring still holds."""
        return self.ring.since(number)[0]

    async def died(self) -> None:
        """Return when the process has ended or has closed its end of the channel."""
        ended = asyncio.ensure_future(asyncio.to_thread(self._process.wait))
        closed = asyncio.ensure_future(self.client.wait_closed())
        try:
            await asyncio.wait({ended, closed}, return_when=asyncio.FIRST_COMPLETED)
        finally:
            ended.cancel()
            closed.cancel()

    def kill(self) -> None:
        """Kill the process at once; a real chair then stops by its own watchdog. May be called from any thread."""
        self._process.kill()

    async def close(self) -> None:
        """Let the process stop the chair and end; release the ring's memory."""
        with suppress(LinkLost):
            self.client.send("quit")
        await self.client.close()
        await _end(self._process)
        self.ring.close()


async def _end(process: Popen[bytes]) -> None:
    """Wait until the process has ended; terminate it, then kill it, when it does not end by itself."""
    for end in (process.terminate, process.kill):
        try:
            await asyncio.to_thread(process.wait, QUIT_LIMIT)
        except TimeoutExpired:
            end()
        else:
            return
    await asyncio.to_thread(process.wait)
