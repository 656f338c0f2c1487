"""The tables of an export: each trial a row, each two-minute test a row, and a recording with a column for each number.

As CSV for spreadsheets; a recording also as one Parquet file.
"""

import json
from codecs import BOM_UTF8
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from app import __version__
from app.csv_cells import SPREADSHEET_BEGIN, csv_line, safe_cell
from app.features.exports.export_material import SIMULATED_WORDS, ExportMaterial
from app.features.exports.recorded_runs import RecordedRun, RecordedTest
from app.recording.format import META_FILE, META_KEY, PER_CHANNEL, PER_GESTURE, SCALARS
from app.recording.groups import RunGroups
from app.scoring.interface_test.workload import Workload
from app.scoring.measures import EXPORTED, TEST_MEASURES, VERDICT_WORDS, is_number
from app.scoring.verdict.verdicts import trial_verdicts
from app.source import source_description

if TYPE_CHECKING:
    import pyarrow as pa

UNKNOWN = "unknown"


def channel_names(meta: dict[str, Any]) -> list[str]:
    """Return the names of the shirt's channels, in the order of a frame's values."""
    return [str(channel["name"]) for channel in meta["layout"]["channels"]]


def gesture_names(meta: dict[str, Any]) -> list[str]:
    """Return the names of the gestures, in the order of the vocabulary."""
    return [str(name) for name in meta["gestures"]]


def flat_tables(run: RunGroups) -> Iterator["pa.Table"]:
    """Yield the rows of a run, group by group.

    The columns are the recorded scalars under their names, `score.NAME`, `rate.NAME` and `activation.NAME` for each
    gesture, and `values.NAME` for each channel. A number that was not measured is null.
    """
    import pyarrow as pa

    parts = {PER_CHANNEL: channel_names(run.meta), **{name: gesture_names(run.meta) for name in PER_GESTURE}}
    for columns in run.groups:
        arrays = {name: _array(columns[name]) for name in SCALARS}
        for name in (*PER_GESTURE, PER_CHANNEL):
            for place, part in enumerate(parts[name]):
                arrays[f"{name}.{part}"] = _array(columns[name][:, place])
        yield pa.table(arrays)


def _array(column: Any) -> Any:
    import pyarrow as pa

    column = np.ascontiguousarray(column)
    missing = np.isnan(column) if column.dtype.kind == "f" else None
    return pa.array(column, mask=missing)


MOST_ROWS = 1_000_000  # of one file: a spreadsheet has 1,048,576


def write_csv(run: RunGroups, folder: Path, stem: str) -> list[Path]:
    """Write `STEM.csv` and, for a long run, `STEM-part-2.csv` and so on; return the files."""
    from pyarrow.csv import CSVWriter

    files: list[Path] = []
    rows = 0
    with ExitStack() as opened:
        writer: Any = None
        for table in flat_tables(run):
            named = table.rename_columns([safe_cell(name) for name in table.column_names])
            if writer is None or rows + named.num_rows > MOST_ROWS:
                opened.close()
                part = f"-part-{len(files) + 1}" if files else ""
                files.append(folder / f"{stem}{part}.csv")
                file = opened.enter_context(files[-1].open("wb"))
                file.write(BOM_UTF8)
                writer, rows = opened.enter_context(CSVWriter(file, named.schema)), 0
            writer.write_table(named)
            rows += named.num_rows
    return files


def write_parquet(run: RunGroups, facts: dict[str, Any], folder: Path, stem: str) -> list[Path]:
    """Write `STEM.parquet`, with `facts` as JSON under the key `bodydrive` of its metadata; return the file."""
    import pyarrow.parquet as pa_parquet

    file = folder / f"{stem}.parquet"
    writer: Any = None
    for table in flat_tables(run):
        if writer is None:
            schema = table.schema.with_metadata({META_KEY: json.dumps(facts)})
            writer = pa_parquet.ParquetWriter(file, schema, compression="zstd", use_dictionary=False)
        writer.write_table(table.cast(writer.schema))
    writer.close()
    return [file]


def _recorded_with(folder: Path) -> str:
    """Return the version that a recording names; "unknown" when it is gone, cannot be read, or names none."""
    try:
        meta = json.loads((folder / META_FILE).read_bytes())
    except (OSError, ValueError):
        return UNKNOWN
    return str(meta.get("software", UNKNOWN)) if isinstance(meta, dict) else UNKNOWN


TRIAL_ABOUT = (
    *("patient", "session", "run", "trial", "floor_plan", "path", "started", "end", "kept", "reason_left_out"),
    *("source", "shirt", "simulated", "map_version", "parameters_hash", "software", "exported_with"),
    *("origin_clinic", "imported_by", "imported"),
)


def verdict_texts(material: ExportMaterial) -> dict[int, dict[str, str]]:
    """Return the words of the verdicts on each trial against the one before it: trial -> measure -> words."""
    texts: dict[int, dict[str, str]] = {}
    for task in material.tasks:
        for row in task.rows:
            verdicts = trial_verdicts(task.rows, task.clinic, row["id"], None).verdicts
            judged = {name: verdict.word for name, verdict in verdicts.items() if verdict.word != "number"}
            texts[row["id"]] = {name: str(VERDICT_WORDS[word]) for name, word in judged.items()}
    return texts


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
    yield from (source_description(run.source), run.source.shirt, SIMULATED_WORDS[run.source.simulated])
    yield from (trial.map_version, trial.parameters_hash, _recorded_with(run.folder), __version__)
    yield from ("", "", "") if (origin := run.origin) is None else (origin.clinic, origin.person, origin.at.isoformat())
    for name in EXPORTED:
        value = trial.measures.get(name)
        yield value if is_number(value) else None
        yield verdicts.get(trial.id, {}).get(name, "")


TEST_ABOUT = (
    *("patient", "session", "run", "test", "started", "end", "source", "shirt", "simulated"),
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
    yield from (source_description(run.source), run.source.shirt, SIMULATED_WORDS[run.source.simulated])
    yield from (test.map_version, test.parameters_hash, _recorded_with(run.folder), __version__)
    yield from (test.measures.get(name) for name in TEST_MEASURES)
    yield from (test.workload.get(name) for name in Workload.model_fields)
