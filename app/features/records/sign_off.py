"""Sign-off of a session: it locks all that belongs to the session, until an owner unlocks it.

One rule holds for every function and every route: `lock_signed` looks at the rows that a transaction is about to
write. A row whose session is signed off is refused, whoever changes it.
"""

from dataclasses import dataclass
from datetime import datetime
from typing import Any

from sqlalchemy import event, inspect, select, true
from sqlalchemy.orm import ORMExecuteState, Session, UOWTransaction

from app.clock import utc_now
from app.features.records.tables import NoteRevision, OutcomeScale, SessionNote, SessionSignOff
from app.refusals import Conflict
from app.store.tables import CalibrationStep, Drive, InterfaceTest, PatientSession, Profile, Run, Table, Trial
from app.texts import Text

# Tables whose rows belong to one session. Parameters are the patient's, and go on after a session.
OF_A_SESSION = (
    *(PatientSession, CalibrationStep, Run, Profile, Trial, Drive, InterfaceTest),
    *(SessionNote, NoteRevision, OutcomeScale),
)

# Columns that are computed from the recording, again when the program computes them otherwise.
DERIVED: dict[type[Table], set[str]] = {Trial: {"quality", "measures"}}


@dataclass(frozen=True, slots=True)
class SignOff:
    """Who signed a session off, and when."""

    person: str
    at: datetime


def sign_off_of(db: Session, session_id: int) -> SignOff | None:
    """Return the sign-off that is in force, None when there is none."""
    row = _in_force(db, session_id)
    return None if row is None else SignOff(row.person, row.at)


def sign_offs_of(db: Session, patient_id: int) -> dict[int, SignOff]:
    """Return the sign-offs in force of a patient's sessions, by the id of the session."""
    query = select(SessionSignOff).join(PatientSession, PatientSession.id == SessionSignOff.session_id)
    rows = db.scalars(query.where(PatientSession.patient_id == patient_id, SessionSignOff.unlocked.is_(None)))
    return {row.session_id: SignOff(row.person, row.at) for row in rows}


def sign_off_history(db: Session, session_id: int) -> list[SessionSignOff]:
    """Return all sign-offs of a session with their unlocking, the oldest first."""
    query = select(SessionSignOff).where(SessionSignOff.session_id == session_id)
    return list(db.scalars(query.order_by(SessionSignOff.id)))


def require_unsigned(db: Session, session_id: int) -> None:
    """Raise Conflict when a session is signed off: for functions that may also find that nothing changes."""
    _require_unsigned(db, {session_id})


def sign_off(db: Session, session: PatientSession, person: str) -> SignOff:
    """Sign a session off; one that is open is ended with it."""
    require_unsigned(db, session.id)
    trial = select(Trial.id).where(Trial.session_id == session.id, Trial.status == "running").limit(1)
    drive = select(Drive.id).where(Drive.session_id == session.id, Drive.ended.is_(None)).limit(1)
    test = select(InterfaceTest.id).where(InterfaceTest.session_id == session.id, InterfaceTest.status == "running")
    if any(db.scalar(going_on) is not None for going_on in (trial, drive, test.limit(1))):
        raise Conflict(Text("records-still-driven"))
    session.ended = session.ended or utc_now()
    db.flush()
    row = SessionSignOff(
        session_id=session.id, person=person, at=utc_now(), unlocked=None, unlocked_by=None, reason=None
    )
    db.add(row)
    db.flush()
    return SignOff(row.person, row.at)


def unlock(db: Session, session: PatientSession, person: str, reason: str) -> SessionSignOff:
    """Unlock a session that is signed off, for a reason; the sign-off stays in its history."""
    row = _in_force(db, session.id)
    if row is None:
        raise Conflict(Text("records-not-signed", session=session.number))
    row.unlocked, row.unlocked_by, row.reason = utc_now(), person, reason
    db.flush()
    return row


def lock_signed(db: Session) -> None:
    """Refuse every change that `db` is about to write to a row of a signed session, or that adds or removes one."""

    @event.listens_for(db, "before_flush")
    def _rows(db: Session, _context: UOWTransaction, _instances: object) -> None:
        with db.no_autoflush:
            changed = (row for row in (*db.new, *db.dirty, *db.deleted) if isinstance(row, OF_A_SESSION))
            _require_unsigned(db, {session for row in changed for session in _sessions_changed(db, row)})

    @event.listens_for(db, "do_orm_execute")
    def _statement(state: ORMExecuteState) -> None:
        if not (state.is_update or state.is_delete) or state.bind_mapper is None:
            return
        kind = state.bind_mapper.class_
        if kind in OF_A_SESSION:
            statement: Any = state.statement
            where = statement.whereclause
            _require_unsigned(db, set(db.scalars(_session_ids(kind).where(true() if where is None else where))))


def _sessions_changed(db: Session, row: Table) -> set[int]:
    """Return the sessions that a row belongs to, before and after its change; none when nothing of it changes."""
    state = inspect(row)
    changed = {attribute.key for attribute in state.attrs if attribute.history.has_changes()}
    if row not in db.deleted and not changed - DERIVED.get(type(row), set()):
        return set()
    if isinstance(row, NoteRevision):
        note = db.get(SessionNote, row.note_id)
        return set() if note is None else {note.session_id}
    key = "id" if isinstance(row, PatientSession) else "session_id"
    return {each for each in state.attrs[key].history.sum() if each is not None}


def _session_ids(kind: type[Table]) -> Any:
    """Return a query of the sessions of the rows of a table."""
    if kind is PatientSession:
        return select(PatientSession.id)
    if kind is NoteRevision:
        return select(SessionNote.session_id).join(NoteRevision, NoteRevision.note_id == SessionNote.id)
    return select(inspect(kind).columns["session_id"])


def why_locked(db: Session, session_id: int) -> Text | None:
    """Return why nothing of a session may be changed: it is signed off. None when it is not."""
    return _signed(db, {session_id})


def _require_unsigned(db: Session, sessions: set[int]) -> None:
    """Raise Conflict when one of these sessions is signed off."""
    if refusal := _signed(db, sessions):
        raise Conflict(refusal)


def _signed(db: Session, sessions: set[int]) -> Text | None:
    """Return the sentence that one of these sessions is signed off; None when none is."""
    if not sessions:
        return None
    query = select(SessionSignOff, PatientSession.number).join(
        PatientSession, PatientSession.id == SessionSignOff.session_id
    )
    signed = db.execute(
        query.where(SessionSignOff.session_id.in_(sessions), SessionSignOff.unlocked.is_(None)).limit(1)
    ).first()
    if signed is None:
        return None
    row, number = signed
    at = row.at.astimezone()
    return Text("records-signed", session=number, person=row.person, day=at.date(), time=at.time())


def _in_force(db: Session, session_id: int) -> SessionSignOff | None:
    query = select(SessionSignOff).where(SessionSignOff.session_id == session_id)
    return db.scalar(query.where(SessionSignOff.unlocked.is_(None)))
