"""What was practised on the virtual chair, by hash, and how it differs from what would be armed."""

from collections.abc import Iterator
from datetime import datetime
from typing import NamedTuple

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.calibration.vocabulary import DriveParameters
from app.refusals import Conflict
from app.store.parameters import as_document
from app.store.tables import Parameters, Profile, Run, Trial

PRACTICE_ENDS = ("goal", "time-out", "by hand")  # a trial that a fault ended shows little of how the chair drives


class Practice(NamedTuple):
    """How often, and when last, a patient drove the virtual chair with exactly these parameters."""

    trials: int
    last: datetime | None


NO_PRACTICE = Practice(0, None)


class PracticeHistory:
    """Reads a patient's trials; hashes are computed anew, because a stored one may be of an older program's fields.

    Trials count only where they were driven as the shirt in use would drive now: worn, or simulated (`simulated`).
    """

    def __init__(self) -> None:
        self._hashes: dict[int, str] = {}  # of rows of parameters, which never change

    def practice(self, db: Session, patient_id: int, digest: str, *, simulated: bool | None) -> Practice:
        """Return what the patient has practised of the set of this hash, in finished trials that were kept."""
        driven = _driven(db, patient_id, simulated)
        started = [trial.started for trial, row, profile in driven if self._is(row, profile, digest)]
        return Practice(len(started), max(started, default=None))

    def newest(self, db: Session, patient_id: int, *, simulated: bool | None) -> DriveParameters | None:
        """Return the set of the newest such trial, None when there is none."""
        for _trial, row, profile in _driven(db, patient_id, simulated):
            return _document(row, profile)
        return None

    def _is(self, row: Parameters, profile: Profile, digest: str) -> bool:
        if row.id not in self._hashes:
            document = _document(row, profile)
            self._hashes[row.id] = "" if document is None else document.hash
        return self._hashes[row.id] == digest


def _driven(db: Session, patient_id: int, simulated: bool | None) -> Iterator[tuple[Trial, Parameters, Profile]]:
    """Yield the patient's finished and kept trials in which the chair was permitted to move, the newest first."""
    found = db.execute(
        select(Trial, Parameters, Profile)
        .join(Parameters, Parameters.id == Trial.parameters_id)
        .join(Profile, Profile.id == Parameters.profile_id)
        .join(Run, Run.id == Trial.run_id)
        .where(Trial.patient_id == patient_id, Trial.kept.is_(True), Trial.end.in_(PRACTICE_ENDS))
        .where(Run.simulated.is_(simulated))
        .order_by(Trial.id.desc())
    )
    yield from ((trial, row, profile) for trial, row, profile in found if trial.measures is not None)


def _document(row: Parameters, profile: Profile) -> DriveParameters | None:
    try:
        return as_document(row, profile)
    except Conflict:  # of a program that knew other fields
        return None
