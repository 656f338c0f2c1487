"""The two-minute test before driving: targets on a cross, reached with a cursor, while no chair moves."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, Depends, Query

from app.api.deps import Anyone, ComputingPart, Db, LivePart, RowId, SessionFlowPart
from app.api.interface_test_view import InterfaceTestView
from app.api.live.screen_socket import ScreenWord
from app.api.page_session import ClinicianInSession
from app.api.parts import part
from app.features.interface_tests.flow import InterfaceTestFlow
from app.features.interface_tests.service import find_interface_test, save_workload
from app.news import News
from app.quantities import Document
from app.refusals import Conflict
from app.scoring.interface_test.interface_course import InterfaceCourse, StoredTest, counted_tests, interface_course
from app.scoring.interface_test.workload import Workload
from app.scoring.verdict.measure_verdict import FEWEST
from app.session.run_watch import Starter
from app.source import SourceGroup
from app.store.database import Database, Transaction
from app.store.interface_tests import interface_tests_of
from app.store.log import log_viewing, write_log
from app.store.patients import find_patient
from app.store.tables import InterfaceTest, PatientSession

router = APIRouter(prefix="/interface-tests", tags=["interface tests"])


Tests = Annotated[InterfaceTestFlow, Depends(part(InterfaceTestFlow))]


class NewTest(Document):
    """The screen from which the test is started."""

    screen: ScreenWord


class InterfaceTestsView(Document):
    """A patient's interface tests, the newest last, and what those of one kind of source say together."""

    tests: list[InterfaceTestView]
    source: SourceGroup | None  # of the course; None: there is no test
    course: InterfaceCourse


@router.post("", status_code=201)
async def start_interface_test(
    body: NewTest, person: ClinicianInSession, database: Db, session_flow: SessionFlowPart, tests: Tests
) -> InterfaceTestView:
    """Start the two-minute test; the chair is disarmed and stays where it is.

    409 with a stop in force, while anything is recorded, or without controls that fit the shirt.
    """
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        obstacle = await session_flow.load_parameters()
        if obstacle is not None:
            raise Conflict(obstacle)
        test_id = await tests.start(session, Starter(person.person_id, person.name, body.screen))
    return await asyncio.to_thread(_one, database, test_id)


@router.post("/current/end")
async def end_interface_test(_person: ClinicianInSession, database: Db, tests: Tests) -> InterfaceTestView:
    """End the test by hand, so that it does not count; for every clinician, because nothing moves."""
    return await asyncio.to_thread(_one, database, await tests.end())


@router.get("")
def list_interface_tests(
    patient: Annotated[int, Query(ge=1, le=2**31)],
    person: Anyone,
    database: Db,
    computing: ComputingPart,
    source: SourceGroup | None = None,
) -> InterfaceTestsView:
    """List a patient's interface tests; the course is of one kind of source, that of the newest when none is named.

    The course is of the complete ones with the plan of the newest.
    """
    with database.transaction(closing=True) as db:
        find_patient(db, patient)
        log_viewing(db, person.name, patient)
        rows = interface_tests_of(db, patient)
        tests = [InterfaceTestView.of_row(test, session) for test, session in rows]
    group = source or (rows[-1][0].source.group if rows else None)
    counted = counted_tests(
        [StoredTest(test.number, test.end, test.plan, test.measures) for test, _ in rows if test.source.group == group]
    )
    # Few tests need no curve and no large library: a first page does not wait for the computing process.
    course = interface_course(counted) if len(counted) < FEWEST else computing.ask(interface_course, counted)
    return InterfaceTestsView(tests=tests, source=group, course=course)


@router.put("/{test_id}/workload")
async def put_workload(
    test_id: RowId, body: Workload, person: ClinicianInSession, database: Db, live: LivePart
) -> InterfaceTestView:
    """Store how demanding the test felt; without any answer, what was stored is removed.

    `raw_tlx` is the mean of six answers, null when one is missing.
    """

    def _write() -> tuple[InterfaceTestView, News]:
        with database.transaction() as db:
            test = save_workload(db, test_id, body.model_dump() if body.answers else None)
            write_log(db, person.name, "workload answered", test=test_id, answers=len(body.answers))
            return _view(db, test), News(what="test", patient=test.patient_id, session=test.session_id)

    saved, news = await asyncio.to_thread(_write)
    live.notify(news)
    return saved


def _one(database: Database, test_id: int) -> InterfaceTestView:
    with database.reading() as db:
        return _view(db, find_interface_test(db, test_id))


def _view(db: Transaction, test: InterfaceTest) -> InterfaceTestView:
    return InterfaceTestView.of_row(test, db.get_one(PatientSession, test.session_id).number)
