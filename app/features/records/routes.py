"""The record of a session: read it, write goal, notes and scales, sign it off. A signed one refuses changes (409)."""

import asyncio
from collections.abc import Callable
from datetime import date
from typing import Annotated, Any

from fastapi import APIRouter
from pydantic import Field

from app.api.answers import OriginView
from app.api.deps import Anyone, Clinician, Db, LivePart, Owner, RowId, SessionFlowPart, SocketsPart, ViewKeeperPart
from app.api.page_session import OWN_NAME, any_session
from app.api.sign_in.identity import SignedInPerson
from app.features.records.service import add_note, add_scale, remove_scale, revise_note, write_goal
from app.features.records.session_views import SessionRecordView, SessionRow, record_view, sign_off_view
from app.features.records.sign_off import require_unsigned, sign_off, sign_offs_of, unlock
from app.news import News
from app.quantities import Document, Finite, Line, Note, Title
from app.store.database import Database, Transaction
from app.store.log import log_session_viewing, log_viewing, write_log
from app.store.origins import origins_of
from app.store.patients import find_patient, find_session, sessions_of
from app.store.session_contents import counted_by_session

router = APIRouter(tags=["records"])


class Goal(Document):
    """The goal of a session, in the patient's words; empty: none."""

    goal: Annotated[Note, Field(max_length=1000)]


class NoteText(Document):
    """The text of a note."""

    text: Annotated[Note, Field(min_length=1, max_length=8000, pattern=r"\S")]


class NewScale(Document):
    """The total of an outcome scale; no items of its form."""

    name: Title
    total: Finite
    day: date


@router.get("/patients/{patient_id}/sessions")
def list_sessions(patient_id: RowId, person: Anyone, database: Db) -> list[SessionRow]:
    """List a patient's sessions, the newest first.

    `trials` is their count; `origin`: from which archive a session came, null: held here.
    """
    with database.transaction(closing=True) as db:
        find_patient(db, patient_id)
        log_viewing(db, person.name, patient_id)
        counted, signed = counted_by_session(db, patient_id), sign_offs_of(db, patient_id)
        origins = {session: OriginView.of(origin) for session, origin in origins_of(db, patient_id).items()}
        return [
            SessionRow(
                id=session.id,
                number=session.number,
                started=session.started.isoformat(),
                ended=None if session.ended is None else session.ended.isoformat(),
                trials=counted.get(session.id, 0),
                sign_off=sign_off_view(signed.get(session.id)),
                origin=origins.get(session.id),
            )
            for session in sessions_of(db, patient_id)
        ]


@router.get("/sessions/{session_id}")
def one_session(session_id: RowId, person: Anyone, database: Db) -> SessionRecordView:
    """Return the record of a session, and what was done in it.

    Reading is logged. The newest revision of a note comes first. Each change of the record gives this answer; after the
    sign-off it is refused with 409, as is keeping or discarding the session's trials.
    """
    with database.transaction(closing=True) as db:
        session = find_session(db, session_id)
        log_session_viewing(db, person.name, session.patient_id, session_id)
        return record_view(db, session)


@router.put("/sessions/{session_id}/goal")
@any_session(OWN_NAME)
def put_goal(session_id: RowId, body: Goal, person: Clinician, database: Db, live: LivePart) -> SessionRecordView:
    """Write the goal of a session, in the patient's words."""

    def write(db: Transaction) -> dict[str, Any]:
        write_goal(db, session_id, body.goal)
        return {}

    return _changed(database, live, person, session_id, "goal written", write)


@router.post("/sessions/{session_id}/notes", status_code=201)
@any_session(OWN_NAME)
def new_note(session_id: RowId, body: NoteText, person: Clinician, database: Db, live: LivePart) -> SessionRecordView:
    """Add a note to a session."""
    return _changed(
        database,
        live,
        person,
        session_id,
        "note added",
        lambda db: {"note": add_note(db, session_id, body.text, person.name)},
    )


@router.put("/sessions/{session_id}/notes/{note_id}")
@any_session(OWN_NAME)
def new_revision(
    session_id: RowId, note_id: RowId, body: NoteText, person: Clinician, database: Db, live: LivePart
) -> SessionRecordView:
    """Give a note another text; the text before stays in its history."""

    def write(db: Transaction) -> dict[str, Any] | None:
        return {"note": note_id} if revise_note(db, session_id, note_id, body.text, person.name) else None

    return _changed(database, live, person, session_id, "note revised", write)


@router.post("/sessions/{session_id}/scales", status_code=201)
@any_session(OWN_NAME)
def new_scale(session_id: RowId, body: NewScale, person: Clinician, database: Db, live: LivePart) -> SessionRecordView:
    """Add the total of an outcome scale."""

    def write(db: Transaction) -> dict[str, Any]:
        return {"scale": add_scale(db, session_id, body.name, body.total, body.day)}

    return _changed(database, live, person, session_id, "scale added", write)


@router.delete("/sessions/{session_id}/scales/{scale_id}")
@any_session(OWN_NAME)
def no_scale(session_id: RowId, scale_id: RowId, person: Clinician, database: Db, live: LivePart) -> SessionRecordView:
    """Remove a scale; the log keeps who added it and who removed it, not what it was: a patient can be erased."""

    def write(db: Transaction) -> dict[str, Any]:
        remove_scale(db, session_id, scale_id)
        return {"scale": scale_id}

    return _changed(database, live, person, session_id, "scale removed", write)


def _changed(
    database: Database,
    live: LivePart,
    person: SignedInPerson,
    session_id: int,
    what: str,
    write: Callable[[Transaction], dict[str, Any] | None],
) -> SessionRecordView:
    """Change a session by `write`, log it with the details that it returns (None: nothing changed), and answer it."""
    with database.transaction() as db:
        session = find_session(db, session_id)
        require_unsigned(db, session_id)
        details = write(db)
        if details is not None:
            write_log(db, person.name, what, patient=session.patient_id, session=session_id, **details)
        answer = record_view(db, session)
    live.notify(_news_of(answer))
    return answer


def _news_of(record: SessionRecordView) -> News:
    return News(what="record", patient=record.patient_id, session=record.id)


class Unlock(Document):
    """Why a signed session is unlocked."""

    reason: Annotated[Line, Field(min_length=1, max_length=200, pattern=r"\S")]


@router.post("/sessions/{session_id}/sign-off", status_code=201)
@any_session(OWN_NAME)
async def sign_session_off(
    session_id: RowId,
    person: Clinician,
    database: Db,
    sockets: SocketsPart,
    session_flow: SessionFlowPart,
    live: LivePart,
    view_keeper: ViewKeeperPart,
) -> SessionRecordView:
    """Sign a session off: nothing of it can be changed any more. The open session ends with it.

    409 during a step, trial or drive.
    """

    def _sign() -> tuple[SessionRecordView, bool]:
        with database.transaction() as db:
            session = find_session(db, session_id)
            was_open = session.ended is None
            sign_off(db, session, person.name)
            write_log(db, person.name, "session signed off", patient=session.patient_id, session=session_id)
            return record_view(db, session), was_open

    async with session_flow.undisturbed():
        answer, was_open = await asyncio.to_thread(_sign)
        if was_open:
            await sockets.close_ended_screens()
            await view_keeper.close()
            await session_flow.session_changed()
    live.notify(_news_of(answer))
    return answer


@router.post("/sessions/{session_id}/unlock")
@any_session(OWN_NAME)
def unlock_session(session_id: RowId, body: Unlock, person: Owner, database: Db, live: LivePart) -> SessionRecordView:
    """Unlock a signed session, for a reason, which stays with its sign-off in the history of the session.

    For owners.
    """
    with database.transaction() as db:
        session = find_session(db, session_id)
        row = unlock(db, session, person.name, body.reason)
        details = {"patient": session.patient_id, "session": session_id, "signed_by": row.person}
        write_log(db, person.name, "session unlocked", **details)
        answer = record_view(db, session)
    live.notify(_news_of(answer))
    return answer
