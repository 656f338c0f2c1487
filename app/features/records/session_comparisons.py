"""Two sessions of a patient side by side: what was driven, measures and tests with their verdicts, what changed."""

from collections import Counter
from typing import Annotated, Any, NamedTuple

from fastapi import APIRouter, Query

from app.api.deps import Anyone, ComputingPart, Db, PlacesPart, RowId, SpreadPart
from app.api.interface_test_view import InterfaceTestView
from app.computing_process import ComputingProcess
from app.features.records.session_views import SessionRecordView, UsedSetView, record_view
from app.quantities import Document
from app.refusals import Conflict
from app.scoring.interface_test.interface_course import COMPLETE, StoredTest, counted_tests
from app.scoring.interface_test.interface_verdicts import verdicts_between
from app.scoring.verdict.measure_verdict import Verdict
from app.scoring.verdict.session_comparison import MeasureOfSessions, compare_tasks
from app.session.clinic_spread import Task
from app.session.parameter_differences import Difference, differences
from app.source import SourceGroup
from app.store.database import Transaction
from app.store.interface_tests import interface_tests_of
from app.store.learning_trials import counted_trials
from app.store.log import write_log
from app.store.parameters import as_document
from app.store.patients import find_session
from app.store.session_contents import UsedSet, set_of, sets_of_session, trials_of_session
from app.store.tables import InterfaceTest, PatientSession, Trial
from app.texts import Text
from app.world.path_titles import path_title

router = APIRouter(tags=["records"])

OTHER_PATIENT = Text("records-other-patient")
SAME_SESSION = Text("records-same-session")


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
    for test, session in interface_tests_of(db, later.patient_id):
        if session <= later.number and test.status == "done":
            of.setdefault(test.source.group, []).append((test, session))
    pairs = []
    for group, tests in of.items():
        tests_of_sides = [[test for test, session in tests if session == side.number] for side in (earlier, later)]
        if not any(tests_of_sides):
            continue
        complete = [
            [test for test in each if test.end == COMPLETE and test.measures is not None] for each in tests_of_sides
        ]
        views = [
            InterfaceTestView.of_row(each[-1], session.number) if each else None
            for each, session in zip(complete, (earlier, later), strict=True)
        ]
        counts = (len(complete[0]), len(complete[1]))
        shown = ComparedTests(source=group, complete=counts, earlier=views[0], later=views[1], verdicts={})
        counted = counted_tests([StoredTest(test.number, test.end, test.plan, test.measures) for test, _ in tests])
        pairs.append(PairOfTests(shown, counted))
    return pairs


def verdicts_on(pair: PairOfTests, computing: ComputingProcess) -> ComparedTests:
    """Return a comparison with its verdicts."""
    shown, counted = pair
    if shown.earlier is None or shown.later is None:
        return shown
    verdicts = computing.ask(verdicts_between, counted, shown.earlier.number, shown.later.number)
    return shown if verdicts is None else shown.model_copy(update={"verdicts": verdicts.verdicts})


class TaskComparison(Document):
    """One task in two sessions: trials of one source along one path."""

    floorplan: str
    floorplan_title: Text
    path: str
    path_title: Text  # its name where the floor plan has no such path any more
    source: SourceGroup
    trials: tuple[int, int]  # driven in the earlier and in the later session
    counted: tuple[int, int]  # of these, kept and measured
    measures: dict[str, MeasureOfSessions]


class SessionComparison(Document):
    """Two sessions of one patient, the earlier first."""

    earlier: SessionRecordView
    later: SessionRecordView
    tasks: list[TaskComparison]
    tests: list[ComparedTests]  # two-minute tests, by their source
    sets: tuple[UsedSetView | None, UsedSetView | None]  # that each session drove with last; None: nothing was driven
    changes: list[Difference] | None  # from the earlier set to the later one; None: one of them cannot be read


@router.get("/sessions/{session_id}/comparison")
def compare_two(
    session_id: RowId,
    other: Annotated[int, Query(ge=1, le=2**31)],
    person: Anyone,
    database: Db,
    computing: ComputingPart,
    spread: SpreadPart,
    places: PlacesPart,
) -> SessionComparison:
    """Compare two sessions of one patient; 409 for sessions of two patients, or one session twice.

    Differences of the last parameter sets are null when one session has none.
    """
    with database.transaction(closing=True) as db:
        pair = [find_session(db, row_id) for row_id in (session_id, other)]
        if pair[0].id == pair[1].id:
            raise Conflict(SAME_SESSION)
        if pair[0].patient_id != pair[1].patient_id:
            raise Conflict(OTHER_PATIENT)
        earlier, later = sorted(pair, key=lambda session: session.number)
        write_log(db, person.name, "sessions compared", patient=earlier.patient_id, sessions=[earlier.id, later.id])
        trials = [trials_of_session(db, session.id) for session in (earlier, later)]
        driven = [Counter(map(_task, of_session)) for of_session in trials]
        titles = {_task(trial): trial.place_title for of_session in trials for trial in of_session}
        rows = {}
        for task in titles:
            counted = counted_trials(db, earlier.patient_id, task.floorplan, task.path)
            rows[task] = [trial.row() for trial in counted if trial.group == task.group]
        pairs = pairs_of_tests(db, earlier, later)
        views = record_view(db, earlier), record_view(db, later)
        sets = [_last_set(db, session) for session in (earlier, later)]
        changes = _changes(db, sets[0], sets[1])
    spreads = [spread.of_others(task, earlier.patient_id) for task in rows]
    given = list(zip(rows.values(), spreads, strict=True))
    measures = computing.ask(compare_tasks, given, earlier.number, later.number) if given else []
    compared = [
        TaskComparison(
            floorplan=task.floorplan,
            floorplan_title=titles[task],
            path=task.path,
            path_title=path_title(places.folder, task.floorplan, task.path),
            source=task.group,
            trials=(driven[0][task], driven[1][task]),
            counted=(_of_session(task_rows, earlier), _of_session(task_rows, later)),
            measures=of_task,
        )
        for (task, task_rows), of_task in zip(rows.items(), measures, strict=True)
    ]
    shown = [None if parameter_set is None else UsedSetView.of(parameter_set) for parameter_set in sets]
    return SessionComparison(
        earlier=views[0],
        later=views[1],
        tasks=compared,
        tests=[verdicts_on(pair, computing) for pair in pairs],
        sets=(shown[0], shown[1]),
        changes=changes,
    )


def _last_set(db: Transaction, session: PatientSession) -> UsedSet | None:
    used = sets_of_session(db, session.id)
    return used[-1] if used else None


def _task(trial: Trial) -> Task:
    return Task(trial.floorplan, trial.path, trial.source.group)


def _of_session(rows: list[dict[str, object]], session: PatientSession) -> int:
    return sum(row["session"] == session.number for row in rows)


def _changes(db: Transaction, earlier: UsedSet | None, later: UsedSet | None) -> list[Difference] | None:
    if earlier is None or later is None:
        return None
    try:
        return differences(as_document(*set_of(db, later)), as_document(*set_of(db, earlier)))
    except Conflict:  # saved by a program whose sets this one cannot read
        return None
