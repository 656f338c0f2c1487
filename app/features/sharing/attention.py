"""The patients by what needs attention, for reviewers and clinicians, in one answer."""

from collections import defaultdict
from collections.abc import Sequence
from datetime import timedelta
from typing import Annotated

from fastapi import APIRouter, Depends
from sqlalchemy import func, select, text
from sqlalchemy.orm import Session

from app.api.answers import Answer, Sentence
from app.api.deps import Anyone, Db
from app.api.parts import part
from app.clock import utc_now
from app.features.registration import Attention, Reason, features
from app.features.sharing.deteriorations import CountedTask, Deteriorations
from app.quantities import Document
from app.source import SourceGroup
from app.store.access.visible_patients import own_clinic_id
from app.store.log import write_log
from app.store.patients import all_patients
from app.store.run_groups import RUN_GROUP
from app.store.tables import COUNTED, Drive, Patient, PatientSession, Run, Trial

DeteriorationsPart = Annotated[Deteriorations, Depends(part(Deteriorations))]

router = APIRouter(tags=["review"])

LONG = timedelta(days=28)  # without a session
RECENT = timedelta(days=28)  # for trials and drives that halted


def patients_and_reasons(db: Session, person_id: int) -> list[tuple[Patient, list[Attention]]]:
    """Return every visible patient with the reasons to look at them; the most urgent reason first."""
    now = utc_now()
    reasons: dict[int, list[Attention]] = defaultdict(list)
    stopped = (
        select(Drive.patient_id, func.count(), func.max(Drive.session_id))
        .where(Drive.end == "fault", Drive.started >= now - RECENT)
        .group_by(Drive.patient_id)
    )
    for patient, count, session in db.execute(stopped):
        reasons[patient].append(Attention("drive", count, session, None))
    halted = (
        select(Trial.patient_id, func.count(), func.max(Trial.id))
        .where(Trial.clinic_id == own_clinic_id(db), Trial.end == "fault", Trial.started >= now - RECENT)
        .group_by(Trial.patient_id)
    )
    for patient, count, newest in db.execute(halted):
        reasons[patient].append(Attention("halted", count, None, newest))
    for feature in features().values():
        for patient, reason in feature.attention(db, person_id):
            reasons[patient].append(reason)
    sessions = select(
        PatientSession.patient_id, func.max(PatientSession.started), func.max(PatientSession.id)
    ).group_by(PatientSession.patient_id)
    for patient, last, newest in db.execute(sessions):
        away = now - last
        if away >= LONG:
            reasons[patient].append(Attention("absent", away.days, newest, None))
    return [(patient, reasons[patient.id]) for patient in all_patients(db)]


def tasks_of(db: Session, patient_id: int) -> list[tuple[str, str, SourceGroup]]:
    """Return the tasks (floor plan, path, source) of a patient in which a trial counts."""
    query = (
        select(Trial.floorplan, Trial.path, RUN_GROUP)
        .join(Run, Run.id == Trial.run_id)
        .where(Trial.clinic_id == own_clinic_id(db), Trial.patient_id == patient_id)
        .where(Trial.kept.is_(True), Trial.status == "done")
        .distinct()
        .order_by(Trial.floorplan, Trial.path)
    )
    return [(floorplan, path, group) for floorplan, path, group in db.execute(query)]


def counted_tasks(db: Session) -> list[CountedTask]:
    """Return every task of every visible patient in which a trial counts.

    The condition is that of the index `ix_trial_counted`, so that no trial is read for it.
    """
    task = (Trial.patient_id, Trial.floorplan, Trial.path, RUN_GROUP)
    counted = (
        select(*task, func.group_concat(Trial.id))
        .join(Run, Run.id == Trial.run_id)
        .where(Trial.clinic_id == own_clinic_id(db), text(COUNTED))
        .group_by(*task)
    )
    return [
        CountedTask(patient, floorplan, path, group, ",".join(sorted(trials.split(","), key=int)))
        for patient, floorplan, path, group, trials in db.execute(counted)
    ]


URGENCY: tuple[Reason, ...] = ("drive", "deterioration", "halted", "comment", "unsigned", "absent")


class AttentionView(Answer):
    """One reason why somebody should look at a patient."""

    reason: Reason
    number: int  # of drives, trials, comments, sessions or days
    session_id: int | None  # where to look; both null: the patient's learning curve
    trial_id: int | None
    sentence: Sentence  # of a deterioration, else empty


class PatientAttention(Document):
    """A patient with the reasons to look, the most urgent first; none: nothing needs attention."""

    patient_id: int
    code: str
    pseudonym: str
    reasons: list[AttentionView]
    pending: bool  # whether it is still being worked out if the patient has become worse: ask again in some seconds


@router.get("/attention")
def attention(person: Anyone, database: Db, deteriorations: DeteriorationsPart) -> list[PatientAttention]:
    """List the patients that the person who asks may see, those who need attention first.

    Reasons: drives of a real chair that a fault stopped, deterioration, halted trials, unread comments, unsigned
    sessions, no session for 28 days. Deteriorations are computed in the background; until then `pending` is true, and a
    page asks again after some seconds.
    """
    with database.transaction(closing=True) as db:
        patients = patients_and_reasons(db, person.person_id)
        tasks = counted_tasks(db)
        write_log(db, person.name, "patients viewed by attention")
    deteriorations_of = deteriorations.known(tasks)
    pending = {task.patient_id for task in tasks if task not in deteriorations_of}
    worse: dict[int, list[Attention]] = defaultdict(list)
    for task, deterioration in deteriorations_of.items():
        if deterioration is not None:
            reason = Attention(
                "deterioration", deterioration.measures, deterioration.session_id, None, deterioration.sentence
            )
            worse[task.patient_id].append(reason)
    listed = [
        _view(patient, [*worse[patient.id], *reasons], pending=patient.id in pending) for patient, reasons in patients
    ]
    return sorted(
        listed,
        key=lambda view: URGENCY.index(view.reasons[0].reason) if view.reasons else len(URGENCY),
    )


def _view(patient: Patient, reasons: Sequence[Attention], *, pending: bool) -> PatientAttention:
    ordered = sorted(reasons, key=lambda reason: URGENCY.index(reason.reason))
    return PatientAttention(
        patient_id=patient.id,
        code=patient.code,
        pseudonym=patient.pseudonym,
        reasons=[AttentionView.of(reason) for reason in ordered],
        pending=pending,
    )
