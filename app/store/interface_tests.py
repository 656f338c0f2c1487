"""The interface tests of patients, which a feature makes (`app/features/interface_tests/`): the stored ones."""

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.store.tables import InterfaceTest, PatientSession


def interface_tests_of(db: Session, patient_id: int) -> list[tuple[InterfaceTest, int]]:
    """Return a patient's interface tests with the numbers of their sessions, the newest last."""
    query = (
        select(InterfaceTest, PatientSession.number)
        .join(PatientSession, PatientSession.id == InterfaceTest.session_id)
        .where(InterfaceTest.patient_id == patient_id)
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
