"""Signing in and out: by the link of a demonstration, by the set-up code, by name and password."""

import secrets
from typing import Annotated

from fastapi import APIRouter, HTTPException, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app import __version__
from app.api.deps import NOBODY, Db, ForEveryone, SettingsPart, SetUpPart, SignInLimitsPart, SocketsPart
from app.api.page_session import SIGN_IN, any_session
from app.api.request_language import keep_language
from app.api.sign_in.cookies import delete_cookie, read_cookie, set_cookie
from app.api.sign_in.identity import COOKIE, SignedInPerson
from app.api.sign_in.passwords import BROWSER_COOKIE, BROWSER_PATH, Passwords, weakness
from app.api.sign_in.set_up import VALID_FOR
from app.api.sign_in.sign_in_limits import address_of
from app.api.who_asks import WhoAsks
from app.quantities import Document, Line
from app.refusals import Conflict
from app.settings import Settings
from app.store.access.sign_ins import sign_in, sign_out, unlock
from app.store.browsers import KNOWN_FOR, remember_browser
from app.store.database import Database, Transaction
from app.store.people import add_clinic, add_person, count_people, find_person, the_clinic
from app.texts import LANGUAGES, Text, current_language

router = APIRouter(prefix="/auth", tags=["sign-in"], dependencies=[ForEveryone])

DEMO_PERSON = "Demo clinician"

Code = Annotated[str, Field(min_length=1, max_length=200)]
PersonName = Annotated[Line, Field(min_length=1, max_length=80, pattern=r"^\S(.*\S)?$")]
Password = Annotated[str, Field(max_length=1000)]


class DemoCode(Document):
    """The code in the link of a demonstration."""

    code: Code


class FirstOwner(Document):
    """The set-up code, and how the first owner will sign in."""

    code: Code
    name: PersonName
    password: Password


class Credentials(Document):
    """Name and password."""

    name: PersonName
    password: Password


class Me(Document):
    """Who is signed in on this screen, and what this installation is."""

    signed_in: bool
    locked: bool  # nobody did anything for a while: only the password of this person goes on
    name: str | None
    role: str | None
    introduced: bool  # this person has put the sentences for a first time away
    demo: bool
    needs_setup: bool
    version: str
    language: str  # of the pages: the one that this person chose, otherwise that of the browser
    languages: tuple[str, ...]  # that can be chosen


class OwnPassword(Document):
    """The password of the person whose page is locked."""

    password: Password


def me_view(settings: Settings, database: Database, person: SignedInPerson | None) -> Me:
    """Return the view of who is signed in, None for nobody."""
    if person is None:
        return _me(settings, database, None, None)
    return _me(settings, database, person.name, person.role, locked=person.locked)


def _me(settings: Settings, database: Database, name: str | None, role: str | None, *, locked: bool = False) -> Me:
    with database.reading() as db:
        needs_setup = not settings.demo and count_people(db) == 0
        person = None if name is None else find_person(db, name)
        introduced = person is not None and person.introduced
        chosen = None if person is None else person.language
    return Me(
        signed_in=name is not None,
        locked=locked,
        name=name,
        role=role,
        introduced=introduced,
        demo=settings.demo,
        needs_setup=needs_setup,
        version=__version__,
        language=chosen if chosen in LANGUAGES else current_language(),
        languages=LANGUAGES,
    )


def let_in(settings: Settings, database: Database, request: Request, response: Response, name: str, how: str) -> Me:
    """Open a sign-in, end the one that this browser had, and make the browser a known one of this person."""
    with database.transaction(closing=True) as db:
        old = read_cookie(request, COOKIE)
        if old:
            sign_out(db, old)
        person = find_person(db, name)
        if person is None or person.disabled is not None:
            raise HTTPException(401, Text("api-person-disabled"))
        token, role, language = sign_in(db, person, how), person.role, person.language
        cookie = f"{BROWSER_COOKIE}{person.id}"
        known_browser = read_cookie(request, cookie, BROWSER_PATH)
        browser = None if person.password_hash is None else remember_browser(db, person, known_browser)
    set_cookie(request, response, COOKIE, token)
    if language is not None:
        keep_language(request, response, language)
    if browser is not None:
        lifetime = int(KNOWN_FOR.total_seconds())
        set_cookie(request, response, cookie, browser, BROWSER_PATH, max_age=lifetime, samesite="strict")
    return _me(settings, database, name, role)


@router.post("/demo")
@any_session(SIGN_IN)
async def enter_demonstration(
    body: DemoCode,
    request: Request,
    response: Response,
    settings: SettingsPart,
    database: Db,
    sign_in_limits: SignInLimitsPart,
) -> Me:
    """Sign in to the demonstration with the code of its link.

    The code stands behind `#demo=` of the printed link.
    """
    code = settings.demo_code
    if code is None:
        raise HTTPException(404, Text("api-no-demonstration"))
    attempt = await sign_in_limits.code(address_of(request))
    if not secrets.compare_digest(code.encode(), body.code.encode()):
        raise HTTPException(401, Text("api-other-demonstration"))
    attempt.take_back()

    def _enter() -> Me:
        with database.transaction() as db:
            clinic = the_clinic(db)
            if clinic is not None and find_person(db, DEMO_PERSON) is None:
                add_person(db, clinic, DEMO_PERSON, "owner", None)
        return let_in(settings, database, request, response, DEMO_PERSON, "demonstration")

    return await run_in_threadpool(_enter)


@router.post("/setup")
@any_session(SIGN_IN)
async def make_first_owner(
    body: FirstOwner,
    request: Request,
    response: Response,
    passwords: Passwords,
    settings: SettingsPart,
    database: Db,
    sign_in_limits: SignInLimitsPart,
    set_up: SetUpPart,
) -> Me:
    """Make the first owner with the code from the console, and sign in."""

    def _require_no_owner(db: Transaction) -> None:
        if settings.demo or count_people(db):
            raise Conflict(Text("api-set-up-already"))

    def _check() -> None:
        with database.reading() as db:
            _require_no_owner(db)

    def _make(password_hash: str) -> Me:
        with database.transaction() as db:
            _require_no_owner(db)
            add_person(db, the_clinic(db) or add_clinic(db, "Clinic"), body.name, "owner", password_hash)
        set_up.used()
        return let_in(settings, database, request, response, body.name, "set-up")

    await run_in_threadpool(_check)
    attempt = await sign_in_limits.code(address_of(request))
    if not set_up.opens(body.code):
        raise HTTPException(401, Text("api-set-up-code-wrong", minutes=round(VALID_FOR / 60)))
    attempt.take_back()
    weak = weakness(body.name, body.password)
    if weak is not None:
        raise HTTPException(422, weak)
    return await run_in_threadpool(_make, await passwords.hash_of(body.password))


@router.post("/sign-in")
@any_session(SIGN_IN)
async def sign_in_by_password(
    body: Credentials,
    request: Request,
    response: Response,
    passwords: Passwords,
    settings: SettingsPart,
    database: Db,
) -> Me:
    """Sign in with name and password.

    429 after too many wrong passwords, 503 while eight sign-ins are under way. Wrong codes of a demonstration, of the
    set-up, of an invitation and of a patient's screen count together: 429 after 10 a minute from one address.
    """
    await passwords.require(request, body.name, body.password)
    return await run_in_threadpool(let_in, settings, database, request, response, body.name, "password")


@router.post("/sign-out")
@any_session(SIGN_IN)
async def sign_out_here(
    request: Request, response: Response, settings: SettingsPart, database: Db, sockets: SocketsPart
) -> Me:
    """End this sign-in, and close every socket that it opened."""

    def _end() -> tuple[int | None, Me]:
        with database.transaction(closing=True) as db:
            ended = sign_out(db, read_cookie(request, COOKIE) or "")
        return ended, me_view(settings, database, None)

    ended, me = await run_in_threadpool(_end)
    if ended is not None:
        await sockets.close_sign_in(ended)
    delete_cookie(request, response, COOKIE)
    return me


@router.post("/unlock")
@any_session(SIGN_IN)
async def unlock_here(
    body: OwnPassword,
    request: Request,
    person: WhoAsks,
    passwords: Passwords,
    settings: SettingsPart,
    database: Db,
    sockets: SocketsPart,
) -> Me:
    """Unlock the page with the password of the person who is signed in on it."""
    if person is None:
        raise HTTPException(401, NOBODY)
    if person.locked:
        await passwords.require_own(request, person.name, body.password)
        await run_in_threadpool(_unlock, database, person.sign_in_id)
        await sockets.recheck(person.sign_in_id)
    return await run_in_threadpool(_me, settings, database, person.name, person.role)


def _unlock(database: Database, sign_in_id: int) -> None:
    with database.transaction(closing=True) as db:
        unlock(db, sign_in_id)


@router.get("/me")
def who_am_i(person: WhoAsks, settings: SettingsPart, database: Db) -> Me:
    """Tell who is signed in on this screen.

    `introduced`: the person has put the sentences for a first time away.
    """
    return me_view(settings, database, person)
