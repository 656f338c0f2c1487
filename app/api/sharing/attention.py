"""The patients by what needs attention, for reviewers and clinicians, in one answer."""

from collections.abc import Sequence

from fastapi import APIRouter

from app.api.answers import Answer
from app.api.deps import Anyone, People, PeopleParts
from app.api.parts import Web, WebParts
from app.quantities import Document
from app.scoring.verdict.verdicts import task_verdicts
from app.session.clinic_spread import Task
from app.store.learning_trials import counted_trials
from app.store.log import write_log
from app.store.sharing.attention import Attention, Reason, patients_and_reasons, tasks_of
from app.store.tables import Patient

router = APIRouter(tags=["review"])

URGENCY: tuple[Reason, ...] = ("deterioration", "halted", "comment", "unsigned", "absent")


class AttentionView(Answer):
    """One reason why somebody should look at a patient."""

    reason: Reason
    number: int  # of trials, comments, sessions or days
    session_id: int | None  # where to look; both null: the patient's learning curve
    trial_id: int | None
    sentence: str  # of a deterioration, else empty


class PatientAttention(Document):
    """A patient with the reasons to look, the most urgent first; none: nothing needs attention."""

    patient_id: int
    code: str
    pseudonym: str
    reasons: list[AttentionView]


@router.get("/attention")
def attention(who: Anyone, parts: PeopleParts, web: Web) -> list[PatientAttention]:
    """List the patients that the person who asks may see, those who need attention first."""
    with parts.database.transaction(closing=True) as db:
        found = patients_and_reasons(db, who.clinic_id, who.person_id)
        write_log(db, who.name, "patients viewed by attention")
    listed = [_view(one, [*_worse(parts, web, who.clinic_id, one.id), *reasons]) for one, reasons in found]
    return sorted(listed, key=lambda one: URGENCY.index(one.reasons[0].reason) if one.reasons else len(URGENCY))


def _view(patient: Patient, reasons: Sequence[Attention]) -> PatientAttention:
    ordered = sorted(reasons, key=lambda one: URGENCY.index(one.reason))
    return PatientAttention(
        patient_id=patient.id,
        code=patient.code,
        pseudonym=patient.pseudonym,
        reasons=[AttentionView.of(one) for one in ordered],
    )


def _worse(parts: People, web: WebParts, clinic_id: int, patient_id: int) -> list[Attention]:
    """Return a reason for each task in which a patient has become worse than noise explains."""
    with parts.database.transaction() as db:
        tasks = [Task(clinic_id, *task) for task in tasks_of(db, clinic_id, patient_id)]
        counted = [counted_trials(db, clinic_id, patient_id, task.floorplan, task.path) for task in tasks]
    reasons = []
    for task, every in zip(tasks, counted, strict=True):
        rows = [one.row() for one in every if one.group == task.group]
        worse = web.computing.ask(task_verdicts, rows, web.spread.of_others(task, patient_id)).deterioration
        if worse:
            sentence = next(iter(worse.values()))
            newest = every[-1].trial
            reasons.append(Attention("deterioration", len(worse), newest.session_id, None, sentence))
    return reasons
