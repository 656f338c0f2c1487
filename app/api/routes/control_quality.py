"""The control quality of a patient's trials, and warnings for the clinician."""

from typing import Annotated, Any

from fastapi import APIRouter, Query

from app.api.deps import Anyone, ComputingPart, Db, QualitiesPart, RowId
from app.api.routes.source_view import RequestedGroup
from app.quantities import Document
from app.scoring.control_warnings import control_warnings
from app.scoring.trial_assessment import ControlWarning, TrialAssessment
from app.source import SourceGroup
from app.store.log import log_viewing
from app.store.parameters import newest_profile
from app.store.patients import find_patient
from app.store.runs import trials_of

router = APIRouter(tags=["review"])

SCALARS = ("map_angle_deg", "evr", "null_space_share", "cross_talk", "activations", "activations_per_metre")
PER_JOINT = ("map_angle_deg", "evr", "null_space_share", "span_share", "rest_rate", "activations")


class QualityRow(Document):
    """One kept trial; `joints` holds the numbers of each joint by name."""

    id: int
    number: int
    session: int
    map_version: int
    quality: dict[str, float | None]
    joints: dict[str, dict[str, float | None]]


class QualityView(Document):
    """All kept trials, in the order driven, the warnings, and a note on too few trials."""

    source: SourceGroup  # of all trials here
    trials: list[QualityRow]
    labels: dict[str, str]  # joint -> what people call it
    warnings: list[ControlWarning]
    note: str  # empty when there are trials enough


@router.get("/patients/{patient_id}/quality")
def quality(
    patient_id: RowId,
    person: Anyone,
    database: Db,
    computing: ComputingPart,
    qualities: QualitiesPart,
    source: RequestedGroup,
    floorplan: Annotated[str | None, Query(max_length=64)] = None,
    path: Annotated[str | None, Query(max_length=64)] = None,
) -> QualityView:
    """Return the quality of control over trials: of one path, or of all when none is named.

    `note`: which trends cannot be told yet (docs/learning/quality.md).
    """
    with database.transaction(closing=True) as db:
        find_patient(db, patient_id)
        trials = trials_of(db, patient_id, floorplan, path)
        newest = newest_profile(db, patient_id)
        log_viewing(db, person.name, patient_id)
    assessments = qualities.assessments([trial for trial in trials if trial.run.source.group == source])
    answer = computing.ask(control_warnings, assessments, None if newest is None else newest.version)
    return QualityView(
        source=source,
        trials=[_row(assessment) for assessment in assessments],
        labels={joint.name: joint.label for assessment in assessments for joint in assessment.quality.joints},
        warnings=answer.warnings,
        note=str(answer.note or ""),
    )


def _row(trial: TrialAssessment) -> QualityRow:
    return QualityRow(
        id=trial.id,
        number=trial.number,
        session=trial.session,
        map_version=trial.map_version,
        quality=_numbers(trial.quality, SCALARS),
        joints={joint.name: _numbers(joint, PER_JOINT) for joint in trial.quality.joints},
    )


def _numbers(source: Any, names: tuple[str, ...]) -> dict[str, float | None]:
    return {name: getattr(source, name) for name in names}
