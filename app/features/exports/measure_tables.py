"""The trials and the two-minute tests of an export as tables: one row each, with its measures, verdicts and answers."""

import json
from collections.abc import Iterator
from pathlib import Path

from app import __version__
from app.csv_cells import SPREADSHEET_BEGIN, csv_line
from app.features.exports.export_material import SIMULATED_WORDS, ExportMaterial
from app.features.exports.recorded_runs import RecordedRun, RecordedTest
from app.recording.format import META_FILE
from app.scoring.interface_test.workload import Workload
from app.scoring.measures import EXPORTED, TEST_MEASURES, VERDICT_WORDS, is_number
from app.scoring.verdict.verdicts import trial_verdicts
from app.source import source_description

UNKNOWN = "unknown"


def recorded_with(folder: Path) -> str:
    """Return the version that a recording names; "unknown" when it is gone, cannot be read, or names none."""
    try:
        meta = json.loads((folder / META_FILE).read_bytes())
    except (OSError, ValueError):
        return UNKNOWN
    return str(meta.get("software", UNKNOWN)) if isinstance(meta, dict) else UNKNOWN


TRIAL_ABOUT = (
    *("patient", "session", "run", "trial", "floor_plan", "path", "started", "end", "kept", "reason_left_out"),
    *("source", "simulated", "map_version", "parameters_hash", "software", "exported_with"),
    *("origin_clinic", "imported_by", "imported"),
)


def verdict_words(material: ExportMaterial) -> dict[int, dict[str, str]]:
    """Return the words of the verdicts on each trial against the one before it: trial -> measure -> words."""
    found: dict[int, dict[str, str]] = {}
    for task in material.tasks:
        for row in task.rows:
            verdicts = trial_verdicts(task.rows, task.clinic, row["id"], None).verdicts
            told = {name: verdict.word for name, verdict in verdicts.items() if verdict.word != "number"}
            found[row["id"]] = {name: VERDICT_WORDS[word] for name, word in told.items()}
    return found


def trial_csv(material: ExportMaterial, verdicts: dict[int, dict[str, str]]) -> str:
    """Return the trials as CSV; a measure that the trial does not have is an empty cell."""
    heads = [column for name, measure in EXPORTED.items() for column in (f"{name} [{measure.ucum}]", f"{name} verdict")]
    lines = [csv_line([*TRIAL_ABOUT, *heads])]
    lines += [
        csv_line(list(_trial_cells(material.code, run, verdicts))) for run in material.runs if run.trial is not None
    ]
    return SPREADSHEET_BEGIN + "".join(lines)


def _trial_cells(code: str, run: RecordedRun, verdicts: dict[int, dict[str, str]]) -> Iterator[str | float | None]:
    trial = run.trial
    assert trial is not None
    yield from (code, run.session, run.number, trial.number, trial.title, trial.path)
    yield from (trial.started.isoformat(), trial.end or "", "yes" if trial.kept else "no", trial.reason or "")
    yield from (source_description(run.source), SIMULATED_WORDS[run.source.simulated])
    yield from (trial.map_version, trial.parameters_hash, recorded_with(run.folder), __version__)
    yield from ("", "", "") if (origin := run.origin) is None else (origin.clinic, origin.person, origin.at.isoformat())
    for name in EXPORTED:
        value = trial.measures.get(name)
        yield value if is_number(value) else None
        yield verdicts.get(trial.id, {}).get(name, "")


TEST_ABOUT = (
    *("patient", "session", "run", "test", "started", "end", "source", "simulated"),
    *("map_version", "parameters_hash", "software", "exported_with"),
)


def interface_test_csv(code: str, runs: tuple[RecordedRun, ...]) -> str:
    """Return the two-minute tests as CSV; what was not measured or answered is an empty cell. "" without tests."""
    rows = [csv_line(list(_test_cells(code, run, run.test))) for run in runs if run.test is not None]
    if not rows:
        return ""
    measures = [f"{name} [{measure.ucum}]" for name, measure in TEST_MEASURES.items()]
    answers = [f"workload {name} [0-100]" for name in Workload.model_fields]
    return "".join([SPREADSHEET_BEGIN, csv_line([*TEST_ABOUT, *measures, *answers]), *rows])


def _test_cells(code: str, run: RecordedRun, test: RecordedTest) -> Iterator[str | float | None]:
    yield from (code, run.session, run.number, test.number, test.started.isoformat(), test.end or "")
    yield from (source_description(run.source), SIMULATED_WORDS[run.source.simulated])
    yield from (test.map_version, test.parameters_hash, recorded_with(run.folder), __version__)
    yield from (test.measures.get(name) for name in TEST_MEASURES)
    yield from (test.workload.get(name) for name in Workload.model_fields)
