"""Limits of tries at passwords and codes per minute: for a name, from an address, in a known browser.

Every try is counted before it is checked.
"""

import asyncio
import math
import threading
from collections import deque
from dataclasses import dataclass, field
from typing import Literal, NoReturn

from fastapi import HTTPException
from starlette.requests import HTTPConnection

from app.clock import monotonic
from app.texts import Text

WITHIN = 60.0  # s: older tries no longer count
MOST_KEYS = 4096  # more than can be tried within WITHIN: one hash takes 0.1 s
PASSWORDS_PER_NAME = 5
PASSWORDS_PER_ADDRESS = 10
PASSWORDS_PER_BROWSER = 5
CODES_PER_ADDRESS = 10
REFUSALS_EVERY = 0.01  # s between two refusals: a flood of tries must wait for them, so that Stop is not delayed

Tried = Literal["name", "here", "code"]  # the password of a name, a password or a code from one address or browser


class Tries:
    """The tries of the last minute for each name, address or browser.

    Counting and comparing are one step under a lock, so that concurrent tries all count. Thread-safe.
    """

    def __init__(self, most: int) -> None:
        """Allow `most` tries of one key within a minute."""
        self._most = most
        self._lock = threading.Lock()
        self._times: dict[str, deque[float]] = {}

    def count(self, key: str) -> float:
        """Count a try and return 0; when there were too many, count nothing and return how long to wait (s)."""
        with self._lock:
            now = monotonic()
            times = self._times.setdefault(key, deque())
            while times and times[0] <= now - WITHIN:
                times.popleft()
            if len(times) >= self._most:
                return times[0] + WITHIN - now
            times.append(now)
            if len(self._times) > MOST_KEYS:
                self._times.pop(next(iter(self._times)))
            return 0.0

    def take_back(self, key: str) -> None:
        """Remove the newest try of a key: it succeeded, or was not checked."""
        with self._lock:
            times = self._times.get(key)
            if times:
                times.pop()
            if not times:
                self._times.pop(key, None)


def whole_seconds(wait: float) -> int:
    """Return a waiting time (s) in whole seconds, rounded up."""
    return max(1, math.ceil(wait))


@dataclass(slots=True)
class SignInAttempt:
    """A try that was counted, or that has to wait."""

    counted: list[tuple[Tries, str]] = field(default_factory=list)
    wait: float = 0.0  # s; 0: none
    message: Text | str = ""

    def take_back(self) -> None:
        """Remove the try from the counts: it succeeded, or was not checked."""
        while self.counted:
            tries, key = self.counted.pop()
            tries.take_back(key)


class SignInLimits:
    """Counts tries at passwords and codes, and refuses too many; right ones are removed from the counts."""

    def __init__(self) -> None:
        self._names = Tries(PASSWORDS_PER_NAME)
        self._addresses = Tries(PASSWORDS_PER_ADDRESS)
        self._browsers = Tries(PASSWORDS_PER_BROWSER)
        self._codes = Tries(CODES_PER_ADDRESS)
        self._refused_at = 0.0

    def password(self, name: str, address: str) -> SignInAttempt:
        """Count a try at the password of a name."""
        return _count((self._names, name, "name"), (self._addresses, address, "here"))

    def password_in(self, browser: int) -> SignInAttempt:
        """Count a try at a password in a known browser, where the counts of name and address do not apply.

        So tries from elsewhere do not lock a person out of the browser that they use every day.
        """
        return _count((self._browsers, str(browser), "here"))

    async def code(self, address: str) -> SignInAttempt:
        """Count a try at the code of a link; refuse it after too many wrong ones."""
        attempt = _count((self._codes, address, "code"))
        await self.require(attempt)
        return attempt

    async def require(self, attempt: SignInAttempt) -> None:
        """Refuse an attempt that has to wait."""
        if attempt.wait:
            await self.refuse(429, attempt.message, attempt.wait)

    async def refuse(self, status: int, message: Text | str, wait: float) -> NoReturn:
        """Refuse with 429 or 503 and the time to wait (s); at most one refusal per REFUSALS_EVERY."""
        now = monotonic()
        self._refused_at = max(self._refused_at + REFUSALS_EVERY, now)
        await asyncio.sleep(self._refused_at - now)
        raise HTTPException(status, message, headers={"Retry-After": str(whole_seconds(wait))})


def address_of(connection: HTTPConnection) -> str:
    """Return the address of the machine that sends a request."""
    return connection.client.host if connection.client else ""


def _count(*keys: tuple[Tries, str, Tried]) -> SignInAttempt:
    """Count a try under every key, or under none of them."""
    attempt = SignInAttempt()
    for tries, key, tried in keys:
        wait = tries.count(key)
        if wait:
            attempt.take_back()
            attempt.wait, attempt.message = wait, Text(f"api-tries-{tried}", seconds=whole_seconds(wait))
            break
        attempt.counted.append((tries, key))
    return attempt
