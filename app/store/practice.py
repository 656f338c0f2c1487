"""Practice on the virtual chair of this clinic: how often a parameter set was driven, found by its hash."""

from collections.abc import Iterator
from datetime import datetime
from typing import NamedTuple

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.calibration.vocabulary import DriveParameters
from app.derived_results import DerivedResults
from app.refusals import Conflict
from app.source import SourceGroup
from app.store.origins import ImportedSession
from app.store.parameters import as_document
from app.store.run_groups import is_of_group
from app.store.tables import ParameterSet, Profile, Run, Trial

PRACTICE_ENDS = ("goal", "time-out", "by hand")  # a trial that a fault ended is no practice


KEPT = 2000  # hashes; a patient has some hundred sets of parameters


class Practice(NamedTuple):
    """How often, and when last, a patient drove the virtual chair with exactly these parameters."""

    trials: int
    last: datetime | None


NO_PRACTICE = Practice(0, None)


class PracticeHistory:
    """Finds practice in a patient's trials. Hashes are computed anew: a later program may hash more fields.

    Only trials of the group of sources that the shirt in use belongs to count. Trials that came with an archive do not:
    shirt, limits and chairs were those of another clinic (decision 33).
    """

    def __init__(self) -> None:
        self._hashes: DerivedResults[int, str] = DerivedResults(KEPT)  # of rows of parameters, which never change

    def practice(self, db: Session, patient_id: int, digest: str, group: SourceGroup) -> Practice:
        """Return how often the patient practised the set of this hash, in finished and kept trials."""
        trials = _practice_trials(db, patient_id, group)
        started = [trial.started for trial, row, profile in trials if self._has_hash(row, profile, digest)]
        return Practice(len(started), max(started, default=None))

    def newest(self, db: Session, patient_id: int, group: SourceGroup) -> DriveParameters | None:
        """Return the parameter set of the newest finished and kept trial, None when there is none."""
        for _trial, row, profile in _practice_trials(db, patient_id, group):
            return _document(row, profile)
        return None

    def _has_hash(self, row: ParameterSet, profile: Profile, digest: str) -> bool:
        return self._hashes.of(row.id, lambda: _hash(row, profile)) == digest


def _practice_trials(db: Session, patient_id: int, group: SourceGroup) -> Iterator[tuple[Trial, ParameterSet, Profile]]:
    """Yield the patient's finished and kept trials of this clinic in which the chair was permitted to move.

    The newest comes first.
    """
    rows = db.execute(
        select(Trial, ParameterSet, Profile)
        .join(ParameterSet, ParameterSet.id == Trial.parameters_id)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .join(Run, Run.id == Trial.run_id)
        .where(Trial.patient_id == patient_id, Trial.kept.is_(True), Trial.end.in_(PRACTICE_ENDS))
        .where(is_of_group(group), Trial.session_id.not_in(select(ImportedSession.session_id)))
        .order_by(Trial.id.desc())
    )
    yield from ((trial, row, profile) for trial, row, profile in rows if trial.measures is not None)


def _hash(row: ParameterSet, profile: Profile) -> str:
    document = _document(row, profile)
    return "" if document is None else document.hash


def _document(row: ParameterSet, profile: Profile) -> DriveParameters | None:
    try:
        return as_document(row, profile)
    except Conflict:  # saved by a program with other fields
        return None
