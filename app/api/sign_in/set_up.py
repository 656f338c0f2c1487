"""The one-time code with which the first owner is made."""

import secrets
import threading

from app.clock import monotonic

VALID_FOR = 1800.0  # s


class SetUp:
    """Holds the set-up code of this start of the program, which is valid once, for VALID_FOR."""

    def __init__(self, code: str | None) -> None:
        self._code = code
        self._until = monotonic() + VALID_FOR
        self._lock = threading.Lock()

    def opens(self, code: str) -> bool:
        """Return whether `code` is the set-up code and still valid."""
        with self._lock:
            if self._code is None or monotonic() > self._until:
                return False
            return secrets.compare_digest(self._code.encode(), code.encode())

    def used(self) -> None:
        """Make the code invalid."""
        with self._lock:
            self._code = None
