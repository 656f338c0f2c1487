"""Signing in and out: by the link of a demonstration, by the set-up code, by name and password."""

import secrets
from typing import Annotated

from fastapi import APIRouter, HTTPException, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app import __version__
from app.api.deps import ForEveryone, PeopleParts
from app.api.passwords import weakness
from app.api.signed_in import COOKIE, find_signed_in
from app.quantities import Document, Line
from app.session.store_log import write_log
from app.session.store_people import (
    add_clinic,
    add_person,
    count_people,
    find_person,
    sign_in,
    sign_out,
    the_clinic,
)

router = APIRouter(prefix="/auth", tags=["sign-in"], dependencies=[ForEveryone])

Code = Annotated[str, Field(min_length=1, max_length=200)]
PersonName = Annotated[Line, Field(min_length=1, max_length=80, pattern=r"^\S(.*\S)?$")]
Password = Annotated[str, Field(max_length=1000)]


class DemoCode(Document):
    """What stands behind the link of a demonstration."""

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
    name: str | None
    role: str | None
    demo: bool
    needs_setup: bool
    version: str


def _me(parts: PeopleParts, name: str | None, role: str | None) -> Me:
    with parts.database.transaction() as db:
        needs_setup = not parts.settings.demo and count_people(db) == 0
    return Me(
        signed_in=name is not None,
        name=name,
        role=role,
        demo=parts.settings.demo,
        needs_setup=needs_setup,
        version=__version__,
    )


def _let_in(parts: PeopleParts, request: Request, response: Response, name: str, how: str) -> Me:
    """Open a new sign-in, ending the one that this browser had."""
    with parts.database.transaction() as db:
        old = request.cookies.get(COOKIE)
        if old:
            sign_out(db, old)
        person = find_person(db, name)
        if person is None or person.disabled is not None:
            raise HTTPException(401, "This person may no longer sign in: ask an owner.")
        token, role = sign_in(db, person, how), person.role
    response.set_cookie(COOKIE, token, httponly=True, samesite="lax", secure=request.url.scheme == "https", path="/")
    return _me(parts, name, role)


@router.post("/demo")
def enter_demonstration(body: DemoCode, request: Request, response: Response, parts: PeopleParts) -> Me:
    """Sign in to the demonstration with the code of its link."""
    code = parts.settings.demo_code
    if code is None:
        raise HTTPException(404, "This is not a demonstration: sign in with your name and password.")
    if not secrets.compare_digest(code.encode(), body.code.encode()):
        raise HTTPException(401, "This link belongs to another demonstration: open the link that was printed last.")
    with parts.database.transaction() as db:
        clinic = the_clinic(db)
        name = "Demo clinician"
        if clinic is not None and find_person(db, name) is None:
            add_person(db, clinic, name, "owner", None)
    return _let_in(parts, request, response, name, "demonstration")


@router.post("/setup")
def make_first_owner(body: FirstOwner, request: Request, response: Response, parts: PeopleParts) -> Me:
    """Make the first owner with the code from the console, and sign in."""
    with parts.database.transaction() as db:
        if parts.settings.demo or count_people(db):
            raise HTTPException(409, "This clinic is set up already: sign in with your name and password.")
    if not parts.set_up.opens(body.code):
        raise HTTPException(
            401, "This code is wrong, used or older than 30 minutes: restart the program for a new one."
        )
    weak = weakness(body.name, body.password)
    if weak is not None:
        raise HTTPException(422, weak)
    password_hash = parts.passwords.hash(body.password)
    with parts.database.transaction() as db:
        if count_people(db):
            raise HTTPException(409, "This clinic is set up already: sign in with your name and password.")
        add_person(db, the_clinic(db) or add_clinic(db, "Clinic"), body.name, "owner", password_hash)
    parts.set_up.used()
    return _let_in(parts, request, response, body.name, "set-up")


@router.post("/sign-in")
def sign_in_by_password(body: Credentials, request: Request, response: Response, parts: PeopleParts) -> Me:
    """Sign in with name and password."""
    if parts.passwords.must_wait(body.name):
        raise HTTPException(429, "Too many wrong passwords for this name: wait a minute, then try again.")
    with parts.database.transaction() as db:
        person = find_person(db, body.name)
        stored = None if person is None or person.disabled is not None else person.password_hash
    if not parts.passwords.matches(stored, body.password):
        parts.passwords.failed(body.name)
        with parts.database.transaction() as db:
            write_log(db, None, "sign-in refused")
        raise HTTPException(401, "Name or password is wrong: try again, or ask an owner for a new password.")
    return _let_in(parts, request, response, body.name, "password")


@router.post("/sign-out")
async def sign_out_here(request: Request, response: Response, parts: PeopleParts) -> Me:
    """End this sign-in; every socket that it had opened is closed."""

    def _end() -> tuple[int | None, Me]:
        with parts.database.transaction() as db:
            ended = sign_out(db, request.cookies.get(COOKIE, ""))
        return ended, _me(parts, None, None)

    ended, me = await run_in_threadpool(_end)
    if ended is not None:
        await parts.sockets.close_session(ended)
    response.delete_cookie(COOKIE, httponly=True, samesite="lax", path="/")
    return me


@router.get("/me")
def who_am_i(request: Request, parts: PeopleParts) -> Me:
    """Tell who is signed in on this screen."""
    who = find_signed_in(parts.database, request.cookies)
    return _me(parts, who.name if who else None, who.role if who else None)
