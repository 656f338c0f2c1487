"""Count tries at passwords and codes; every try is counted before it is checked."""

import math
import threading
from collections import deque

from app.clock import monotonic

WITHIN = 60.0  # s: older tries no longer count
MOST_KEYS = 4096  # more than can be tried within WITHIN: one hash takes 0.1 s


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


def seconds_in_words(wait: float) -> str:
    """Return a waiting time (s) in words, rounded up to whole seconds."""
    seconds = max(1, math.ceil(wait))
    return "1 second" if seconds == 1 else f"{seconds} seconds"
