"""The phones that are paired as sensors: a number from 1 on each, until they are unpaired or the program ends."""

import hashlib
import secrets
from dataclasses import dataclass
from datetime import datetime
from typing import Final

from app.clock import monotonic, utc_now
from app.hardware.configs import MOST_PHONES
from app.refusals import Conflict, NotFound
from app.session.screen_codes import PairingCodes, PairingOffer
from app.texts import Text

TOKEN_BYTES: Final = 32
PAIRED_FOR_HOURS: Final = 12  # longer than a day in the clinic; a phone that was forgotten is none the next day
NO_SESSION: Final = 0  # a phone is paired with the machine, and shows nothing of a patient


@dataclass(frozen=True, slots=True)
class _Pairing:
    token_hash: str
    paired: datetime
    until: float  # monotonic s


class PairedPhones:
    """Hands out numbers; nothing of it is stored, as a phone is tied on anew for each session."""

    def __init__(self) -> None:
        self._codes = PairingCodes()
        self._phones: dict[int, _Pairing] = {}

    def offer(self, person: str) -> PairingOffer:
        """Make a code that pairs one phone; the code before becomes invalid."""
        return self._codes.offer(NO_SESSION, person)

    def pair(self, code: str, old_token: str | None) -> tuple[int, str, str]:
        """Pair the browser that has a code; return the phone's number, its token and who asked for the code.

        A browser that is paired already keeps its number. Conflict for a wrong code, and when all numbers are taken.
        """
        offer = self._codes.redeem(code)
        number = self.number_of(old_token) or self._free_number()
        token = secrets.token_urlsafe(TOKEN_BYTES)
        self._phones[number] = _Pairing(_hash(token), utc_now(), monotonic() + 3600.0 * PAIRED_FOR_HOURS)
        return number, token, offer.person

    def number_of(self, token: str | None) -> int | None:
        """Return the number of the phone that has a token, None for any other browser."""
        if not token:
            return None
        wanted = _hash(token)
        return next((number for number, one in self._valid().items() if one.token_hash == wanted), None)

    def paired(self) -> dict[int, datetime]:
        """Return since when each phone is paired, by number."""
        return {number: one.paired for number, one in sorted(self._valid().items())}

    def unpair(self, number: int) -> None:
        """End a pairing; NotFound when there is none of this number."""
        if self._valid().pop(number, None) is None:
            raise NotFound(Text("visit-no-phone", number=number))

    def _valid(self) -> dict[int, _Pairing]:
        now = monotonic()
        for number in [number for number, one in self._phones.items() if one.until <= now]:
            del self._phones[number]
        return self._phones

    def _free_number(self) -> int:
        taken = self._valid()
        for number in range(1, MOST_PHONES + 1):
            if number not in taken:
                return number
        raise Conflict(Text("visit-phones-most", most=MOST_PHONES))


def _hash(token: str) -> str:
    return hashlib.sha256(token.encode()).hexdigest()
