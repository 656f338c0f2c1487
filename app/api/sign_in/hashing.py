"""Ask a process of low priority for password hashes, one at a time; at most eight requests are under way.

A hash takes 64 MiB and 0.1 s of a core. In the web process, even in a thread of it, a flood of sign-ins would delay
Stop; a process of its own with low priority does not.
"""

import asyncio
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from typing import NamedTuple

from app.child_process import JsonChild
from app.json_values import JsonObject
from app.refusals import Unavailable
from app.texts import Text

MOST_AT_ONCE = 8  # sign-ins under way, including the one that is being hashed: about 1 s of waiting
ANSWER_LIMIT = 15.0  # s for one hash on a busy machine
END_LIMIT = 1.0  # s
ENDED = Text("api-passwords-not-checked")


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
        self._child: JsonChild | None = None

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
        child, self._child = self._child, None
        if child is not None:
            await child.end(END_LIMIT)

    async def _ask(self, question: Mapping[str, object]) -> JsonObject:
        async with self._one_at_a_time:
            try:
                if self._child is None:
                    self._child = await _start()
                async with asyncio.timeout(ANSWER_LIMIT):
                    await self._child.send(question)
                    return await self._child.receive()
            except OSError as error:  # TimeoutError too
                await self.close()
                raise Unavailable(ENDED) from error
            except asyncio.CancelledError:
                await self.close()  # otherwise the next request would read the answer of this one
                raise


async def _start() -> JsonChild:
    cost = [f"--{name}={value}" for name, value in COST._asdict().items()]
    return await JsonChild.start("app.api.sign_in.hashing_process", *cost)
