"""Passwords: hashed with argon2, one at a time, the same time for somebody who does not exist."""

import threading
from collections import deque

from argon2 import PasswordHasher
from argon2.exceptions import VerificationError

from app.clock import monotonic

SHORTEST = 8
TRIES = 5  # wrong passwords for one name ...
WITHIN = 60.0  # ... within so many seconds, then wait
NAMES_WATCHED = 1000
COMMON = """
    password password1 password12 password123 passw0rd 12345678 123456789 1234567890 87654321 11111111 00000000
    abcd1234 abc12345 qwertyui qwertyuiop qwerty123 1q2w3e4r asdfghjk iloveyou sunshine princess football baseball
    superman starwars letmein1 welcome1 whatever trustno1 computer internet changeme bodydrive wheelchair
"""


def weakness(name: str, password: str) -> str | None:
    """Return in one sentence why a new password is refused, None when it is not."""
    if len(password) < SHORTEST:
        return f"This password is too short: use at least {SHORTEST} characters."
    if len(password) > 200:
        return "This password is too long: use at most 200 characters."
    if password.lower() in COMMON.split() or password.lower() == name.lower() or len(set(password)) < 3:
        return "This password is among the first that anybody would try: choose another one."
    return None


class Passwords:
    """Makes and checks hashes; a hash takes 64 MB and 0.1 s of a core, so only one is made at a time."""

    def __init__(self, hasher: PasswordHasher | None = None) -> None:
        self._hasher = hasher or PasswordHasher()
        self._one_at_a_time = threading.Lock()
        self._nobody = self._hasher.hash("nobody has this password")
        self._failed: dict[str, deque[float]] = {}

    def hash(self, password: str) -> str:
        """Return the hash to store."""
        with self._one_at_a_time:
            return self._hasher.hash(password)

    def matches(self, stored: str | None, password: str) -> bool:
        """Tell whether `password` is the one that was stored; for None it takes as long, and is not."""
        with self._one_at_a_time:
            try:
                self._hasher.verify(stored or self._nobody, password)
            except VerificationError:
                return False
        return stored is not None

    def must_wait(self, name: str) -> bool:
        """Tell whether too many wrong passwords were given for this name lately."""
        times = self._failed.get(name)
        if times is None:
            return False
        while times and times[0] < monotonic() - WITHIN:
            times.popleft()
        return len(times) >= TRIES

    def failed(self, name: str) -> None:
        """Count a wrong password."""
        if name not in self._failed and len(self._failed) >= NAMES_WATCHED:
            self._failed.pop(next(iter(self._failed)))
        self._failed.setdefault(name, deque(maxlen=TRIES)).append(monotonic())
