"""A recording as CSV files that a spreadsheet opens."""

from codecs import BOM_UTF8
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from app.csv_cells import safe_cell
from app.features.exports.flat_table import flat_tables
from app.recording.groups import RunGroups

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
