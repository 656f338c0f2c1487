"""The two-minute tests of an export as a table: one row each, with its measures and the answers about workload."""

from collections.abc import Iterator

from app import __version__
from app.csv_cells import SPREADSHEET_BEGIN, csv_line
from app.features.exports.export_material import SIMULATED_WORDS
from app.features.exports.recorded_runs import RecordedRun, RecordedTest
from app.features.exports.recorded_with import recorded_with
from app.scoring.interface_test.workload import Workload
from app.scoring.measures import TEST_MEASURES
from app.source import source_words

ABOUT = (
    *("patient", "session", "run", "test", "started", "end", "source", "simulated"),
    *("map_version", "parameters_hash", "software", "exported_with"),
)


def interface_test_csv(code: str, runs: tuple[RecordedRun, ...]) -> str:
    """Return the two-minute tests as CSV; what was not measured or answered is an empty cell. "" without tests."""
    rows = [csv_line(list(_cells(code, run, run.test))) for run in runs if run.test is not None]
    if not rows:
        return ""
    measures = [f"{name} [{measure.ucum}]" for name, measure in TEST_MEASURES.items()]
    answers = [f"workload {name} [0-100]" for name in Workload.model_fields]
    return "".join([SPREADSHEET_BEGIN, csv_line([*ABOUT, *measures, *answers]), *rows])


def _cells(code: str, run: RecordedRun, test: RecordedTest) -> Iterator[str | float | None]:
    yield from (code, run.session, run.number, test.number, test.started.isoformat(), test.end or "")
    yield from (source_words(run.source), SIMULATED_WORDS[run.source.simulated])
    yield from (test.map_version, test.parameters_hash, recorded_with(run.folder), __version__)
    yield from (test.measures.get(name) for name in TEST_MEASURES)
    yield from (test.workload.get(name) for name in Workload.model_fields)
