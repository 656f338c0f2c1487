"""A clinic with a course of six sessions, and the reports of its newest session and of the course."""

from collections.abc import Iterator

import pytest
from features.reports.reported_clinic import Course, report_of, sign_last_session, stored_course

from app.features.reports.document import Report

SESSIONS = 6


@pytest.fixture(scope="session")
def reported(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Course]:
    """Yield the database, the folder of its recordings, and the patient."""
    with stored_course(tmp_path_factory.mktemp("reported"), SESSIONS, recordings=True) as course:
        sign_last_session(course[0], "Dr. Weiß")
        yield course


@pytest.fixture(scope="session")
def session_report(reported: Course) -> Report:
    return report_of(*reported, SESSIONS)


@pytest.fixture(scope="session")
def course_report(reported: Course) -> Report:
    return report_of(*reported, None)
