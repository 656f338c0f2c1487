"""What a patient has learnt over trials."""

from typing import Annotated, Any

from fastapi import APIRouter, Query

from app.api.deps import Anyone, PeopleParts, RowId
from app.api.flows import FlowParts
from app.quantities import Document
from app.session.learning import learning_curves
from app.session.store_learning import counted_trials
from app.session.store_log import write_log
from app.session.store_patients import find_patient

router = APIRouter(tags=["review"])

MOST_TRAJECTORIES = 40  # the newest; more make one blot


class DrivenLine(Document):
    """Where the chair went in one trial."""

    number: int
    x: list[float]
    y: list[float]


class LearningView(Document):
    """Kept trials on one path over all visits, what can be said of them, and all trajectories over the path."""

    trials: list[dict[str, Any]]
    curves: dict[str, Any]
    trajectories: list[DrivenLine]
    path: list[tuple[float, float]]


@router.get("/patients/{patient_id}/learning")
def learning(
    patient_id: RowId,
    floorplan: Annotated[str, Query(max_length=64)],
    path: Annotated[str, Query(max_length=64)],
    who: Anyone,
    parts: PeopleParts,
    flows: FlowParts,
) -> LearningView:
    """Return the learning curve of a patient on one path."""
    with parts.database.transaction(closing=True) as db:
        find_patient(db, who.clinic_id, patient_id)
        counted = counted_trials(db, who.clinic_id, patient_id, floorplan, path)
        write_log(db, who.name, "patient viewed", patient=patient_id)
    rows = [one.row() for one in counted]
    lines = []
    for trial, *_ in counted[-MOST_TRAJECTORIES:]:
        found = flows.trajectories.of(flows.runs.folder_of(trial.run_id))
        if found is not None:
            lines.append(DrivenLine(number=trial.number, x=found.x, y=found.y))
    return LearningView(
        trials=rows,
        curves=learning_curves(rows, every_model=True),
        trajectories=lines,
        path=[(x, y) for x, y in counted[-1].trial.path_points] if counted else [],
    )
