"""Interface tests of patients: begun, measured, ended, and how demanding they felt."""

from pathlib import Path
from typing import Any

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.recording.reader import read_run
from app.refusals import Conflict
from app.scoring.interface_test.interface_measures import interface_measures, replay_task
from app.store.own_rows import own_row
from app.store.tables import InterfaceTest, PatientSession, Run
from app.texts import Text
from app.world.cursor_task import CursorPlan


def add_interface_test(
    db: Session, *, run: Run, session: PatientSession, parameters_id: int, plan: dict[str, Any]
) -> InterfaceTest:
    """Add the patient's next interface test."""
    test = InterfaceTest(
        clinic_id=session.clinic_id,
        patient_id=session.patient_id,
        session_id=run.session_id,
        parameters_id=parameters_id,
        run=run,
        number=next_number(db, session.patient_id),
        started=utc_now(),
        status="running",
        end=None,
        plan=plan,
        measures=None,
        workload=None,
    )
    db.add(test)
    db.flush()
    return test


def next_number(db: Session, patient_id: int) -> int:
    """Return the number of the patient's next interface test."""
    last = db.scalar(select(func.max(InterfaceTest.number)).where(InterfaceTest.patient_id == patient_id))
    return (last or 0) + 1


def measure_interface_test(folder: Path, plan: CursorPlan) -> dict[str, Any]:
    """Return the measures of an interface test, as a document; ValueError when there is no recording."""
    columns = read_run(folder, ["t", "run_t", "u1", "u2"]).columns
    task = replay_task(plan, columns["run_t"], columns["u1"], columns["u2"])
    return interface_measures(task).model_dump(mode="json")


def finish_interface_test(db: Session, test_id: int, end: str, measures: dict[str, Any] | None) -> InterfaceTest:
    """Store how a test ended, and its measures."""
    test = db.get_one(InterfaceTest, test_id)
    test.status, test.end, test.measures = "done", end, measures
    return test


def find_interface_test(db: Session, test_id: int) -> InterfaceTest:
    """Return one of the clinic's interface tests."""
    return own_row(db, InterfaceTest, test_id, Text("tests-missing", number=test_id))


def save_workload(db: Session, test_id: int, answers: dict[str, Any] | None) -> InterfaceTest:
    """Store how demanding a test felt; None: nothing was answered."""
    test = find_interface_test(db, test_id)
    if test.status != "done":
        raise Conflict(Text("tests-still-running"))
    test.workload = answers
    return test
