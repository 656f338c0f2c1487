"""What needs attention of each patient, as far as the database alone tells it."""

from collections import defaultdict
from datetime import timedelta
from typing import Literal, NamedTuple

from sqlalchemy import func, select, text
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.source import SourceGroup
from app.store.patients import all_patients
from app.store.records.record_tables import SessionSignOff
from app.store.sharing.comments import comments_of
from app.store.tables import COUNTED, Drive, Patient, PatientSession, Run, Trial

LONG = timedelta(days=28)  # without a session
RECENT = timedelta(days=28)  # for trials and drives that halted
GROUPS: dict[bool | None, SourceGroup] = {False: "worn", True: "simulated", None: "unknown"}

Reason = Literal["drive", "deterioration", "halted", "comment", "unsigned", "absent"]


class Attention(NamedTuple):
    """One reason why somebody should look at a patient."""

    reason: Reason
    number: int  # of drives, trials, comments, sessions or days
    session_id: int | None  # where to look
    trial_id: int | None
    sentence: str = ""  # of a deterioration


def patients_and_reasons(db: Session, clinic_id: int, person_id: int) -> list[tuple[Patient, list[Attention]]]:
    """Return every visible patient with the reasons to look at them; the most urgent reason first."""
    now = utc_now()
    reasons: dict[int, list[Attention]] = defaultdict(list)
    stopped = (
        select(Drive.patient_id, func.count(), func.max(Drive.session_id))
        .where(Drive.clinic_id == clinic_id, Drive.end == "fault", Drive.started >= now - RECENT)
        .group_by(Drive.patient_id)
    )
    for patient, count, session in db.execute(stopped):
        reasons[patient].append(Attention("drive", count, session, None))
    halted = (
        select(Trial.patient_id, func.count(), func.max(Trial.id))
        .where(Trial.clinic_id == clinic_id, Trial.end == "fault", Trial.started >= now - RECENT)
        .group_by(Trial.patient_id)
    )
    for patient, count, newest in db.execute(halted):
        reasons[patient].append(Attention("halted", count, None, newest))
    comments = defaultdict(list)
    for comment in comments_of(db, clinic_id=clinic_id, not_read_by=person_id):
        comments[comment.patient_id].append(comment)
    for patient, found in comments.items():
        reasons[patient].append(Attention("comment", len(found), found[-1].session_id, found[-1].trial_id))
    signed = select(SessionSignOff.session_id).where(SessionSignOff.unlocked.is_(None))
    unsigned = (
        select(PatientSession.patient_id, func.count(), func.max(PatientSession.id))
        .where(PatientSession.clinic_id == clinic_id, PatientSession.ended.is_not(None))
        .where(PatientSession.id.not_in(signed))
        .group_by(PatientSession.patient_id)
    )
    for patient, count, newest in db.execute(unsigned):
        reasons[patient].append(Attention("unsigned", count, newest, None))
    sessions = (
        select(PatientSession.patient_id, func.max(PatientSession.started), func.max(PatientSession.id))
        .where(PatientSession.clinic_id == clinic_id)
        .group_by(PatientSession.patient_id)
    )
    for patient, last, newest in db.execute(sessions):
        away = now - last
        if away >= LONG:
            reasons[patient].append(Attention("absent", away.days, newest, None))
    return [(patient, reasons[patient.id]) for patient in all_patients(db, clinic_id)]


def tasks_of(db: Session, clinic_id: int, patient_id: int) -> list[tuple[str, str, SourceGroup]]:
    """Return the tasks (floor plan, path, source) of a patient in which a trial counts."""
    query = (
        select(Trial.floorplan, Trial.path, Run.simulated)
        .join(Run, Run.id == Trial.run_id)
        .where(Trial.clinic_id == clinic_id, Trial.patient_id == patient_id)
        .where(Trial.kept.is_(True), Trial.status == "done")
        .distinct()
        .order_by(Trial.floorplan, Trial.path)
    )
    return [(floorplan, path, GROUPS[simulated]) for floorplan, path, simulated in db.execute(query)]


class CountedTask(NamedTuple):
    """A task (floor plan, path, source) of a patient, with the trials that count in it."""

    patient_id: int
    floorplan: str
    path: str
    group: SourceGroup
    trials: str  # their ids, joined by commas


def counted_tasks(db: Session, clinic_id: int) -> list[CountedTask]:
    """Return every task of every visible patient in which a trial counts.

    The condition is that of the index `ix_trial_counted`, so that no trial is read for it.
    """
    task = (Trial.patient_id, Trial.floorplan, Trial.path, Run.simulated)
    counted = (
        select(*task, func.group_concat(Trial.id))
        .join(Run, Run.id == Trial.run_id)
        .where(Trial.clinic_id == clinic_id, text(COUNTED))
        .group_by(*task)
    )
    return [
        CountedTask(patient, floorplan, path, GROUPS[simulated], ",".join(sorted(trials.split(","), key=int)))
        for patient, floorplan, path, simulated, trials in db.execute(counted)
    ]
