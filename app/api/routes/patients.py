"""Patients, and who is here now."""

from typing import Annotated

from fastapi import APIRouter
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.deps import Anyone, Clinician, PeopleParts, RowId
from app.api.parts import Web, show_visit
from app.quantities import Count, Document, Name, Note, Title
from app.store.database import Transaction
from app.store.log import write_log
from app.store.patients import (
    add_patient,
    all_patients,
    delete_patient,
    end_session,
    find_patient,
    open_session,
    patient_figures,
    restore_patient,
    session_progress,
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
    """A patient as the list shows them."""

    id: int
    code: str
    pseudonym: str
    note: str
    created: str
    sessions: int
    trials: int
    last_seen: str | None


class OpenVisit(Document):
    """Who has come."""

    patient_id: Count


class SessionView(Document):
    """The visit that is going on."""

    id: int
    number: int
    started: str
    opened_by: str | None  # a person's name


class VisitView(Document):
    """Who is here now, and how far they have come."""

    patient: PatientView | None
    session: SessionView | None
    has_profile: bool
    steps_done: list[str]


def _view(db: Transaction, patient: Patient) -> PatientView:
    sessions, trials, last = patient_figures(db, patient)
    return PatientView(
        id=patient.id,
        code=patient.code,
        pseudonym=patient.pseudonym,
        note=patient.note,
        created=patient.created.isoformat(),
        sessions=sessions,
        trials=trials,
        last_seen=None if last is None else last.started.isoformat(),
    )


@router.get("/patients")
def list_patients(who: Anyone, parts: PeopleParts) -> list[PatientView]:
    """List the patients, the last seen first."""
    with parts.database.transaction() as db:
        return [_view(db, patient) for patient in all_patients(db, who.clinic_id)]


@router.post("/patients", status_code=201)
def new_patient(body: NewPatient, who: Clinician, parts: PeopleParts) -> PatientView:
    """Add a patient."""
    with parts.database.transaction() as db:
        patient = add_patient(db, who.clinic_id, body.code, body.pseudonym, body.note)
        write_log(db, who.name, "patient added", patient=patient.id)
        return _view(db, patient)


@router.delete("/patients/{patient_id}")
def remove_patient(patient_id: RowId, who: Clinician, parts: PeopleParts) -> PatientView:
    """Take a patient from the list; it can be undone."""
    with parts.database.transaction() as db:
        patient = delete_patient(db, who.clinic_id, patient_id)
        write_log(db, who.name, "patient deleted", patient=patient_id)
        return _view(db, patient)


@router.post("/patients/{patient_id}/restore")
def undo_removal(patient_id: RowId, who: Clinician, parts: PeopleParts) -> PatientView:
    """Undo the deletion of a patient."""
    with parts.database.transaction() as db:
        patient = restore_patient(db, who.clinic_id, patient_id)
        write_log(db, who.name, "patient restored", patient=patient_id)
        return _view(db, patient)


def _visit(parts: PeopleParts, clinic_id: int) -> VisitView:
    with parts.database.transaction() as db:
        session = open_session(db, clinic_id)
        if session is None:
            return VisitView(patient=None, session=None, has_profile=False, steps_done=[])
        has_profile, done = session_progress(db, session)
        return VisitView(
            patient=_view(db, find_patient(db, clinic_id, session.patient_id)),
            session=SessionView(
                id=session.id,
                number=session.number,
                started=session.started.isoformat(),
                opened_by=session.opened_by,
            ),
            has_profile=has_profile,
            steps_done=done,
        )


@router.get("/visit")
def who_is_here(who: Anyone, parts: PeopleParts) -> VisitView:
    """Tell who is here now."""
    return _visit(parts, who.clinic_id)


@router.post("/visit")
async def open_visit(body: OpenVisit, who: Clinician, parts: PeopleParts, web: Web) -> VisitView:
    """Open a visit of a patient; the one that was open is ended, and its patient's parameters are unloaded."""

    def _open() -> VisitView:
        with parts.database.transaction() as db:
            session = start_session(db, who.clinic_id, body.patient_id, who.name)
            write_log(db, who.name, "visit opened", patient=body.patient_id, session=session.id)
        return _visit(parts, who.clinic_id)

    async with web.visit.undisturbed("open a visit"):
        answer = await run_in_threadpool(_open)
        await parts.sockets.close_ended_screens()
        await web.visit.visit_changed()
        await show_visit(web)
    return answer


@router.delete("/visit")
async def end_visit(who: Clinician, parts: PeopleParts, web: Web) -> VisitView:
    """End the visit."""

    def _end() -> VisitView:
        with parts.database.transaction(closing=True) as db:
            end_session(db, who.clinic_id)
            write_log(db, who.name, "visit ended")
        return _visit(parts, who.clinic_id)

    async with web.visit.undisturbed("end the visit"):
        answer = await run_in_threadpool(_end)
        await parts.sockets.close_ended_screens()
        await web.view.close()
        await web.visit.visit_changed()
    return answer
