"""The answers on sessions and their records."""

from datetime import date
from typing import Any

from pydantic import Field

from app.api.answers import Answer, MomentText, OriginView
from app.api.interface_test_view import InterfaceTestView
from app.api.routes.source_view import SourceView
from app.features.records.service import note_history, session_record
from app.features.records.sign_off import SignOff, sign_off_history
from app.quantities import Document
from app.store.database import Transaction
from app.store.interface_tests import interface_tests_of_session
from app.store.origins import origin_of
from app.store.session_contents import drives_of_session, sets_of_session, trials_of_session
from app.store.tables import Patient, PatientSession
from app.texts import Text


class SignOffView(Answer):
    """Who signed a session off, and when."""

    person: str
    at: MomentText


class PastSignOff(SignOffView):
    """A sign-off, and how it was unlocked; null while it is in force."""

    unlocked: MomentText | None
    unlocked_by: str | None
    reason: str | None


class SessionRow(Document):
    """A session in the list of a patient's sessions."""

    id: int
    number: int
    started: str
    ended: str | None
    trials: int  # that count
    sign_off: SignOffView | None
    origin: OriginView | None  # null: held in this clinic


class RevisionView(Answer):
    """One text of a note."""

    text: str
    person: str
    written: MomentText


class NoteView(Document):
    """A note with all its revisions, the newest first."""

    id: int
    revisions: list[RevisionView]


class ScaleView(Answer):
    """The total of an outcome scale."""

    id: int
    name: str
    total: float
    day: date


class SessionTrial(Answer):
    """A trial of a session."""

    id: int
    number: int
    floorplan_title: Text = Field(validation_alias="place_title")
    path: str
    status: str
    end: str | None
    kept: bool
    discard_reason: Text | None
    measures: dict[str, Any] | None
    source: SourceView


class SessionDrive(Answer):
    """A drive of a real chair in a session."""

    id: int
    started: MomentText
    end: str | None
    distance: float | None
    source: SourceView


class UsedSetView(Answer):
    """A parameter set that something was driven with, and the version of its map."""

    title: str
    hash: str
    version: int
    origin: str


class SessionRecordView(Document):
    """The record of a session, and what was done in it."""

    id: int
    number: int
    patient_id: int
    code: str
    started: str
    opened_by: str | None
    ended: str | None
    origin: OriginView | None  # null: held in this clinic
    version: str  # of the software; empty when it was not recorded
    goal: str
    notes: list[NoteView]
    scales: list[ScaleView]
    trials: list[SessionTrial]
    drives: list[SessionDrive]
    tests: list[InterfaceTestView]  # two-minute tests
    sets: list[UsedSetView]
    sign_off: SignOffView | None
    sign_offs: list[PastSignOff]


def sign_off_view(sign_off: SignOff | None) -> SignOffView | None:
    """Return a sign-off as it is answered."""
    return None if sign_off is None else SignOffView.of(sign_off)


def record_view(db: Transaction, session: PatientSession) -> SessionRecordView:
    """Return the whole record of a session."""
    record = session_record(db, session.id)
    return SessionRecordView(
        id=session.id,
        number=session.number,
        patient_id=session.patient_id,
        code=db.get_one(Patient, session.patient_id).code,
        started=session.started.isoformat(),
        opened_by=session.opened_by,
        ended=None if session.ended is None else session.ended.isoformat(),
        origin=None if (origin := origin_of(db, session.id)) is None else OriginView.of(origin),
        version=record.version,
        goal=record.goal,
        notes=[_note(db, note.id) for note in record.notes],
        scales=[ScaleView.of(scale) for scale in record.scales],
        trials=[SessionTrial.of(trial) for trial in trials_of_session(db, session.id)],
        drives=[SessionDrive.of(drive) for drive in drives_of_session(db, session.id)],
        tests=[InterfaceTestView.of_row(test, session.number) for test in interface_tests_of_session(db, session.id)],
        sets=[UsedSetView.of(used) for used in sets_of_session(db, session.id)],
        sign_off=sign_off_view(record.sign_off),
        sign_offs=[PastSignOff.of(row) for row in sign_off_history(db, session.id)],
    )


def _note(db: Transaction, note_id: int) -> NoteView:
    return NoteView(id=note_id, revisions=[RevisionView.of(row) for row in reversed(note_history(db, note_id))])
