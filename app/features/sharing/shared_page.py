"""What a share link opens: a PIN gives the browser a cookie, with which it reads one patient's records for an hour."""

from typing import Annotated

from fastapi import APIRouter, HTTPException, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.deps import Db, ForEveryone, HashingPart, LivePart, SignInLimitsPart
from app.api.page_session import any_session
from app.api.sign_in.cookies import read_cookie, set_cookie
from app.api.sign_in.hashing import Busy
from app.api.sign_in.passwords import BUSY, BUSY_FOR
from app.api.sign_in.sign_in_limits import address_of
from app.features.sharing.routes import CHANGED
from app.features.sharing.service import (
    VISIT,
    SharedRecords,
    begin_visit,
    count_try,
    find_visit,
    take_back_try,
)
from app.features.sharing.shared_learning import Learning, TaskLearning
from app.features.sharing.stories import StoryView, story_view
from app.quantities import Document, Line
from app.store.access.visible_patients import VISIBLE_PATIENTS
from app.store.log import write_log
from app.store.patients import find_session, sessions_of
from app.store.tables import Patient

router = APIRouter(prefix="/shared", tags=["sharing"], dependencies=[ForEveryone])

COOKIE = "bodydrive_share"
COOKIE_PATH = "/api/v1/shared"
MOST_SESSIONS = 40  # the newest, of a course

WRONG = "The link or the PIN is wrong, or the link has ended: ask the clinic for a new one."
NO_VISIT = "Give the PIN of this link: it was told to you separately."


class OpenShare(Document):
    """The token of a link, and its PIN."""

    token: Annotated[Line, Field(min_length=1, max_length=128)]
    pin: Annotated[Line, Field(min_length=4, max_length=12)]


class SharedView(Document):
    """One session, or the course of a patient."""

    code: str
    is_course: bool
    expires: str
    stories: list[StoryView]  # the newest session first
    tasks: list[TaskLearning]


@router.post("/open", status_code=204)
@any_session("It reads what one link shares, and changes nothing of a session.")
async def open_share(
    body: OpenShare,
    request: Request,
    response: Response,
    database: Db,
    hashing: HashingPart,
    sign_in_limits: SignInLimitsPart,
    live: LivePart,
) -> None:
    """Let a browser read what a link shares, when the PIN is right; each try is counted before it is checked.

    For everybody: a cookie for one hour, for `/api/v1/shared` only, which names the patient by the code.
    """
    attempt = await sign_in_limits.code(address_of(request))
    found = await run_in_threadpool(_count, database, body.token)
    if found is None:
        raise HTTPException(401, WRONG)
    share_id, patient_id, pin_hash = found
    try:
        async with hashing.slot():
            is_right = await hashing.matches(pin_hash, body.pin)
    except Busy:
        attempt.take_back()
        await run_in_threadpool(_take_back, database, share_id)
        await sign_in_limits.refuse(503, BUSY, BUSY_FOR)
    token = await run_in_threadpool(_note, database, share_id, patient_id, is_right=is_right)
    live.tell(CHANGED)
    if token is None:
        raise HTTPException(401, WRONG)
    attempt.take_back()
    seconds = int(VISIT.total_seconds())
    set_cookie(request, response, COOKIE, token, COOKIE_PATH, max_age=seconds, samesite="strict")


@router.get("")
def shared(
    request: Request,
    database: Db,
    learning: Learning,
) -> SharedView:
    """Return all that a link shares, for the browser in which its PIN was given."""
    visit = _visit(database, request)
    before = VISIBLE_PATIENTS.set(frozenset({visit.patient_id}))  # from here, no other patient exists
    try:
        with database.transaction(closing=True) as db:
            write_log(db, None, "share viewed", share=visit.share_id, patient=visit.patient_id)
            if visit.session_id is None:
                sessions = sessions_of(db, visit.patient_id)[:MOST_SESSIONS]
            else:
                sessions = [find_session(db, visit.clinic_id, visit.session_id)]
            stories = [story_view(db, session) for session in sessions]
            code = db.get_one(Patient, visit.patient_id).code
        tasks = learning.of_patient(visit.clinic_id, visit.patient_id, visit.session_id)
    finally:
        VISIBLE_PATIENTS.reset(before)
    return SharedView(
        code=code,
        is_course=visit.session_id is None,
        expires=visit.expires.isoformat(),
        stories=stories,
        tasks=tasks,
    )


def _visit(database: Db, request: Request) -> SharedRecords:
    """Return what the browser may read; 401 when it may read nothing, or nothing any more."""
    token = read_cookie(request, COOKIE, COOKIE_PATH)
    with database.transaction() as db:
        before = find_visit(db, token) if token else None
    if before is None:
        raise HTTPException(401, NO_VISIT)
    return before


def _count(database: Db, token: str) -> tuple[int, int, str] | None:
    with database.transaction(closing=True) as db:
        link = count_try(db, token)
        return None if link is None else (link.id, link.patient_id, link.pin_hash)


def _take_back(database: Db, share_id: int) -> None:
    with database.transaction(closing=True) as db:
        take_back_try(db, share_id)


def _note(database: Db, share_id: int, patient_id: int, *, is_right: bool) -> str | None:
    with database.transaction(closing=True) as db:
        token = begin_visit(db, share_id) if is_right else None
        what = "share refused" if token is None else "share opened"
        write_log(db, None, what, share=share_id, patient=patient_id)
        return token
