"""Stores a course of sessions with measured trials, without recordings, as if they were driven on earlier days."""

from collections.abc import Sequence
from typing import Any

from clinic_rows import ClinicRows
from sqlalchemy.orm import Session

from app.world.floorplan import FloorPlan


def store_course(
    db: Session, _clinic_id: int, patient_id: int, plan: FloorPlan, sessions: Sequence[Sequence[dict[str, Any]]]
) -> list[int]:
    """Store the trials of each session by their measures on the first path of `plan`; return their ids."""
    return ClinicRows(db).course(patient_id, plan, sessions)
