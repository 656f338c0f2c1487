"""Pairing a screen for the patient: one code at a time, valid once and for ten minutes, its guesses counted."""

import secrets
import threading
from collections import deque
from dataclasses import dataclass
from datetime import datetime, timedelta

from app.clock import monotonic, utc_now
from app.session.refusals import Conflict

CODE_BYTES = 16  # 128 bits: cannot be guessed
VALID_FOR = 600.0  # s
TRIES = 10  # wrong codes from one address within ...
WITHIN = 60.0  # s; then this address waits
ADDRESSES_WATCHED = 256

WRONG = "This code is wrong, used or older than 10 minutes: ask for a new one on the clinician's page."
WAIT = "Too many wrong codes came from this screen: wait a minute, then open a new link."


class TooManyTries(Exception):  # noqa: N818
    """An address gave too many wrong codes lately."""


@dataclass(frozen=True, slots=True)
class Offer:
    """A code that pairs one screen with a visit."""

    code: str
    session_id: int
    person: str  # who asked for it
    until: float  # monotonic, s
    expires: datetime


class PairingCodes:
    """Holds the newest code; asking for another makes the one before worthless. May be asked from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._offer: Offer | None = None
        self._wrong: dict[str, deque[float]] = {}

    def offer(self, session_id: int, person: str) -> Offer:
        """Make a code for a visit."""
        expires = utc_now() + timedelta(seconds=VALID_FOR)
        made = Offer(secrets.token_urlsafe(CODE_BYTES), session_id, person, monotonic() + VALID_FOR, expires)
        with self._lock:
            self._offer = made
        return made

    def redeem(self, code: str, address: str) -> Offer:
        """Return what a code stands for and make it worthless.

        Raises
        ------
        Conflict
            When it is not the newest one, or too old.
        TooManyTries
            When too many wrong ones came from `address` lately.
        """
        with self._lock:
            wrong = self._wrong.get(address)
            while wrong and wrong[0] < monotonic() - WITHIN:
                wrong.popleft()
            if wrong is not None and len(wrong) >= TRIES:
                raise TooManyTries(WAIT)
            offer = self._offer
            if offer is not None and secrets.compare_digest(offer.code.encode(), code.encode()):
                self._offer = None
                if offer.until > monotonic():
                    return offer
            if address not in self._wrong and len(self._wrong) >= ADDRESSES_WATCHED:
                self._wrong.pop(next(iter(self._wrong)))
            self._wrong.setdefault(address, deque(maxlen=TRIES)).append(monotonic())
        raise Conflict(WRONG)
