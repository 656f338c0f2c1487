"""What people write about a session, and its sign-off: what the feature gives to the rest of the program."""

from collections.abc import Iterator
from typing import Final

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.features.records.sign_off import lock_signed, sign_off_history, why_locked
from app.features.records.tables import NoteRevision, OutcomeScale, SessionNote, SessionSignOff
from app.features.registration import ArchivedTable, Attention, Feature, StoryEvent
from app.quantities import Line
from app.store.tables import PatientSession


def story(db: Session, session: PatientSession) -> Iterator[StoryEvent]:
    """Yield the notes of a session, each as it is now, its sign-offs and their unlocking."""
    notes = select(NoteRevision).join(SessionNote, SessionNote.id == NoteRevision.note_id)
    newest = select(func.max(NoteRevision.id)).group_by(NoteRevision.note_id)
    for note in db.scalars(notes.where(SessionNote.session_id == session.id, NoteRevision.id.in_(newest))):
        yield StoryEvent(note.written, "note", note.person, note.text, {})
    for row in sign_off_history(db, session.id):
        yield StoryEvent(row.at, "sign-off", row.person, "", {})
        if row.unlocked is not None:
            yield StoryEvent(row.unlocked, "unlock", row.unlocked_by, row.reason or "", {})


def attention(db: Session, _person_id: int) -> Iterator[tuple[int, Attention]]:
    """Yield the patients with sessions that have ended and are not signed off."""
    signed = select(SessionSignOff.session_id).where(SessionSignOff.unlocked.is_(None))
    unsigned = (
        select(PatientSession.patient_id, func.count(), func.max(PatientSession.id))
        .where(PatientSession.ended.is_not(None))
        .where(PatientSession.id.not_in(signed))
        .group_by(PatientSession.patient_id)
    )
    for patient, count, newest in db.execute(unsigned):
        yield patient, Attention("unsigned", count, newest, None)


FEATURE: Final = Feature(
    tables=(SessionNote, NoteRevision, OutcomeScale, SessionSignOff),
    routes=("routes", "session_comparisons"),
    archived=(
        ArchivedTable(SessionNote, by="session_id"),
        ArchivedTable(NoteRevision, by="note_id", forms={"person": Line}),
        ArchivedTable(OutcomeScale, by="session_id", forms={"name": Line}),
        ArchivedTable(SessionSignOff, by="session_id", forms={"person": Line, "unlocked_by": Line}),
    ),
    begin=lock_signed,
    why_locked=why_locked,
    story=story,
    attention=attention,
)
