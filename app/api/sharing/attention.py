"""The patients by what needs attention, for reviewers and clinicians, in one answer."""

from collections import defaultdict
from collections.abc import Sequence

from fastapi import APIRouter

from app.api.answers import Answer
from app.api.deps import Anyone, PeopleParts
from app.api.parts import Web
from app.quantities import Document
from app.store.log import write_log
from app.store.sharing.attention import Attention, Reason, counted_tasks, patients_and_reasons
from app.store.tables import Patient

router = APIRouter(tags=["review"])

URGENCY: tuple[Reason, ...] = ("drive", "deterioration", "halted", "comment", "unsigned", "absent")


class AttentionView(Answer):
    """One reason why somebody should look at a patient."""

    reason: Reason
    number: int  # of drives, trials, comments, sessions or days
    session_id: int | None  # where to look; both null: the patient's learning curve
    trial_id: int | None
    sentence: str  # of a deterioration, else empty


class PatientAttention(Document):
    """A patient with the reasons to look, the most urgent first; none: nothing needs attention."""

    patient_id: int
    code: str
    pseudonym: str
    reasons: list[AttentionView]
    pending: bool  # whether it is still being worked out if the patient has become worse: ask again in some seconds


@router.get("/attention")
def attention(who: Anyone, parts: PeopleParts, web: Web) -> list[PatientAttention]:
    """List the patients that the person who asks may see, those who need attention first."""
    with parts.database.transaction(closing=True) as db:
        found = patients_and_reasons(db, who.clinic_id, who.person_id)
        tasks = counted_tasks(db, who.clinic_id)
        write_log(db, who.name, "patients viewed by attention")
    known = web.deteriorations.known(who.clinic_id, tasks)
    pending = {task.patient_id for task in tasks if task not in known}
    worse: dict[int, list[Attention]] = defaultdict(list)
    for task, one in known.items():
        if one is not None:
            reason = Attention("deterioration", one.measures, one.session_id, None, one.sentence)
            worse[task.patient_id].append(reason)
    listed = [_view(one, [*worse[one.id], *reasons], pending=one.id in pending) for one, reasons in found]
    return sorted(listed, key=lambda one: URGENCY.index(one.reasons[0].reason) if one.reasons else len(URGENCY))


def _view(patient: Patient, reasons: Sequence[Attention], *, pending: bool) -> PatientAttention:
    ordered = sorted(reasons, key=lambda one: URGENCY.index(one.reason))
    return PatientAttention(
        patient_id=patient.id,
        code=patient.code,
        pseudonym=patient.pseudonym,
        reasons=[AttentionView.of(one) for one in ordered],
        pending=pending,
    )
