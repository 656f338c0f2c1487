"""Two-minute tests in a report: figures as on the pages, sources apart, and which tests the newest is compared with."""

from dataclasses import replace

import pytest
from clinic_rows import SIMULATED, WORN
from features.reports.reported_clinic import material_of, stored_course
from stored_interface_test import store_interface_test

from app.features.reports.composition import compose
from app.features.reports.measure_reports import ENDS, MOST_ROWS
from app.features.reports.rendering import render_html, render_pdf
from app.scoring.measures import TEST_MEASURES, WORKLOAD_NAME
from app.store.tables import InterfaceTest, PatientSession

SESSIONS = 3
IN_A_SESSION = 6
WORKLOAD = ("mental", "physical", "temporal", "performance", "effort", "frustration")


@pytest.fixture(scope="module")
def tested(tmp_path_factory):
    """Yield a course with six two-minute tests in each session, the last of them stopped."""
    with stored_course(tmp_path_factory.mktemp("tested"), SESSIONS) as course:
        with course[0].transaction() as db:
            for session in db.query(PatientSession).order_by(PatientSession.number):
                for number in range(IN_A_SESSION):
                    end = "stopped" if session.number == SESSIONS and number == IN_A_SESSION - 1 else "complete"
                    level = 0.5 + 0.2 * session.number + 0.01 * (number % 2)
                    test = store_interface_test(db, session.id, end=end, throughput=level, path_efficiency=0.5)
            test.workload = dict.fromkeys(WORKLOAD, 40)
        yield course


def rows_of(report, number=0):
    return report.tests[number].table.rows


def test_a_session_shows_its_tests_and_those_that_the_newest_is_compared_with(tested):
    report = compose(material_of(*tested, 2))
    (tests,) = report.tests
    assert tests.table.head == ("Test", *(str(measure.name) for measure in TEST_MEASURES.values()), str(WORKLOAD_NAME))
    assert [row[0].split(",")[0] for row in tests.table.rows] == [
        *("1", "7", "8", "9", "10", "11", "12", "12 against 11", "12 against 1")
    ]
    first, newest, against_first = tests.table.rows[0], tests.table.rows[6], tests.table.rows[-1]
    assert first[1:] == ("10.0", "0.70 bit/s", "2.50 s", "0.25 s", "50 %", "")
    assert newest[2] == "0.91 bit/s"
    assert against_first[1:6] == ("within noise", "within noise", "within noise", "–", "–")  # three of them lead
    assert rows_of(compose(material_of(*tested, SESSIONS)))[-1][2] == "better than noise"
    assert "12 complete tests" in tests.lead
    assert "5 tests are not shown" in tests.lead


def test_a_stopped_test_says_so_and_nothing_is_compared_with_it(tested):
    rows = rows_of(compose(material_of(*tested, SESSIONS)))
    stopped = next(row for row in rows if row[0].startswith("18, "))
    assert stopped[1:] == (ENDS["stopped"], "", "", "", "", "")
    assert [row[0] for row in rows if "against" in row[0]] == ["17 against 16", "17 against 1"]


def test_a_session_whose_only_test_did_not_count_compares_nothing(tested):
    material = material_of(*tested, SESSIONS)
    (tests,) = material.tests
    kept = tuple(one for one in tests.tests if one.session < SESSIONS or one.test.end == "stopped")
    rows = rows_of(compose(replace(material, tests=(replace(tests, tests=kept),))))
    assert [row[0].split(",")[0] for row in rows] == ["18"]


def test_a_course_shows_the_first_and_the_newest_tests(tested):
    rows = rows_of(compose(material_of(*tested, None)))
    numbers = [row[0].split(",")[0] for row in rows if "against" not in row[0]]
    assert numbers == ["1", *(str(number) for number in range(18 - MOST_ROWS + 2, 19))]


def name_source(database, source):
    """Let the tests of the first session have another source."""
    with database.transaction() as db:
        for test in db.query(InterfaceTest).filter(InterfaceTest.number <= IN_A_SESSION):
            test.run.shirt, test.run.body, test.run.simulated = source.shirt, source.body, source.simulated


def test_tests_of_other_sources_have_a_table_of_their_own_and_practice_is_said(tested):
    database, _, _ = tested
    name_source(database, WORN)
    try:
        second = compose(material_of(*tested, 2))
        course = compose(material_of(*tested, None))
    finally:
        name_source(database, SIMULATED)
    assert len(second.tests) == 1  # none of the worn ones is of this session
    assert [row[0].split(",")[0] for row in rows_of(second)][-1] == "12 against 7"
    worn, simulated = course.tests
    assert worn.lead.startswith("Worn shirt, virtual chair. 6 complete tests")
    assert simulated.lead.startswith("Simulated shirt (simulated person), virtual chair: practice only. 11 ")
    assert course.practice


def test_both_renderers_show_the_tests(tested):
    report = compose(material_of(*tested, 2))
    words = render_html(report, "a4").decode()
    assert "<h2>Two-minute tests</h2>" in words
    assert "0.91 bit/s" in words
    assert len(render_pdf(report, "a4")) > len(render_pdf(replace(report, tests=()), "a4"))
    assert "Two-minute tests" not in render_html(replace(report, tests=()), "a4").decode()
