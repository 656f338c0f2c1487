"""What the store has for a report: plain values that can be sent to the process that renders it."""

from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import Any

from app.clock import utc_now
from app.features.records.service import SessionRecord, session_record
from app.features.registration import TrialRemark, features
from app.features.reports.drive_report import ReportedDrive, reported_drives
from app.refusals import NotFound
from app.scoring.interface_test.interface_course import StoredTest
from app.scoring.interface_test.workload import Workload
from app.scoring.verdict.spread import Spread, SpreadsOf
from app.settings import Settings
from app.source import Source, SourceGroup
from app.store.database import Database, Transaction
from app.store.interface_tests import interface_tests_of
from app.store.learning_trials import CountedTrial, counted_trials
from app.store.log_chain import ChainHead
from app.store.map_versions import source_of_map
from app.store.origins import Origin, origins_of
from app.store.patients import find_patient, sessions_of
from app.store.session_contents import trials_of_session
from app.store.tables import Clinic, InterfaceTest, ParameterSet, Patient, PatientSession, Profile, Trial
from app.texts import Text
from app.world.path_titles import path_title

MOST_TASKS = 12  # in one report, those with the most trials

Rows = list[dict[str, Any]]


@dataclass(frozen=True, slots=True)
class SessionMaterial:
    """One session with its record; its trials are those of any task."""

    id: int
    number: int
    started: datetime
    ended: datetime | None
    opened_by: str | None
    record: SessionRecord
    counted: int  # trials
    # floor plan's title, trial's number, reason ("": not measured)
    left_out: tuple[tuple[Text | str, int, Text | str], ...]
    origin: Origin | None = None  # None: held in this clinic


@dataclass(frozen=True, slots=True)
class TaskMaterial:
    """The counted trials of one task and source, up to the end of what is reported."""

    floorplan: str
    path_name: str
    title: Text
    path: tuple[tuple[float, float], ...]
    group: SourceGroup
    source: Source
    rows: Rows  # as `CountedTrial.row` returns them
    folders: tuple[Path, ...]  # of the recordings, one for each row
    clinic: dict[str, Spread]  # the median spreads of other people


@dataclass(frozen=True, slots=True)
class ReportedTest:
    """One two-minute test that has ended."""

    session: int  # number
    test: StoredTest
    workload: float | None  # mean of the six answers, 0 to 100


@dataclass(frozen=True, slots=True)
class InterfaceTestMaterial:
    """The two-minute tests of one kind of source, up to the end of what is reported; the newest last."""

    group: SourceGroup
    source: Source
    tests: tuple[ReportedTest, ...]


@dataclass(frozen=True, slots=True)
class ParameterMaterial:
    """The newest parameter set that a reported trial or drive used, and how many others there were."""

    title: str
    hash: str
    settings: dict[str, Any]
    profile: dict[str, Any]
    version: int
    origin: str
    parent: int | None
    others: int  # sets
    calibrated: SourceGroup  # of the recordings that it was calibrated with


@dataclass(frozen=True, slots=True)
class ReportMaterial:
    """Everything of the store that a report is made from."""

    patient_id: int
    code: str
    clinic: str
    made: datetime
    session: int | None  # number of the session; None: the course of all sessions
    sessions: tuple[SessionMaterial, ...]  # that are reported, the oldest first
    tasks: tuple[TaskMaterial, ...]
    tests: tuple[InterfaceTestMaterial, ...]
    drives: tuple[ReportedDrive, ...]  # of real chairs
    comments: tuple[TrialRemark, ...]  # on trials of the patient, also of sessions that are not reported
    parameters: ParameterMaterial | None  # None: nothing was driven
    head: ChainHead | None = None  # of the log, when the report was written into it
    for_patient: bool = False  # a copy for the patient, made without the consent to sharing outside

    @property
    def session_id(self) -> int | None:
        """Return the row of the session; None for a course."""
        return None if self.session is None else self.sessions[0].id


def report_material(
    database: Database, patient_id: int, session: int | None, settings: Settings, spreads_of: SpreadsOf
) -> ReportMaterial:
    """Return what a report of one session, or of a patient's whole course (None), is made from.

    `session` is its number: 1, 2, 3 ... per patient; `settings` name the folders of all recordings and of
    the clinic's own floor plans; `spreads_of` returns the clinic's median spreads in a task.

    Raises
    ------
    NotFound
        When the clinic has no such patient, or the patient no such session.
    """
    with database.reading() as db:
        material = _own_material(db, find_patient(db, patient_id), session, settings)
    tasks = [replace(task, clinic=spreads_of(task.floorplan, task.path_name, task.group)) for task in material.tasks]
    return replace(material, tasks=tuple(tasks))


def _own_material(db: Transaction, patient: Patient, session: int | None, settings: Settings) -> ReportMaterial:
    every = [row for row in reversed(sessions_of(db, patient.id)) if session is None or row.number <= session]
    reported = [row for row in every if session is None or row.number == session]
    if not reported:
        raise NotFound(Text("report-no-session-yet") if session is None else Text("report-no-session", session=session))
    numbers = {row.id: row.number for row in reported}
    driven = {row.id: trials_of_session(db, row.id) for row in reported}
    trials = [trial for task_trials in driven.values() for trial in task_trials]
    drives = reported_drives(db, patient.id, numbers)
    last, origins = every[-1].number, origins_of(db, patient.id)
    return ReportMaterial(
        patient_id=patient.id,
        code=patient.code,
        clinic=db.get_one(Clinic, patient.clinic_id).name,
        made=utc_now(),
        session=session,
        sessions=tuple(_session(db, row, driven[row.id], origins.get(row.id)) for row in reported),
        tasks=tuple(_tasks(db, patient, trials, last, settings)),
        tests=tuple(_tests(db, patient, set(numbers.values()), last)),
        drives=tuple(drives),
        comments=tuple(remark for feature in features().values() for remark in feature.remarks(db, patient.id)),
        parameters=_parameters(db, [*trials, *drives]),
    )


def _session(db: Transaction, row: PatientSession, driven: list[Trial], origin: Origin | None) -> SessionMaterial:
    done = [trial for trial in driven if trial.status == "done"]
    left_out = [(trial.place_title, trial.number, trial.discard_reason or "") for trial in done if not _counts(trial)]
    return SessionMaterial(
        id=row.id,
        number=row.number,
        started=row.started,
        ended=row.ended,
        opened_by=row.opened_by,
        record=session_record(db, row.id),
        counted=len(done) - len(left_out),
        left_out=tuple(left_out),
        origin=origin,
    )


def _counts(trial: Trial) -> bool:
    return trial.kept and trial.measures is not None


def _tasks(db: Transaction, patient: Patient, trials: list[Trial], last: int, settings: Settings) -> list[TaskMaterial]:
    """Return the tasks and sources that were driven in what is reported, those with the most trials first."""
    driven: dict[tuple[str, str, SourceGroup], int] = {}
    for trial in trials:
        if trial.status == "done" and _counts(trial):
            key = trial.floorplan, trial.path, trial.run.source.group
            driven[key] = driven.get(key, 0) + 1
    most = sorted(driven, key=lambda key: -driven[key])[:MOST_TASKS]
    return [_task(db, patient, key, last, settings) for key in most]


def _task(
    db: Transaction, patient: Patient, key: tuple[str, str, SourceGroup], last: int, settings: Settings
) -> TaskMaterial:
    floorplan, path, group = key
    counted: list[CountedTrial] = [
        trial
        for trial in counted_trials(db, patient.id, floorplan, path)
        if trial.group == group and trial.session <= last
    ]
    newest = counted[-1].trial
    return TaskMaterial(
        floorplan=floorplan,
        path_name=path,
        title=Text("report-task-title", plan=newest.place_title, path=path_title(settings.floorplans, floorplan, path)),
        path=tuple((x, y) for x, y in newest.path_points),
        group=group,
        source=newest.run.source,
        rows=[trial.row() for trial in counted],
        folders=tuple(settings.runs / trial.trial.run.folder for trial in counted),
        clinic={},
    )


def _tests(db: Transaction, patient: Patient, reported: set[int], last: int) -> list[InterfaceTestMaterial]:
    """Return the two-minute tests by kind of source, as far as a reported session has one of it."""
    tests: dict[SourceGroup, list[tuple[InterfaceTest, int]]] = {}
    for test, session in interface_tests_of(db, patient.id):
        if test.status == "done" and session <= last:
            tests.setdefault(test.source.group, []).append((test, session))
    return [
        InterfaceTestMaterial(
            group=group,
            source=group_tests[-1][0].source,
            tests=tuple(_reported_test(test, session) for test, session in group_tests),
        )
        for group, group_tests in tests.items()
        if any(session in reported for _, session in group_tests)
    ]


def _reported_test(test: InterfaceTest, session: int) -> ReportedTest:
    return ReportedTest(
        session=session,
        test=StoredTest(test.number, test.end, test.plan, test.measures),
        workload=None if test.workload is None else Workload.model_validate(test.workload).raw_tlx,
    )


def _parameters(db: Transaction, driven: list[Trial | ReportedDrive]) -> ParameterMaterial | None:
    if not driven:
        return None
    newest = max(driven, key=lambda used: used.started)
    row = db.get_one(ParameterSet, newest.parameters_id)
    profile = db.get_one(Profile, row.profile_id)
    return ParameterMaterial(
        title=row.title,
        hash=row.hash,
        settings=row.settings,
        profile=profile.document,
        version=profile.version,
        origin=profile.origin,
        parent=profile.parent,
        others=len({used.parameters_id for used in driven}) - 1,
        calibrated=source_of_map(db, profile),
    )
