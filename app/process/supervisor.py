"""Starts the control process and ends it, and is told when it dies."""

import asyncio
import os
import socket
import sys
import uuid
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from app.process.command_channel import ANSWER_LIMIT, ControlClient, LinkLost, Message
from app.process.ring import TickRing, Ticks

START_LIMIT = 20.0  # s: a cold start from a slow disk
# s, where an answer may take longer than that of other commands, or must not.
LIMITS = {"end_run": 120.0, "stop": 2.0}  # hours of recording are made compact before the answer comes
QUIT_LIMIT = 3.0  # s: the chair comes to its stop, an open recording is closed


class ControlProcess:
    """One running control process, seen from the web process."""

    def __init__(self, process: asyncio.subprocess.Process, client: ControlClient, ring: TickRing) -> None:
        self._process = process
        self.client = client
        self.ring = ring

    @classmethod
    async def start(cls, *options: str) -> "ControlProcess":
        """Start one, with further command line options, and return when it takes commands.

        Raises
        ------
        LinkLost
            When it does not come up.
        """
        ours, theirs = socket.socketpair()
        name = f"bodydrive-{os.getpid()}-{uuid.uuid4().hex[:12]}"
        try:
            process = await asyncio.create_subprocess_exec(
                *_command(theirs.fileno(), name, options),
                pass_fds=[theirs.fileno()],
                stdin=asyncio.subprocess.DEVNULL,
                start_new_session=True,  # Ctrl-C is for the web process, which then ends this one in order
            )
        except OSError:
            ours.close()
            raise
        finally:
            theirs.close()
        client = await ControlClient.open(ours)
        try:
            await client.call("status", limit=START_LIMIT)
            ring = TickRing.attach(name)
        except (LinkLost, OSError) as error:
            await client.close()
            await _end(process)
            raise LinkLost("The control process did not start: look for its message on the console.") from error
        # Both ends hold the memory now: without a name it cannot be left behind, however the processes end.
        ring.unlink()
        return cls(process, client, ring)

    @property
    def pid(self) -> int:
        """Number of the process."""
        return self._process.pid

    async def call(self, do: str, **fields: Any) -> Message:
        """Send a command and return its answer; raise LinkRefused or LinkLost."""
        return await self.client.call(do, limit=LIMITS.get(do, ANSWER_LIMIT), **fields)

    def tell(self, do: str, **fields: Any) -> None:
        """Send a command that wants no answer; raise LinkLost when the process is gone."""
        self.client.send(do, **fields)

    def newest(self) -> np.void | None:
        """Return the newest tick, None before the first."""
        return self.ring.newest()

    def since(self, number: int) -> Ticks:
        """Return the ticks after `number`, as many as the ring still holds."""
        return self.ring.since(number)[0]

    async def died(self) -> None:
        """Return when the process has ended, or has closed its link, which is the same to us."""
        ended = asyncio.ensure_future(self._process.wait())
        closed = asyncio.ensure_future(self.client.wait_closed())
        try:
            await asyncio.wait({ended, closed}, return_when=asyncio.FIRST_COMPLETED)
        finally:
            ended.cancel()
            closed.cancel()

    def kill(self) -> None:
        """End the process at once, whatever it does; a chair behind it stops by itself. From any thread."""
        with suppress(ProcessLookupError):
            self._process.kill()

    async def close(self) -> None:
        """Bring the chair to its stop, end the process and give back what it held."""
        with suppress(LinkLost):
            self.client.send("quit")
        await self.client.close()
        await _end(self._process)
        self.ring.close()


def _command(link: int, ring: str, options: Sequence[str]) -> list[str]:
    return [sys.executable, "-m", "app.pipeline.process", "--link-fd", str(link), "--ring", ring, *options]


async def _end(process: asyncio.subprocess.Process) -> None:
    """Wait for the process, and help when it does not end by itself."""
    for help_it in (process.terminate, process.kill):
        try:
            await asyncio.wait_for(process.wait(), QUIT_LIMIT)
        except TimeoutError:
            with suppress(ProcessLookupError):
                help_it()
        else:
            return
    await process.wait()
