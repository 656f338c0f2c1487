"""The two-minute tests of two sessions side by side: the newest complete one of each, with verdicts on the change."""

from typing import Any, NamedTuple

from app.api.interface_test_view import InterfaceTestView
from app.computing_process import ComputingProcess
from app.quantities import Document
from app.scoring.interface_test.interface_course import COMPLETE, StoredTest, counted_tests
from app.scoring.interface_test.interface_verdicts import verdicts_between
from app.scoring.verdict.measure_verdict import Verdict
from app.source import SourceGroup
from app.store.database import Transaction
from app.store.interface_tests import interface_tests_of
from app.store.tables import InterfaceTest, PatientSession


class ComparedTests(Document):
    """Tests of one kind of source in two sessions; no verdicts when one has no complete test, or they asked others."""

    source: SourceGroup
    complete: tuple[int, int]  # tests in the earlier and in the later session
    earlier: InterfaceTestView | None  # the newest complete test of the session
    later: InterfaceTestView | None
    verdicts: dict[str, Verdict]


class PairOfTests(NamedTuple):
    """What is compared, before the verdicts are computed."""

    shown: ComparedTests
    counted: list[dict[str, Any]]  # all tests up to the later one that asked what that one asked


def pairs_of_tests(db: Transaction, earlier: PatientSession, later: PatientSession) -> list[PairOfTests]:
    """Return the two-minute tests of two sessions by their source; a source that neither session has is left out."""
    of: dict[SourceGroup, list[tuple[InterfaceTest, int]]] = {}
    for test, session in interface_tests_of(db, later.clinic_id, later.patient_id):
        if session <= later.number and test.status == "done":
            of.setdefault(test.source.group, []).append((test, session))
    found = []
    for group, tests in of.items():
        own = [[test for test, session in tests if session == one.number] for one in (earlier, later)]
        if not any(own):
            continue
        complete = [[one for one in each if one.end == COMPLETE and one.measures is not None] for each in own]
        views = [
            InterfaceTestView.of_row(each[-1], session.number) if each else None
            for each, session in zip(complete, (earlier, later), strict=True)
        ]
        counts = (len(complete[0]), len(complete[1]))
        shown = ComparedTests(source=group, complete=counts, earlier=views[0], later=views[1], verdicts={})
        counted = counted_tests([StoredTest(one.number, one.end, one.plan, one.measures) for one, _ in tests])
        found.append(PairOfTests(shown, counted))
    return found


def verdicts_on(pair: PairOfTests, computing: ComputingProcess) -> ComparedTests:
    """Return a comparison with its verdicts."""
    shown, counted = pair
    if shown.earlier is None or shown.later is None:
        return shown
    found = computing.ask(verdicts_between, counted, shown.earlier.number, shown.later.number)
    return shown if found is None else shown.model_copy(update={"verdicts": found.verdicts})
