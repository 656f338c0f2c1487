"""A session as a story, in one answer."""

from typing import Any

from fastapi import APIRouter

from app.api.answers import Answer, MomentText
from app.api.deps import Anyone, PeopleParts, RowId
from app.api.records.origin_view import OriginView
from app.quantities import Document
from app.store.database import Transaction
from app.store.log import write_log
from app.store.records.imports import origin_of
from app.store.records.session_record import find_session, session_record
from app.store.sharing.story import Kind, story_of
from app.store.tables import Patient, PatientSession

router = APIRouter(tags=["review"])


class EventView(Answer):
    """One thing that happened in a session, or was written about it."""

    at: MomentText
    kind: Kind
    person: str | None
    words: str
    facts: dict[str, Any]


class StoryScale(Answer):
    """The total of an outcome scale."""

    name: str
    total: float


class StoryView(Document):
    """A session in time order."""

    session_id: int
    number: int
    patient_id: int
    code: str
    goal: str
    scales: list[StoryScale]
    is_signed: bool
    origin: OriginView | None  # null: held in this clinic
    events: list[EventView]


def story_view(db: Transaction, session: PatientSession) -> StoryView:
    """Return a session as a story."""
    record = session_record(db, session.id)
    return StoryView(
        session_id=session.id,
        number=session.number,
        patient_id=session.patient_id,
        code=db.get_one(Patient, session.patient_id).code,
        goal=record.goal,
        scales=[StoryScale.of(scale) for scale in record.scales],
        is_signed=record.sign_off is not None,
        origin=None if (origin := origin_of(db, session.id)) is None else OriginView.of(origin),
        events=[EventView.of(event) for event in story_of(db, session)],
    )


@router.get("/sessions/{session_id}/story")
def story(session_id: RowId, who: Anyone, parts: PeopleParts) -> StoryView:
    """Return what was done, changed and said in a session, in time order."""
    with parts.database.transaction(closing=True) as db:
        session = find_session(db, who.clinic_id, session_id)
        write_log(db, who.name, "session viewed", patient=session.patient_id, session=session_id)
        return story_view(db, session)
