"""The learning curves of a patient."""

from collections import Counter
from typing import Annotated, Any

from fastapi import APIRouter, Query

from app.api.deps import Anyone, PeopleParts, RowId
from app.api.parts import Web
from app.api.routes.source_view import RequestedGroup
from app.quantities import Document
from app.scoring.learning import learning_curves
from app.source import SourceGroup
from app.store.learning_trials import counted_trials
from app.store.log import write_log
from app.store.patients import find_patient

router = APIRouter(tags=["review"])

MOST_TRAJECTORIES = 40  # the newest; more could not be told apart


class TrialLine(Document):
    """The trajectory of one trial."""

    number: int
    x: list[float]
    y: list[float]


class LearningView(Document):
    """Kept trials of one source on one path over all sessions, with learning curves and trajectories."""

    source: SourceGroup  # of all that is shown; trials of another one are in no curve with these
    others: dict[SourceGroup, int]  # how many kept trials there are of the other sources
    trials: list[dict[str, Any]]
    curves: dict[str, Any]
    trajectories: list[TrialLine]
    path: list[tuple[float, float]]


@router.get("/patients/{patient_id}/learning")
def learning(
    patient_id: RowId,
    floorplan: Annotated[str, Query(max_length=64)],
    path: Annotated[str, Query(max_length=64)],
    source: RequestedGroup,
    who: Anyone,
    parts: PeopleParts,
    web: Web,
) -> LearningView:
    """Return the learning curve of a patient on one path."""
    with parts.database.transaction(closing=True) as db:
        find_patient(db, who.clinic_id, patient_id)
        every = counted_trials(db, who.clinic_id, patient_id, floorplan, path)
        write_log(db, who.name, "patient viewed", patient=patient_id)
    counted = [one for one in every if one.group == source]
    rows = [one.row() for one in counted]
    lines = []
    for trial, *_ in counted[-MOST_TRAJECTORIES:]:
        found = web.trajectories.of(web.runs.folder_of(trial.run_id))
        if found is not None:
            lines.append(TrialLine(number=trial.number, x=found.x, y=found.y))
    return LearningView(
        source=source,
        others=dict(Counter(one.group for one in every if one.group != source)),
        trials=rows,
        curves=web.computing.ask(learning_curves, rows, every_model=True),
        trajectories=lines,
        path=[(x, y) for x, y in counted[-1].trial.path_points] if counted else [],
    )
