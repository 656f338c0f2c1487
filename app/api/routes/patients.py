"""Patients, and the open session."""

from typing import Annotated

from fastapi import APIRouter
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.deps import (
    Anyone,
    Clinician,
    Db,
    LivePart,
    PlacesPart,
    ReplaysPart,
    RowId,
    SessionFlowPart,
    SettingsPart,
    SocketsPart,
    ViewKeeperPart,
)
from app.api.page_session import OWN_NAME, ClinicianInSession, any_session
from app.api.routes.obstacle_view import ObstacleView
from app.api.sign_in.identity import SignedInPerson
from app.api.view.view_keeper import open_view
from app.news import News
from app.quantities import Count, Document, Line, Name, Note, Title
from app.session.open_session import SessionFlow
from app.store.consent import has_consented
from app.store.database import Database, Transaction
from app.store.files.disk_watch import require_room_to_record
from app.store.log import log_listing, log_viewing, write_log
from app.store.patients import (
    PatientFigures,
    add_patient,
    all_patients,
    delete_patient,
    end_session,
    find_patient,
    open_session,
    patient_figures,
    restore_patient,
    session_progress,
    session_trials,
    start_session,
)
from app.store.tables import Patient

router = APIRouter(tags=["patients"])


class NewPatient(Document):
    """A code and a pseudonym; no name is needed."""

    code: Name
    pseudonym: Title
    note: Annotated[Note, Field(max_length=2000)] = ""


class PatientView(Document):
    """An entry of the list of patients."""

    id: int
    code: str
    pseudonym: str
    note: str
    created: str
    sessions: int
    trials: int
    last_seen: str | None


class Deletion(Document):
    """Why a patient is deleted, needed while the records must be kept."""

    reason: Annotated[Line, Field(max_length=400)] = ""


class NewSession(Document):
    """The patient of a new session."""

    patient_id: Count
    ends: Count | None = None  # id of the open session of another patient which a person has agreed to end


class SessionView(Document):
    """The open session."""

    id: int
    number: int
    started: str
    opened_by: str | None  # a person's name
    trials: int  # that have ended, discarded ones included


class CurrentSession(Document):
    """The patient who is here now, the open session, and its progress."""

    patient: PatientView | None
    session: SessionView | None
    has_profile: bool
    consents_to_recording: bool  # otherwise nothing is recorded with a worn shirt
    steps_done: list[str]
    obstacle: ObstacleView | None  # why no trial would start now; None also without a calibration


def _view(db: Transaction, patient: Patient) -> PatientView:
    return _views(db, [patient])[0]


def _views(db: Transaction, patients: list[Patient]) -> list[PatientView]:
    figures = patient_figures(db, patients)
    return [_view_with(patient, figures[patient.id]) for patient in patients]


def _view_with(patient: Patient, figures: PatientFigures) -> PatientView:
    return PatientView(
        id=patient.id,
        code=patient.code,
        pseudonym=patient.pseudonym,
        note=patient.note,
        created=patient.created.isoformat(),
        sessions=figures.sessions,
        trials=figures.trials,
        last_seen=None if figures.last_seen is None else figures.last_seen.isoformat(),
    )


@router.get("/patients")
def list_patients(person: Anyone, database: Db) -> list[PatientView]:
    """List the patients, the last seen first."""
    with database.transaction(closing=True) as db:
        log_listing(db, person.name)
        return _views(db, all_patients(db))


@router.post("/patients", status_code=201)
@any_session(OWN_NAME)
def new_patient(body: NewPatient, person: Clinician, database: Db) -> PatientView:
    """Add a patient."""
    with database.transaction() as db:
        patient = add_patient(db, body.code, body.pseudonym, body.note)
        write_log(db, person.name, "patient added", patient=patient.id)
        return _view(db, patient)


@router.delete("/patients/{patient_id}")
@any_session(OWN_NAME)
def remove_patient(
    patient_id: RowId,
    person: Clinician,
    database: Db,
    replays: ReplaysPart,
    live: LivePart,
    body: Deletion | None = None,
) -> PatientView:
    """Delete a patient: everything of the patient is hidden at once, and erased after 30 days; it can be undone.

    409 without a reason while the owner's setting says that the records must be kept.

    Afterwards the patient is answered like one who does not exist.
    """
    reason = "" if body is None else body.reason.strip()
    with database.transaction() as db:
        patient = delete_patient(db, patient_id, reason)
        write_log(db, person.name, "patient deleted", patient=patient_id, reason_given=bool(reason))
        view = _view(db, patient)
    replays.close_all()  # an open replay may be one of this patient
    live.notify(News(what="deletion", patient=patient_id))
    return view


@router.post("/patients/{patient_id}/restore")
@any_session(OWN_NAME)
def undo_removal(patient_id: RowId, person: Clinician, database: Db, live: LivePart) -> PatientView:
    """Undo the deletion of a patient."""
    with database.transaction() as db:
        patient = restore_patient(db, patient_id)
        write_log(db, person.name, "patient restored", patient=patient_id)
        view = _view(db, patient)
    live.notify(News(what="restoration", patient=patient_id))
    return view


def current_session(database: Database, session_flow: SessionFlow, person: SignedInPerson) -> CurrentSession:
    """Return the open session and its patient, whom this person then has seen."""
    obstacle = ObstacleView.of(session_flow.current_obstacle())
    with database.transaction(closing=True) as db:
        session = open_session(db)
        if session is None:
            return CurrentSession(
                patient=None,
                session=None,
                has_profile=False,
                consents_to_recording=False,
                steps_done=[],
                obstacle=None,
            )
        log_viewing(db, person.name, session.patient_id)
        has_profile, done = session_progress(db, session)
        return CurrentSession(
            patient=_view(db, find_patient(db, session.patient_id)),
            session=SessionView(
                id=session.id,
                number=session.number,
                started=session.started.isoformat(),
                opened_by=session.opened_by,
                trials=session_trials(db, session),
            ),
            has_profile=has_profile,
            consents_to_recording=has_consented(db, session.patient_id, "recording"),
            steps_done=done,
            obstacle=obstacle,
        )


@router.get("/session")
def who_is_here(person: Anyone, database: Db, session_flow: SessionFlowPart) -> CurrentSession:
    """Return the patient who is here now, and the open session.

    `obstacle`: why no trial would start now, as of `GET /controls`; null when nothing is calibrated.
    """
    return current_session(database, session_flow, person)


@router.post("/session")
async def begin_session(
    body: NewSession,
    person: ClinicianInSession,
    settings: SettingsPart,
    database: Db,
    sockets: SocketsPart,
    session_flow: SessionFlowPart,
    view_keeper: ViewKeeperPart,
    places: PlacesPart,
) -> CurrentSession:
    """Open a session of a patient; 507 where the disk has no room to record it.

    409 while a session of another patient is open whose id is not in `ends`.
    """

    def _open() -> CurrentSession:
        with database.transaction() as db:
            session = start_session(db, body.patient_id, person.name, ends=body.ends)
            write_log(db, person.name, "session opened", patient=body.patient_id, session=session.id)
        return current_session(database, session_flow, person)

    await run_in_threadpool(require_room_to_record, settings.state)
    async with session_flow.undisturbed():
        answer = await run_in_threadpool(_open)
        await sockets.close_ended_screens()
        await session_flow.session_changed()
        await open_view(view_keeper, places)
    return answer


@router.delete("/session")
async def close_session(
    person: ClinicianInSession,
    database: Db,
    sockets: SocketsPart,
    session_flow: SessionFlowPart,
    view_keeper: ViewKeeperPart,
) -> CurrentSession:
    """End the session."""

    def _end() -> CurrentSession:
        with database.transaction(closing=True) as db:
            end_session(db)
            write_log(db, person.name, "session ended")
        return current_session(database, session_flow, person)

    async with session_flow.undisturbed():
        answer = await run_in_threadpool(_end)
        await sockets.close_ended_screens()
        await view_keeper.close()
        await session_flow.session_changed()
    return answer
