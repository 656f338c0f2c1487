"""What was done in a session: its trials and drives, and the maps and parameter sets that they were driven with."""

from dataclasses import dataclass
from datetime import datetime

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.store.tables import Drive, ParameterSet, Profile, Trial


@dataclass(frozen=True, slots=True)
class UsedSet:
    """A parameter set, on its version of the map, that something in a session was driven with."""

    parameters_id: int
    title: str
    hash: str
    version: int  # of the map
    origin: str  # of that version: calibration, adaptation, back


def trials_of_session(db: Session, session_id: int) -> list[Trial]:
    """Return the trials of a session in the order driven, also those that do not count."""
    return list(db.scalars(select(Trial).where(Trial.session_id == session_id).order_by(Trial.id)))


def counted_by_session(db: Session, patient_id: int) -> dict[int, int]:
    """Return how many trials count in each session of a patient, by its id; a session without one is missing."""
    counts = select(Trial.session_id, func.count(Trial.id)).where(
        Trial.patient_id == patient_id, Trial.status == "done", Trial.kept.is_(True)
    )
    return dict(db.execute(counts.group_by(Trial.session_id)).all())


def drives_of_session(db: Session, session_id: int) -> list[Drive]:
    """Return the drives of real chairs in a session, in the order driven."""
    return list(db.scalars(select(Drive).where(Drive.session_id == session_id).order_by(Drive.id)))


def sets_of_session(db: Session, session_id: int) -> list[UsedSet]:
    """Return each parameter set that a trial or a drive of the session used, in the order of its first use."""
    columns = (ParameterSet.id, ParameterSet.title, ParameterSet.hash, Profile.version, Profile.origin)
    uses: list[tuple[datetime, UsedSet]] = []
    for kind in (Trial, Drive):
        query = (
            select(kind.started, *columns)
            .join(ParameterSet, ParameterSet.id == kind.parameters_id)
            .join(Profile, Profile.id == ParameterSet.profile_id)
            .where(kind.session_id == session_id)
        )
        uses += [(row[0], UsedSet(*row[1:])) for row in db.execute(query)]
    return list(dict.fromkeys(used for _, used in sorted(uses, key=lambda use: use[0])))


def set_of(db: Session, used: UsedSet) -> tuple[ParameterSet, Profile]:
    """Return the rows of a parameter set and of its map."""
    row = db.get_one(ParameterSet, used.parameters_id)
    return row, db.get_one(Profile, row.profile_id)
