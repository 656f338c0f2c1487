"""The report of two-minute tests of one kind of source: a table with a row for each, and verdicts on the newest."""

from typing import Final

from app.features.reports.document import InterfaceTestReport, ReportTable
from app.features.reports.material import InterfaceTestMaterial, ReportedTest
from app.number_format import amount
from app.scoring.interface_test.interface_course import counted_tests
from app.scoring.interface_test.interface_verdicts import InterfaceVerdicts, interface_verdicts
from app.scoring.measures import TEST_MEASURES, VERDICT_WORDS_OF_TESTS, WORKLOAD_NAME

MOST_ROWS: Final = 12  # of a course: the first test and the newest ones
ENDS: Final = {
    "by hand": "ended early: does not count",
    "stopped": "stopped: does not count",
    "fault": "interrupted: does not count",
    "complete": "its recording cannot be read",
}


def interface_test_report(
    material: InterfaceTestMaterial, session: int | None, *, name_source: bool
) -> InterfaceTestReport:
    """Return the two-minute tests of one session (its number) or of the course (None).

    Those that the newest test is compared with stand among them, whichever session they are of.
    `name_source` says whether the report has several sources, so that each table must name its own.
    """
    counted = counted_tests([one.test for one in material.tests])
    own = {one.test.number for one in material.tests if session in (None, one.session)}
    compared = [one for one in interface_verdicts(counted) if one.later in own]
    shown = _shown(material.tests, own, compared, course=session is None)
    source = f"{material.source}. " if name_source else ""
    left_out = len(material.tests) - len(shown)
    others = f" {amount(left_out, 'test is', 'tests are')} not shown." if left_out else ""
    until = "" if session is None else f" up to session {session}"
    return InterfaceTestReport(
        lead=f"{source}{amount(len(counted), 'complete test')}{until}.{others}",
        table=ReportTable(
            ("Test", *(measure.name for measure in TEST_MEASURES.values()), WORKLOAD_NAME),
            tuple(_row(one) for one in shown) + tuple(_verdicts(one) for one in compared),
        ),
    )


def _shown(
    tests: tuple[ReportedTest, ...], own: set[int], compared: list[InterfaceVerdicts], *, course: bool
) -> list[ReportedTest]:
    newest = {one.test.number for one in tests[-MOST_ROWS + 1 :]} if course else own
    numbers = newest | {one.earlier for one in compared}
    return [one for one in tests if one.test.number in numbers]


def _row(reported: ReportedTest) -> tuple[str, ...]:
    number, end, _, measures = reported.test
    head = f"{number}, session {reported.session}"
    if end != "complete" or measures is None:
        return (head, ENDS[end or "fault"], *[""] * len(TEST_MEASURES))
    workload = "" if reported.workload is None else f"{reported.workload:.0f}"
    levels = ("" if (value := measures.get(name)) is None else one.level(value) for name, one in TEST_MEASURES.items())
    return (head, *levels, workload)


def _verdicts(found: InterfaceVerdicts) -> tuple[str, ...]:
    words = (found.verdicts[name].word if name in found.verdicts else None for name in TEST_MEASURES)
    return (
        f"{found.later} against {found.earlier}",
        *("" if word is None else VERDICT_WORDS_OF_TESTS[word] for word in words),
        "",
    )
