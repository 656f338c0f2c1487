"""Stores a course of sessions with their records and recorded trajectories, as reports are made of."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
from clinic_rows import plan_at, rows_in
from recorded_trial import record_trial

from app.features.records.service import add_note, add_scale, write_goal
from app.features.records.sign_off import sign_off
from app.features.reports.composition import compose
from app.features.reports.document import Remark, Report
from app.features.reports.material import ReportMaterial, report_material
from app.scoring.verdict.measure_verdict import clinic_spreads, people_variances
from app.settings import Settings
from app.source import SourceGroup
from app.store.database import Database
from app.store.learning_trials import trials_of_everybody
from app.store.log_chain import ChainHead
from app.store.tables import PatientSession
from building import make_parameters

Course = tuple[Database, Path, int]  # the database, the folder of its recordings, and the patient
CODE = "P-017"
GOAL = "Drive to the window by myself."
NOTE = "Left elbow tires after four trials."
HEAD = ChainHead(rows=12, id=12, hash="ab" * 32)
TRIALS = 7  # in each session
PLAN = "apartment"


def measures(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Return measures that fall as a person learns."""
    level = (1 + 3 * np.exp(-number / 12)) * np.exp(rng.normal(0, 0.1, 3))
    return {
        "e_diff": float(level[0]),
        "dist": float(14 + level[1]),
        "time": float(40 + 20 * level[2]),
        "sparc": float(-3 - level[0] / 2),
        "collisions": int(level[1]),
        "path_length": 13.6,
        "reached": True,
    }


def store_reported_course(database: Database, runs: Path, sessions: int, recordings: bool = True) -> int:
    """Store a patient with sessions, records and, for the trials, copies of one recording; return the patient's id."""
    rng = np.random.default_rng(4)
    with rows_in(database, "Clinic at the lake") as rows:
        patient = rows.patient(CODE)
        course = [[measures(TRIALS * one + two, rng) for two in range(TRIALS)] for one in range(sessions)]
        rows.course(patient, plan_at(PLAN), course)
        for session in rows.db.query(PatientSession).filter_by(patient_id=patient.id):
            write_goal(rows.db, session.id, GOAL)
            add_note(rows.db, session.id, NOTE, "Dr. Weiß")
            add_scale(rows.db, session.id, "SCIM III", 46.0, date(2026, 11, 20))
    if recordings:
        record_trial(runs / "first", make_parameters(), seconds=6.0, plan=plan_at(PLAN))
        for number in range(sessions * TRIALS):
            shutil.copytree(runs / "first", runs / f"course-{patient.id}-{number}")
    return int(patient.id)


@contextmanager
def stored_course(folder: Path, sessions: int, recordings: bool = False) -> Iterator[Course]:
    """Yield a patient with such a course in a database of their own."""
    with closing(Database(folder / "clinic.sqlite")) as database:
        yield database, folder / "runs", store_reported_course(database, folder / "runs", sessions, recordings)


def sign_last_session(database: Database, person: str) -> None:
    """Sign off the newest session."""
    with database.transaction() as db:
        sign_off(db, db.query(PatientSession).order_by(PatientSession.id.desc()).first(), person)  # type: ignore[arg-type]


def spreads_by(database: Database, patient_id: int) -> Callable[[str, str, SourceGroup], Any]:
    """Return what gives the clinic's median spreads."""

    def spreads_of(floorplan: str, path: str, group: SourceGroup) -> Any:
        with database.transaction() as db:
            return clinic_spreads(people_variances(trials_of_everybody(db, floorplan, path, group)), patient_id)

    return spreads_of


def material_of(database: Database, runs: Path, patient_id: int, session: int | None) -> ReportMaterial:
    """Return the material of a report, with a head of the log."""
    made = report_material(database, patient_id, session, Settings(state=runs.parent), spreads_by(database, patient_id))
    return replace(made, head=HEAD)


def report_of(database: Database, runs: Path, patient_id: int, session: int | None) -> Report:
    """Return the document of a report."""
    return compose(material_of(database, runs, patient_id, session))


def with_words(report: Report, words: str) -> Report:
    """Return a report in which people wrote these words wherever they can."""
    remark = Remark(words, words)
    task = replace(report.tasks[0], title=words)
    named = replace(report, code=words, clinic=words, signed=words, tasks=(task, *report.tasks[1:]))
    return replace(named, goals=(remark,), other_goals=(remark,), notes=(remark,), comments=(remark,))
