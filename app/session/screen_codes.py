"""Codes that pair a screen with the open session: one code at a time, valid once and for VALID_FOR."""

import secrets
import threading
from dataclasses import dataclass
from datetime import datetime, timedelta

from app.clock import monotonic, utc_now
from app.refusals import Conflict
from app.texts import Text

# 40 bits, typed in a moment. A machine may try ten wrong codes a minute: while a code is valid, even a thousand
# machines hit it once in ten million times. No letter looks like a digit.
LETTERS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
CODE_LENGTH = 8
LOOK_ALIKES = str.maketrans("OIL", "011")
VALID_FOR = 600.0  # s

WRONG = Text("visit-code-wrong", minutes=round(VALID_FOR / 60))


@dataclass(frozen=True, slots=True)
class PairingOffer:
    """A code that pairs one screen with a session."""

    code: str
    session_id: int
    person: str  # who asked for it
    until: float  # monotonic, s
    expires: datetime


def as_typed(text: str) -> str:
    """Return a code as it was made, from what a person typed: small letters, spaces, dashes and look-alikes count."""
    return "".join(letter for letter in text.upper().translate(LOOK_ALIKES) if letter.isalnum())


class PairingCodes:
    """Holds the newest code; a new code makes the one before invalid. Thread-safe."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._offer: PairingOffer | None = None

    def offer(self, session_id: int, person: str) -> PairingOffer:
        """Make a code for a session."""
        expires = utc_now() + timedelta(seconds=VALID_FOR)
        code = "".join(secrets.choice(LETTERS) for _ in range(CODE_LENGTH))
        offer = PairingOffer(code, session_id, person, monotonic() + VALID_FOR, expires)
        with self._lock:
            self._offer = offer
        return offer

    def redeem(self, code: str) -> PairingOffer:
        """Return the offer of a code and make the code invalid; Conflict when it is not the newest one, or too old."""
        with self._lock:
            offer = self._offer
            if offer is not None and secrets.compare_digest(offer.code.encode(), as_typed(code).encode()):
                self._offer = None
                if offer.until > monotonic():
                    return offer
        raise Conflict(WRONG)
