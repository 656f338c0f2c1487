"""A recording as one table with a column for each number, written as CSV for spreadsheets, or as one Parquet file."""

import json
from codecs import BOM_UTF8
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from app.csv_cells import safe_cell
from app.recording.format import META_KEY, PER_CHANNEL, PER_GESTURE, SCALARS
from app.recording.groups import RunGroups

if TYPE_CHECKING:
    import pyarrow as pa


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
