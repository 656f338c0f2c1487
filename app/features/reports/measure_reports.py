"""The reports of what was measured: of one task (verdicts, trajectories, learning curve), and of two-minute tests."""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

from app.features.reports.document import Drawing, InterfaceTestReport, MeasureRow, ReportTable, TaskReport, Tone
from app.features.reports.drawings import CurvePoint, Trajectory, band_drawing, curve_drawing, trajectory_drawing
from app.features.reports.material import InterfaceTestMaterial, ReportedTest, Rows, TaskMaterial
from app.recording.recorded_trajectory import read_trajectory, thinned
from app.scoring.interface_test.interface_course import counted_tests
from app.scoring.interface_test.interface_verdicts import InterfaceVerdicts, interface_verdicts
from app.scoring.interruptions import interruption_text
from app.scoring.learning import learning_curves
from app.scoring.measures import (
    REACHED,
    REACHED_NAME,
    TEST_MEASURES,
    TRIAL_MEASURES,
    VERDICT_WORDS,
    VERDICT_WORDS_OF_TESTS,
    WORKLOAD_NAME,
    Word,
)
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.measure_scales import from_scale, value_of
from app.scoring.verdict.measure_verdict import Verdict, series_of
from app.scoring.verdict.verdicts import SessionVerdicts, task_verdicts
from app.source import source_description
from app.texts import Figure, Text, value_text

MOST_NAMED = 6  # interrupted trials
MOST_OWN, MOST_PAST = 10, 30  # trajectories of the newest session and of earlier ones: more could not be told apart
TONES: dict[Word, Tone] = {"better": "good", "worse": "bad", "within": "", "too few": "", "number": ""}
NOTHING_BEFORE: Final = Text("report-nothing-before")
MOST_ROWS: Final = 12  # two-minute tests of a course: the first test and the newest ones
ENDS: Final = {
    "by hand": Text("report-test-ended"),
    "stopped": Text("report-test-stopped"),
    "fault": Text("report-test-interrupted"),
    "complete": Text("report-test-unreadable"),
}


def task_report(task: TaskMaterial, session: int | None, *, name_source: bool) -> TaskReport:
    """Return the report of a task, of one session (its number) or of the course (None).

    `name_source` says whether the tasks of the report have several sources, so that each must name its own.

    Recordings are read for the trajectories; one that cannot be read is left out, and counted in the description.
    """
    rows = task.rows
    newest = max(row["session"] for row in rows)
    names = leading_of_task(rows)
    main = names[0] if names else "time"
    verdicts = task_verdicts(rows, task.clinic, [main])
    compared = _comparison(verdicts.sessions, newest, course=session is None)
    trajectories, description = _trajectories(task, session, compared)
    curve = learning_curves(rows, [main], task.clinic).get(main)
    said = () if curve is None else (curve["text"], curve["sessions"])
    source = [f"{source_description(task.source)}."] if name_source else []
    return TaskReport(
        title=str(task.title),
        lead=" ".join([*source, _trials_text(rows, session), _compared_text(compared)]),
        before="" if compared is None else str(Text("report-of-session", session=compared.earlier)),
        measures=tuple(_measure(name, rows, newest, compared) for name in names) + _reaching(rows, newest, compared),
        trajectories=trajectories,
        trajectories_description=description,
        curve=None if curve is None else _curve(main, rows, newest, curve["fit"]),
        curve_description=str(Text("report-curve-words", count=len(rows), session=newest)),
        curve_title=str(Text("report-curve-title", measure=TRIAL_MEASURES[main].name)),
        sentences=tuple(str(sentence) for sentence in (*verdicts.deterioration.values(), *said) if sentence),
        statistics=() if curve is None else tuple(map(str, curve["details"])),
    )


def _comparison(sessions: Sequence[SessionVerdicts], newest: int, *, course: bool) -> SessionVerdicts | None:
    """Return the verdicts on the reported session against the one before; of a course, against the first."""
    comparisons = [pair for pair in sessions if pair.later == newest]
    return None if not comparisons else comparisons[-1 if course else 0]


def _measure(name: str, rows: Rows, newest: int, compared: SessionVerdicts | None) -> MeasureRow:
    verdict: Verdict | None = None if compared is None else compared.verdicts.get(name)
    measure_name = str(TRIAL_MEASURES[name].name)
    if verdict is None:
        level = with_unit(name, _level(name, rows, newest))
        return MeasureRow(measure_name, level, "", "", str(NOTHING_BEFORE), "", None)
    tone = TONES[verdict.word]
    noise = noise_text(name, verdict)
    now, before = with_unit(name, verdict.later), with_unit(name, verdict.earlier)
    description = Text("report-band", measure=measure_name, before=before, now=now, noise=noise)
    drawing = band_drawing(verdict, tone, str(description))
    return MeasureRow(measure_name, now, before, noise, str(VERDICT_WORDS[verdict.word]), tone, drawing)


def _reaching(rows: Rows, newest: int, compared: SessionVerdicts | None) -> tuple[MeasureRow, ...]:
    """Return the row of how often the goal was reached."""
    verdict: Verdict | None = None if compared is None else compared.verdicts.get(REACHED)
    name = str(REACHED_NAME)
    if verdict is None:
        reached = [bool(row.get("reached", True)) for row in rows if row["session"] == newest]
        return (MeasureRow(name, share_text(sum(reached) / len(reached)), "", "", str(NOTHING_BEFORE), "", None),)
    now, before = share_text(verdict.later), share_text(verdict.earlier)
    return (MeasureRow(name, now, before, "", str(VERDICT_WORDS[verdict.word]), TONES[verdict.word], None),)


def _level(name: str, rows: Rows, session: int) -> float | None:
    """Return the mean of a session's compared trials on the measure's scale; of all of its trials without such."""
    session_rows = [row for row in rows if row["session"] == session]
    for chosen in (session_rows, [{**row, "familiarisation": False} for row in session_rows]):
        series, _ = series_of(chosen, name)
        if len(series.value):
            return from_scale(name, float(series.value.mean()))
    return None


def _trials_text(rows: Rows, session: int | None) -> str:
    session_rows = [row for row in rows if session is None or row["session"] == session]
    reached = sum(bool(row.get("reached", True)) for row in session_rows)
    used = sum(row["familiarisation"] for row in session_rows)
    counted = Text("report-task-trials", count=len(session_rows), reached=reached)
    if used:
        counted = Text("report-task-trials-used", count=len(session_rows), reached=reached, used=used)
    interrupted = [
        str(Text("report-interrupted-trial", number=row["number"], interruption=interruption))
        for row in session_rows
        if (interruption := interruption_text(row))
    ]
    if not interrupted:
        return str(counted)
    named, more = ", ".join(interrupted[:MOST_NAMED]), len(interrupted) - MOST_NAMED
    if more <= 0:
        return f"{counted} {Text('report-interrupted', trials=named)}"
    return f"{counted} {Text('report-interrupted-more', trials=named, more=more)}"


def _compared_text(compared: SessionVerdicts | None) -> str:
    if compared is None:
        return str(Text("report-compared-none"))
    first, second = compared.trials
    return str(Text("report-compared", later=compared.later, second=second, earlier=compared.earlier, first=first))


def _trajectories(
    task: TaskMaterial, session: int | None, compared: SessionVerdicts | None
) -> tuple[Drawing | None, str]:
    """Return the trajectories over the path, and what is drawn in words."""
    newest = task.rows[-1]["session"]
    earlier = None if compared is None else compared.earlier
    of: dict[int | None, list[int]] = {}
    for place, row in enumerate(task.rows):
        of.setdefault(row["session"], []).append(place)
    newest_trials = of.pop(newest)
    past = _spread([place for places in of.values() for place in places] if session is None else of.get(earlier, []))
    chosen = [*past, *newest_trials[-MOST_OWN:]]
    if not task.path:
        return None, ""
    read = {place: _trajectory(task.folders[place]) for place in chosen}
    now = [line for place, line in read.items() if line and task.rows[place]["session"] == newest]
    before = [line for place, line in read.items() if line and task.rows[place]["session"] != newest]
    description = Text(
        "report-trajectories",
        count=len(now),
        newest=newest,
        others="none" if not before else "sessions" if session is None else "session",
        before=len(before),
        earlier=earlier or 0,
        chosen=len(task.rows) if session is None and len(chosen) < len(task.rows) else 0,
        lost=len(read) - len(now) - len(before),
    )
    drawing = trajectory_drawing(task.path, before, now, f"{source_description(task.source)}: {description}")
    return drawing, str(description)


def _spread(places: Sequence[int]) -> list[int]:
    """Return at most 30 places, evenly over all of them, the first and the last among them."""
    if len(places) <= MOST_PAST:
        return list(places)
    return [places[round(step * (len(places) - 1) / (MOST_PAST - 1))] for step in range(MOST_PAST)]


def _trajectory(folder: Path) -> Trajectory:
    try:
        rows = read_trajectory(folder)
    except (ValueError, OSError):
        return ()
    indices = thinned(rows.x, rows.y)
    return list(zip(rows.x[indices].tolist(), rows.y[indices].tolist(), strict=True))


def _curve(name: str, rows: Rows, newest: int, fit: dict[str, Any] | None) -> Drawing | None:
    points = [
        CurvePoint(row["number"], row["session"], value, row["session"] == newest, row["familiarisation"])
        for row in rows
        if (value := value_of(row, name)) is not None
    ]
    description = Text("report-curve-of", measure=TRIAL_MEASURES[name].name, count=len(points))
    return curve_drawing(points, fit, TRIAL_MEASURES[name], str(description))


def with_unit(name: str, value: float | None) -> str:
    """Return a level of a measure in words; "" for None."""
    return "" if value is None or not math.isfinite(value) else str(TRIAL_MEASURES[name].level(value))


def share_text(share: float | None) -> str:
    """Return a share in percent, in words; "" for None."""
    return "" if share is None else str(Text("report-share", share=Figure(100 * share)))


def noise_text(name: str, verdict: Verdict) -> str:
    """Return from where to where a level is within noise; "" for too few trials, or no word."""
    if verdict.low is None or verdict.high is None:
        return ""
    measure = TRIAL_MEASURES[name]
    noise = Text("report-range", low=measure.figure(verdict.low), high=measure.figure(verdict.high))
    return str(measure.with_unit(str(noise)))


def interface_test_report(
    material: InterfaceTestMaterial, session: int | None, *, name_source: bool
) -> InterfaceTestReport:
    """Return the two-minute tests of one kind of source, of one session (its number) or of the course (None).

    Those that the newest test is compared with stand among them, whichever session they are of.
    `name_source` says whether the report has several sources, so that each table must name its own.
    """
    counted = counted_tests([reported.test for reported in material.tests])
    numbers = {reported.test.number for reported in material.tests if session in (None, reported.session)}
    compared = [pair for pair in interface_verdicts(counted) if pair.later in numbers]
    shown = _shown(material.tests, numbers, compared, course=session is None)
    complete = Text("report-tests-complete", count=len(counted))
    if session is not None:
        complete = Text("report-tests-complete-until", count=len(counted), session=session)
    left_out = len(material.tests) - len(shown)
    others = [str(Text("report-tests-left-out", count=left_out))] if left_out else []
    source = [f"{source_description(material.source)}."] if name_source else []
    head = (Text("report-tests-test"), *(measure.name for measure in TEST_MEASURES.values()), WORKLOAD_NAME)
    return InterfaceTestReport(
        lead=" ".join([*source, str(complete), *others]),
        table=ReportTable(
            tuple(map(str, head)),
            tuple(map(_row, shown)) + tuple(map(_verdicts, compared)),
        ),
    )


def _shown(
    tests: tuple[ReportedTest, ...], own_numbers: set[int], compared: list[InterfaceVerdicts], *, course: bool
) -> list[ReportedTest]:
    newest = {reported.test.number for reported in tests[-MOST_ROWS + 1 :]} if course else own_numbers
    numbers = newest | {pair.earlier for pair in compared}
    return [reported for reported in tests if reported.test.number in numbers]


def _row(reported: ReportedTest) -> tuple[str, ...]:
    number, end, _, measures = reported.test
    head = str(Text("report-test-of-session", number=number, session=reported.session))
    if end != "complete" or measures is None:
        return (head, str(ENDS[end or "fault"]), *[""] * len(TEST_MEASURES))
    workload = "" if reported.workload is None else value_text(Figure(reported.workload))
    levels = (
        "" if (value := measures.get(name)) is None else str(measure.level(value))
        for name, measure in TEST_MEASURES.items()
    )
    return (head, *levels, workload)


def _verdicts(compared: InterfaceVerdicts) -> tuple[str, ...]:
    verdicts = (compared.verdicts[name].word if name in compared.verdicts else None for name in TEST_MEASURES)
    return (
        str(Text("report-test-against", later=compared.later, earlier=compared.earlier)),
        *("" if word is None else str(VERDICT_WORDS_OF_TESTS[word]) for word in verdicts),
        "",
    )
