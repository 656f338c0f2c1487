"""The record of a session: goal, notes with their history, outcome scales, sign-off, version of the software."""

from collections import defaultdict
from dataclasses import dataclass
from datetime import date, datetime

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.records.sign_off import SignOff, sign_off_of
from app.features.records.tables import NoteRevision, OutcomeScale, SessionNote
from app.refusals import Conflict, NotFound
from app.store.tables import PatientSession
from app.texts import Text

MOST_NOTES = 100
MOST_SCALES = 50


@dataclass(frozen=True, slots=True)
class Note:
    """The newest revision of a note; the older ones are those of `note_history`."""

    id: int
    text: str
    person: str
    written: datetime  # of its first revision
    revised: datetime | None  # of its newest revision; None: there is only one


@dataclass(frozen=True, slots=True)
class Scale:
    """The total of an outcome scale on a day."""

    id: int
    name: str
    total: float
    day: date


@dataclass(frozen=True, slots=True)
class SessionRecord:
    """What people wrote about a session."""

    goal: str  # in the patient's words, "" when not written
    notes: tuple[Note, ...]
    scales: tuple[Scale, ...]
    sign_off: SignOff | None  # None: not signed off
    version: str  # of the software that the session began with; "" when not recorded


def session_record(database: Session, session_id: int) -> SessionRecord:
    """Return the record of a session, notes and scales in the order written."""
    session = database.get_one(PatientSession, session_id)
    return SessionRecord(
        goal=session.goal,
        notes=_notes(database, session_id),
        scales=tuple(Scale(row.id, row.name, row.total, row.day) for row in _scales(database, session_id)),
        sign_off=sign_off_of(database, session_id),
        version=session.version,
    )


def note_history(database: Session, note_id: int) -> tuple[NoteRevision, ...]:
    """Return all revisions of a note, the oldest first."""
    query = select(NoteRevision).where(NoteRevision.note_id == note_id).order_by(NoteRevision.id)
    return tuple(database.scalars(query))


def write_goal(db: Session, session_id: int, goal: str) -> None:
    """Set the goal of a session, in the patient's words."""
    db.get_one(PatientSession, session_id).goal = goal
    db.flush()


def add_note(db: Session, session_id: int, text: str, person: str) -> int:
    """Add a note and return its id."""
    if len(_notes(db, session_id)) >= MOST_NOTES:
        raise Conflict(Text("records-most-notes", count=MOST_NOTES))
    note = SessionNote(session_id=session_id)
    db.add(note)
    db.flush()
    _revise(db, note, text, person)
    return note.id


def revise_note(db: Session, session_id: int, note_id: int, text: str, person: str) -> bool:
    """Give a note a new text, and return whether it differs; the text before stays in its history."""
    note = db.get(SessionNote, note_id)
    if note is None or note.session_id != session_id:
        raise NotFound(Text("records-no-note", number=note_id))
    if note_history(db, note_id)[-1].text == text:
        return False
    _revise(db, note, text, person)
    return True


def add_scale(db: Session, session_id: int, name: str, total: float, day: date) -> int:
    """Add the total of an outcome scale and return its id."""
    if len(_scales(db, session_id)) >= MOST_SCALES:
        raise Conflict(Text("records-most-scales", count=MOST_SCALES))
    scale = OutcomeScale(session_id=session_id, name=name, total=total, day=day)
    db.add(scale)
    db.flush()
    return scale.id


def remove_scale(db: Session, session_id: int, scale_id: int) -> None:
    """Remove a scale."""
    row = db.get(OutcomeScale, scale_id)
    if row is None or row.session_id != session_id:
        raise NotFound(Text("records-no-scale", number=scale_id))
    db.delete(row)
    db.flush()


def _revise(db: Session, note: SessionNote, text: str, person: str) -> None:
    db.add(NoteRevision(note_id=note.id, text=text, person=person, written=utc_now()))
    db.flush()


def _notes(db: Session, session_id: int) -> tuple[Note, ...]:
    query = select(NoteRevision).join(SessionNote, SessionNote.id == NoteRevision.note_id)
    revisions: dict[int, list[NoteRevision]] = defaultdict(list)
    for row in db.scalars(query.where(SessionNote.session_id == session_id).order_by(NoteRevision.id)):
        revisions[row.note_id].append(row)
    return tuple(_note(note_id, rows) for note_id, rows in sorted(revisions.items()))


def _note(note_id: int, rows: list[NoteRevision]) -> Note:
    newest = rows[-1]
    return Note(note_id, newest.text, newest.person, rows[0].written, newest.written if len(rows) > 1 else None)


def _scales(db: Session, session_id: int) -> list[OutcomeScale]:
    return list(db.scalars(select(OutcomeScale).where(OutcomeScale.session_id == session_id).order_by(OutcomeScale.id)))
