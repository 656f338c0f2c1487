"""Interface tests of patients: begun, ended with their measures, and how demanding they felt."""

from typing import Any

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.store.own_rows import own_row
from app.store.tables import InterfaceTest, PatientSession, Run


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


def finish_interface_test(db: Session, test_id: int, end: str, measures: dict[str, Any] | None) -> InterfaceTest:
    """Store how a test ended, and its measures."""
    test = db.get_one(InterfaceTest, test_id)
    test.status, test.end, test.measures = "done", end, measures
    return test


def find_interface_test(db: Session, clinic_id: int, test_id: int) -> InterfaceTest:
    """Return one of the clinic's interface tests."""
    return own_row(
        db, InterfaceTest, clinic_id, test_id, f"There is no two-minute test {test_id}: choose one of the list."
    )


def save_workload(db: Session, clinic_id: int, test_id: int, answers: dict[str, Any] | None) -> InterfaceTest:
    """Store how demanding a test felt; None: nothing was answered."""
    test = find_interface_test(db, clinic_id, test_id)
    if test.status != "done":
        raise Conflict("The two-minute test is still running: end it first, then ask how demanding it was.")
    test.workload = answers
    return test


def interface_tests_of(db: Session, clinic_id: int, patient_id: int) -> list[tuple[InterfaceTest, int]]:
    """Return a patient's interface tests with the numbers of their sessions, the newest last."""
    query = (
        select(InterfaceTest, PatientSession.number)
        .join(PatientSession, PatientSession.id == InterfaceTest.session_id)
        .where(InterfaceTest.clinic_id == clinic_id, InterfaceTest.patient_id == patient_id)
        .order_by(InterfaceTest.number)
    )
    return [(test, number) for test, number in db.execute(query)]


def interface_tests_of_session(db: Session, session_id: int) -> list[InterfaceTest]:
    """Return the interface tests of a session in the order done."""
    return list(db.scalars(select(InterfaceTest).where(InterfaceTest.session_id == session_id).order_by("id")))


def close_interrupted_tests(db: Session) -> None:
    """End the tests that an ended web process left running; their recordings stay."""
    for test in db.scalars(select(InterfaceTest).where(InterfaceTest.status == "running")):
        test.status, test.end = "done", "fault"
