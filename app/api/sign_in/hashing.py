"""Ask a process of low priority for password hashes, one at a time; at most eight requests are under way.

A hash takes 64 MiB and 0.1 s of a core. In the web process, even in a thread of it, a flood of sign-ins would delay
Stop; a process of its own with low priority does not.
"""

import asyncio
import json
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from typing import Any, NamedTuple

from app.refusals import Unavailable

MOST_AT_ONCE = 8  # sign-ins under way, including the one that is being hashed: about 1 s of waiting
ANSWER_LIMIT = 15.0  # s for one hash on a busy machine
END_LIMIT = 1.0  # s
ENDED = "Passwords cannot be checked at this moment: try again."


class Cost(NamedTuple):
    """The cost of a hash: argon2id's parameters."""

    time: int  # passes over the memory
    memory: int  # KiB
    lanes: int


COST = Cost(time=3, memory=65_536, lanes=4)  # RFC 9106, section 4, the second recommended choice


class Busy(Exception):  # noqa: N818
    """No slot is free: MOST_AT_ONCE passwords are being checked."""


class Hashing:
    """Asks the hashing process; starts it for the first password, and again when it has ended."""

    def __init__(self) -> None:
        self._free_slots = MOST_AT_ONCE
        self._one_at_a_time = asyncio.Lock()
        self._process: asyncio.subprocess.Process | None = None

    @asynccontextmanager
    async def slot(self) -> AsyncIterator[None]:
        """Take one of the `MOST_AT_ONCE` slots, without waiting, for the time of the `async with` block.

        Raises
        ------
        Busy
            When no slot is free.
        """
        if not self._free_slots:
            raise Busy
        self._free_slots -= 1
        try:
            yield
        finally:
            self._free_slots += 1

    async def hash(self, password: str) -> str:
        """Return the hash to store."""
        return str((await self._ask({"do": "hash", "password": password}))["hash"])

    async def matches(self, stored: str | None, password: str) -> bool:
        """Return whether `password` belongs to the hash `stored`; False for None, after the time of a hash."""
        return bool((await self._ask({"do": "verify", "stored": stored, "password": password}))["matches"])

    async def close(self) -> None:
        """End the process."""
        process, self._process = self._process, None
        if process is not None:
            await _end(process)

    async def _ask(self, message: dict[str, Any]) -> dict[str, Any]:
        async with self._one_at_a_time:
            try:
                if self._process is None:
                    self._process = await _start()
                async with asyncio.timeout(ANSWER_LIMIT):
                    return await _answer(self._process, message)
            except (OSError, ValueError, TimeoutError) as error:
                await self.close()
                raise Unavailable(ENDED) from error
            except asyncio.CancelledError:
                await self.close()  # otherwise the next request would read the answer of this one
                raise


async def _start() -> asyncio.subprocess.Process:
    cost = [f"--{name}={value}" for name, value in COST._asdict().items()]
    return await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "app.api.sign_in.hashing_process", *cost),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
    )


async def _answer(process: asyncio.subprocess.Process, message: dict[str, Any]) -> dict[str, Any]:
    if process.stdin is None or process.stdout is None:
        raise OSError("the hashing process was started without pipes")
    process.stdin.write(json.dumps(message).encode() + b"\n")
    await process.stdin.drain()
    line = await process.stdout.readline()
    found: dict[str, Any] = json.loads(line)  # ValueError for the empty line of an ended process
    return found


async def _end(process: asyncio.subprocess.Process) -> None:
    if process.stdin is not None:
        process.stdin.close()
    try:
        async with asyncio.timeout(END_LIMIT):
            await process.wait()
    except TimeoutError:
        with suppress(ProcessLookupError):
            process.kill()
        await process.wait()
