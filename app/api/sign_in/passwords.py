"""The rules for new passwords, and the check of the password of a person."""

from dataclasses import dataclass
from typing import Annotated, NamedTuple

from fastapi import Depends, HTTPException, Request
from fastapi.concurrency import run_in_threadpool

from app.api.parts import parts_for
from app.api.sign_in.cookies import cookie_name, read_cookie
from app.api.sign_in.hashing import Busy, Hashing
from app.api.sign_in.sign_in_limits import SignInLimits, address_of
from app.store.browsers import find_browser
from app.store.database import Database
from app.store.log import write_log
from app.store.people import find_person
from app.texts import Text

SHORTEST, LONGEST = 8, 200  # characters
COMMON = """
    password password1 password12 password123 passw0rd 12345678 123456789 1234567890 87654321 11111111 00000000
    abcd1234 abc12345 qwertyui qwertyuiop qwerty123 1q2w3e4r asdfghjk iloveyou sunshine princess football baseball
    superman starwars letmein1 welcome1 whatever trustno1 computer internet changeme bodydrive wheelchair
"""
BROWSER_COOKIE = "bodydrive_browser_"  # followed by the person's id: several people share a tablet
BROWSER_PATH = "/api/v1/auth"  # no other request needs the cookie

WRONG = Text("api-sign-in-wrong")
BUSY = Text("api-sign-in-busy")
BUSY_FOR = 2.0  # s


def weakness(name: str, password: str) -> Text | None:
    """Return in one sentence why a new password is refused, None when it is not."""
    if len(password) < SHORTEST:
        return Text("api-password-short", least=SHORTEST)
    if len(password) > LONGEST:
        return Text("api-password-long", most=LONGEST)
    if password.lower() in COMMON.split() or password.lower() == name.lower() or len(set(password)) < 3:
        return Text("api-password-common")
    return None


class _StoredCredentials(NamedTuple):
    stored: str | None  # the hash of the password
    browser: int | None  # id of the known browser that sends the request


@dataclass(frozen=True, slots=True)
class PasswordCheck:
    """Hashes new passwords, and checks given ones within the limits of tries."""

    database: Database
    hashing: Hashing
    limits: SignInLimits

    async def hash_of(self, password: str) -> str:
        """Return the hash of a new password; 503 when too many passwords are being hashed."""
        try:
            async with self.hashing.slot():
                return await self.hashing.hash(password)
        except Busy:
            await self.limits.refuse(503, BUSY, BUSY_FOR)

    async def require_own(self, request: Request, name: str, password: str) -> None:
        """Do as `require` for somebody who is signed in, whose name is right: only the password can be wrong."""
        await self.require(request, name, password, Text("api-password-not-own", name=name))

    async def require(self, request: Request, name: str, password: str, wrong: Text = WRONG) -> None:
        """Refuse a wrong password (401), too many tries (429), and more tries at once than can be checked (503).

        The try is counted before anything is looked up or hashed, so that concurrent tries all count.
        """
        attempt = self.limits.password(name, address_of(request))
        browser_cookie = cookie_name(request, BROWSER_COOKIE, BROWSER_PATH)
        if not any(cookie.startswith(browser_cookie) for cookie in request.cookies):
            await self.limits.require(attempt)
        try:
            async with self.hashing.slot():
                credentials = await run_in_threadpool(self._find, request, name)
                if attempt.wait and credentials.browser is not None:
                    attempt = self.limits.password_in(credentials.browser)
                is_right = not attempt.wait and await self.hashing.matches(credentials.stored, password)
        except Busy:
            attempt.take_back()
            await self.limits.refuse(503, BUSY, BUSY_FOR)
        await self.limits.require(attempt)
        if not is_right:
            await run_in_threadpool(self._note_refusal)
            raise HTTPException(401, wrong)
        attempt.take_back()

    def _find(self, request: Request, name: str) -> _StoredCredentials:
        with self.database.reading() as db:
            person = find_person(db, name)
            if person is None or person.disabled is not None:
                return _StoredCredentials(None, None)
            browser = find_browser(db, person, read_cookie(request, f"{BROWSER_COOKIE}{person.id}", BROWSER_PATH))
            return _StoredCredentials(person.password_hash, None if browser is None else browser.id)

    def _note_refusal(self) -> None:
        with self.database.transaction(closing=True) as db:
            write_log(db, None, "sign-in refused")


Passwords = Annotated[PasswordCheck, Depends(parts_for(PasswordCheck))]
