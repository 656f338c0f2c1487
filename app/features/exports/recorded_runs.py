"""The recordings of a patient with the trials and two-minute tests that they are of, as plain values for an export."""

from collections import Counter
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.refusals import NotFound
from app.source import Source
from app.store.origins import Origin, origins_of
from app.store.tables import InterfaceTest, ParameterSet, PatientSession, Profile, Run, Trial
from app.texts import Text


@dataclass(frozen=True, slots=True)
class RecordedTrial:
    """One trial, with what was measured."""

    id: int
    number: int
    floorplan: str
    title: str  # of the floor plan
    path: str
    started: datetime
    end: str | None
    kept: bool
    reason: str | None  # why it was left out
    measures: dict[str, Any]
    map_version: int
    parameters_hash: str


@dataclass(frozen=True, slots=True)
class RecordedTest:
    """One two-minute test, with what was measured."""

    number: int
    started: datetime
    end: str | None
    measures: dict[str, Any]
    workload: dict[str, Any]  # answers, 0 to 100 each; empty: not asked
    map_version: int
    parameters_hash: str


@dataclass(frozen=True, slots=True)
class RecordedRun:
    """One recording, and the trial or the test that it is of; neither: a calibration, or a drive of a real chair."""

    session: int  # number of the session
    number: int  # 1, 2, 3 ... in its session
    kind: str
    started: datetime
    folder: Path
    source: Source
    trial: RecordedTrial | None = None
    test: RecordedTest | None = None
    origin: Origin | None = None  # None: recorded in this clinic

    @property
    def stem(self) -> str:
        """Return the beginning of the names of its files, which names nobody."""
        return f"session-{self.session:02d}_run-{self.number:03d}_{self.kind}"

    @property
    def task(self) -> str:
        """Return what was done: the floor plan and path of a trial, otherwise the kind of the run."""
        return self.kind if self.trial is None else f"{self.trial.floorplan}/{self.trial.path}"


def recorded_runs(db: Session, patient_id: int, session: int | None, runs: Path) -> list[RecordedRun]:
    """Return the ended runs of a patient in the order recorded, of one session (its number) or of all (None).

    `runs` is the folder of all recordings. NotFound when the patient has no such session.
    """
    query = (
        select(Run, PatientSession.number)
        .join(PatientSession, PatientSession.id == Run.session_id)
        .where(PatientSession.patient_id == patient_id, Run.ended.is_not(None))
    )
    if session is not None:
        chosen = select(PatientSession.id).where(
            PatientSession.patient_id == patient_id, PatientSession.number == session
        )
        if db.scalar(chosen) is None:
            raise NotFound(Text("exports-no-session", session=session))
        query = query.where(PatientSession.number == session)
    origins = origins_of(db, patient_id)
    trials, tests = _trials(db, patient_id), _tests(db, patient_id)
    counts: Counter[int] = Counter()
    recorded = []
    for run, number in db.execute(query.order_by(PatientSession.number, Run.started, Run.id)):
        counts[number] += 1
        recorded.append(
            RecordedRun(
                session=number,
                number=counts[number],
                kind=run.kind,
                started=run.started,
                folder=runs / run.folder,
                source=run.source,
                trial=trials.get(run.id),
                test=tests.get(run.id),
                origin=origins.get(run.session_id),
            )
        )
    return recorded


def _trials(db: Session, patient_id: int) -> dict[str, RecordedTrial]:
    """Return the patient's finished trials by the ids of their runs."""
    query = (
        select(Trial, ParameterSet.hash, Profile.version)
        .join(ParameterSet, ParameterSet.id == Trial.parameters_id)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .where(Trial.patient_id == patient_id, Trial.status == "done")
    )
    return {
        trial.run_id: RecordedTrial(
            id=trial.id,
            number=trial.number,
            floorplan=trial.floorplan,
            title=trial.floorplan_title,
            path=trial.path,
            started=trial.started,
            end=trial.end,
            kept=trial.kept,
            reason=None if trial.discard_reason is None else str(trial.discard_reason),
            measures=trial.measures or {},
            map_version=version,
            parameters_hash=parameters_hash,
        )
        for trial, parameters_hash, version in db.execute(query)
    }


def _tests(db: Session, patient_id: int) -> dict[str, RecordedTest]:
    """Return the patient's finished two-minute tests by the ids of their runs."""
    query = (
        select(InterfaceTest, ParameterSet.hash, Profile.version)
        .join(ParameterSet, ParameterSet.id == InterfaceTest.parameters_id)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .where(InterfaceTest.patient_id == patient_id, InterfaceTest.status == "done")
    )
    return {
        test.run_id: RecordedTest(
            number=test.number,
            started=test.started,
            end=test.end,
            measures=test.measures or {},
            workload=test.workload or {},
            map_version=version,
            parameters_hash=parameters_hash,
        )
        for test, parameters_hash, version in db.execute(query)
    }
