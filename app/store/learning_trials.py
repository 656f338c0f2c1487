"""The trials of a learning curve, each with its session and the version of the map that it was driven with."""

from collections import Counter
from collections.abc import Hashable, Iterable, Sequence
from typing import NamedTuple, TypeAlias

from sqlalchemy import JSON, ColumnElement, Row, func, select, true
from sqlalchemy.orm import Session

from app.json_values import JsonDocument
from app.source import SourceGroup, source_description
from app.store.consent import consented
from app.store.run_groups import is_of_group
from app.store.tables import ParameterSet, Patient, PatientSession, Profile, Run, Trial

FAMILIARISATION = 3  # first trials of a task with one kind of source, in which a person gets used to it
MOST_TRIALS = 2000  # the newest, that the clinic's median is of


_TrialRow: TypeAlias = Row[int, int, int, bool, JsonDocument | None, int]
"""Patient, id, number, whether it is kept, measures, number of the session."""


class CountedTrial(NamedTuple):
    """A trial of a learning curve: finished, kept and measured."""

    trial: Trial
    session: int  # number of the session: 1, 2, 3 ... per patient
    profile_version: int
    origin: str  # of that version: calibration, adaptation, back
    familiarisation: bool  # one of the first three of its task and source

    @property
    def group(self) -> SourceGroup:
        """Return the group of trials that it belongs to."""
        return self.trial.run.source.group

    def row(self) -> JsonDocument:
        """Return its measures and its attributes by name."""
        return {
            **(self.trial.measures or {}),
            "number": self.trial.number,
            "id": self.trial.id,
            "session": self.session,
            "familiarisation": self.familiarisation,
            "profile_version": self.profile_version,
            "origin": self.origin,
            "simulated": self.trial.run.simulated,
            "source": source_description(self.trial.run.source),
        }


def counted_trials(db: Session, patient_id: int, floorplan: str, path: str) -> list[CountedTrial]:
    """Return a patient's trials on one path over all sessions, of every source, the newest last."""
    rows = db.execute(
        select(Trial, PatientSession.number, Profile.version, Profile.origin)
        .join(PatientSession, PatientSession.id == Trial.session_id)
        .join(ParameterSet, ParameterSet.id == Trial.parameters_id)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .where(Trial.patient_id == patient_id, *_measured(floorplan, path))
        .order_by(Trial.id)
    ).all()
    familiarisation = _familiarisation((trial.id, trial.run.source.group) for trial, *_ in rows)
    return [CountedTrial(*row, row[0].id in familiarisation) for row in rows if row[0].kept]


def trials_of_everybody(db: Session, floorplan: str, path: str, group: SourceGroup) -> dict[int, list[JsonDocument]]:
    """Return the rows of each patient's trials on one path, the newest 2000, for the clinic's median spread.

    Trials that a person drove are those of patients who have consented to it; nobody drove the simulated ones.

    The rows hold numbers only: `id`, `number`, `session`, `familiarisation` and the measures.
    """
    columns = (Trial.patient_id, Trial.id, Trial.number, Trial.kept, Trial.measures)
    rows_of_all = db.execute(
        select(*columns, PatientSession.number.label("session"))
        .join(PatientSession, PatientSession.id == Trial.session_id)
        .join(Patient, Patient.id == Trial.patient_id)
        .join(Run, Run.id == Trial.run_id)
        .where(Patient.deleted.is_(None), is_of_group(group), _may_be_used(group))
        .where(*_measured(floorplan, path))
        .order_by(Trial.id.desc())
        .limit(MOST_TRIALS)
    ).all()[::-1]
    people: dict[int, list[_TrialRow]] = {}
    for row in rows_of_all:
        people.setdefault(row.patient_id, []).append(row)
    return {person: _numbers(rows, group) for person, rows in people.items()}


def count_of_everybody(db: Session, floorplan: str, path: str) -> int:
    """Return how many trials on one path were ended, of every patient and source; the index alone tells it."""
    ended = (Trial.floorplan == floorplan, Trial.path == path, Trial.status == "done")
    return db.scalar(select(func.count()).select_from(Trial).where(*ended)) or 0


def prior_consents(db: Session, group: SourceGroup) -> frozenset[int]:
    """Return the patients who have consented to the use of their trials; none where no consent is needed."""
    if group == "simulated":
        return frozenset()
    return frozenset(db.scalars(select(Patient.id).where(_may_be_used(group))))


def _may_be_used(group: SourceGroup) -> ColumnElement[bool]:
    return true() if group == "simulated" else consented("clinic_prior")


def _numbers(rows: Sequence[_TrialRow], group: SourceGroup) -> list[JsonDocument]:
    familiarisation = _familiarisation((row.id, group) for row in rows)
    return [
        {
            **(row.measures or {}),
            "id": row.id,
            "number": row.number,
            "session": row.session,
            "familiarisation": row.id in familiarisation,
        }
        for row in rows
        if row.kept
    ]


def _measured(floorplan: str, path: str) -> tuple[ColumnElement[bool], ...]:
    """Return the conditions of a measured trial on this path; it may have been discarded."""
    return (
        Trial.floorplan == floorplan,
        Trial.path == path,
        Trial.status == "done",
        Trial.measures != JSON.NULL,
    )


def compared_trials(trials: Sequence[Trial]) -> set[int]:
    """Return the ids of those of a patient's trials, in the order driven, that verdicts compare."""
    measured = [trial for trial in trials if trial.status == "done" and trial.measures is not None]
    familiarisation = _familiarisation(
        (trial.id, (trial.floorplan, trial.path, trial.run.source.group)) for trial in measured
    )
    return {trial.id for trial in measured if trial.kept} - familiarisation


def _familiarisation(trials: Iterable[tuple[int, Hashable]]) -> set[int]:
    """Return the ids of the first three trials of each kind.

    `trials` are one person's with their kind, in the order driven. A discarded trial counts: it was practice, too.
    """
    driven: Counter[Hashable] = Counter()
    first = set()
    for trial_id, kind in trials:
        driven[kind] += 1
        if driven[kind] <= FAMILIARISATION:
            first.add(trial_id)
    return first
