"""Patients and their sessions."""

from collections.abc import Sequence
from datetime import datetime
from typing import NamedTuple

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app import __version__
from app.clock import utc_now
from app.refusals import Conflict, NotFound
from app.similar_names import require_distinct
from app.store.access.visible_patients import WITH_DELETED, own_clinic_id, read_deleted
from app.store.keeping.record_time import require_reason
from app.store.own_rows import own_row
from app.store.tables import CalibrationStep, Patient, PatientSession, Profile, Trial
from app.texts import Text


class PatientFigures(NamedTuple):
    """What a list of patients says of one."""

    sessions: int
    trials: int  # kept
    last_seen: datetime | None  # the start of the newest session


def add_patient(db: Session, code: str, pseudonym: str, note: str) -> Patient:
    """Add a patient; Conflict when another patient of the clinic has the code."""
    query = select(Patient).where(Patient.code == code)
    same = db.scalar(query, execution_options=WITH_DELETED)
    if same is not None and same.deleted is None:
        raise Conflict(Text("store-code-taken", code=code, pseudonym=same.pseudonym))
    if same is not None:
        raise Conflict(Text("store-code-deleted", code=code))
    codes = select(Patient.code)
    require_distinct(code, db.scalars(codes, execution_options=WITH_DELETED), "names-code-taken")
    require_distinct(pseudonym, (), "names-code-taken")
    patient = Patient(
        clinic_id=own_clinic_id(db),
        code=code,
        pseudonym=pseudonym,
        note=note,
        created=utc_now(),
        deleted=None,
        deletion_reason=None,
    )
    db.add(patient)
    db.flush()
    return patient


def find_patient(db: Session, patient_id: int, *, deleted: bool = False) -> Patient:
    """Return one of the clinic's patients, a deleted one only with `deleted`."""
    missing = Text("store-no-patient", patient=patient_id)
    patient = own_row(db, Patient, patient_id, missing, deleted=deleted)
    if patient.deleted is not None and not deleted:
        raise NotFound(missing)
    return patient


def all_patients(db: Session) -> list[Patient]:
    """Return the clinic's patients, those with the latest sessions first."""
    last = select(func.max(PatientSession.started)).where(PatientSession.patient_id == Patient.id).scalar_subquery()
    return list(
        db.scalars(
            select(Patient)
            .where(Patient.deleted.is_(None))
            .order_by(func.coalesce(last, Patient.created).desc(), Patient.id.desc())
        )
    )


def delete_patient(db: Session, patient_id: int, reason: str = "") -> Patient:
    """Hide a patient and everything that belongs to the patient; it can be undone for 30 days.

    Conflict while the patient is here, and when records must be kept for longer and no `reason` is given.
    """
    patient = find_patient(db, patient_id)
    session = open_session(db)
    if session is not None and session.patient_id == patient_id:
        raise Conflict(Text("store-patient-here", pseudonym=patient.pseudonym))
    require_reason(db, patient, reason)
    patient.deleted, patient.deletion_reason = utc_now(), reason or None
    return patient


def restore_patient(db: Session, patient_id: int) -> Patient:
    """Undo a deletion."""
    patient = find_patient(db, patient_id, deleted=True)
    patient.deleted = patient.deletion_reason = None
    db.flush()
    read_deleted(db)
    return patient


def open_session(db: Session) -> PatientSession | None:
    """Return the open session, None when there is none."""
    return db.scalar(select(PatientSession).where(PatientSession.ended.is_(None)))


def start_session(
    db: Session, patient_id: int, person: str | None = None, *, ends: int | None = None
) -> PatientSession:
    """Open a session; a session of the same patient stays open.

    `person` is the name of the person who opens it, which other screens show. An open session of another patient is
    ended only if `ends` is its id; otherwise Conflict says whose it is.
    """
    find_patient(db, patient_id)
    session = open_session(db)
    if session is not None and session.patient_id == patient_id:
        return session
    if session is not None and session.id != ends:
        raise Conflict(_other_session(db, session))
    end_session(db)
    last = db.scalar(select(func.max(PatientSession.number)).where(PatientSession.patient_id == patient_id)) or 0
    session = PatientSession(
        clinic_id=own_clinic_id(db),
        patient_id=patient_id,
        number=last + 1,
        started=utc_now(),
        opened_by=person,
        ended=None,
        script=None,
        current_step=None,
        result=None,
        accepted=False,
        screen=None,
        version=__version__,
    )
    db.add(session)
    db.flush()
    return session


def _other_session(db: Session, session: PatientSession) -> Text:
    code, trials = find_patient(db, session.patient_id).code, session_trials(db, session)
    time = session.started.astimezone().time()
    if session.opened_by:
        return Text("store-session-open-by", code=code, person=session.opened_by, time=time, trials=trials)
    return Text("store-session-open", code=code, time=time, trials=trials)


def session_trials(db: Session, session: PatientSession) -> int:
    """Return how many trials of a session have ended, discarded ones included."""
    return db.scalar(select(func.count(Trial.id)).where(Trial.session_id == session.id, Trial.status == "done")) or 0


def end_session(db: Session) -> None:
    """End the open session, if there is one."""
    session = open_session(db)
    if session is not None:
        session.ended = utc_now()
        db.flush()


def patient_figures(db: Session, patients: Sequence[Patient]) -> dict[int, PatientFigures]:
    """Return the figures of some patients by their ids; a list of hundreds needs two queries."""
    ids = [patient.id for patient in patients]
    sessions = (
        select(PatientSession.patient_id, func.count(PatientSession.id), func.max(PatientSession.started))
        .where(PatientSession.patient_id.in_(ids))
        .group_by(PatientSession.patient_id)
    )
    kept_trials = (
        select(Trial.patient_id, func.count())
        .where(Trial.patient_id.in_(ids), Trial.status == "done", Trial.kept.is_(True))
        .group_by(Trial.patient_id)
    )
    trials = {row[0]: row[1] for row in db.execute(kept_trials)}
    figures = {
        patient_id: PatientFigures(count, trials.get(patient_id, 0), last)
        for patient_id, count, last in db.execute(sessions)
    }
    return {patient_id: figures.get(patient_id, PatientFigures(0, 0, None)) for patient_id in ids}


def session_progress(db: Session, session: PatientSession) -> tuple[bool, list[str]]:
    """Return whether the patient has a profile, and which calibration steps of this session are done."""
    has_profile = db.scalar(select(func.count(Profile.id)).where(Profile.patient_id == session.patient_id)) or 0
    done = db.scalars(
        select(CalibrationStep.step).where(CalibrationStep.session_id == session.id, CalibrationStep.status == "done")
    )
    return bool(has_profile), list(done)


def find_session(db: Session, session_id: int) -> PatientSession:
    """Return one of the clinic's sessions; the patient is visible and not deleted."""
    session = own_row(db, PatientSession, session_id, Text("store-no-session", session=session_id))
    find_patient(db, session.patient_id)
    return session


def sessions_of(db: Session, patient_id: int) -> list[PatientSession]:
    """Return a patient's sessions, the newest first."""
    query = select(PatientSession).where(PatientSession.patient_id == patient_id)
    return list(db.scalars(query.order_by(PatientSession.number.desc())))
