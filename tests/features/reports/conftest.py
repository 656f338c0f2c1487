"""A clinic with a course of six sessions, and the reports of its newest session and of the course."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from features.reports.reported_clinic import report_of, sign_last_session, store_reported_course

from app.features.reports.document import Report
from app.store.database import Database

SESSIONS = 6


@pytest.fixture(scope="session")
def reported(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Database, Path, int]]:
    """Yield the database, the folder of its recordings, and the patient."""
    folder = tmp_path_factory.mktemp("reported")
    database = Database(folder / "clinic.sqlite")
    patient = store_reported_course(database, folder / "runs", SESSIONS)
    sign_last_session(database, "Dr. Weiß")
    yield database, folder / "runs", patient
    database.close()


@pytest.fixture(scope="session")
def session_report(reported: tuple[Database, Path, int]) -> Report:
    return report_of(*reported, SESSIONS)


@pytest.fixture(scope="session")
def course_report(reported: tuple[Database, Path, int]) -> Report:
    return report_of(*reported, None)
