"""A recording as CSV files that a spreadsheet opens."""

from pathlib import Path
from typing import Any

from app.csv_cells import safe_cell
from app.exports.flat_table import flat_tables
from app.recording.groups import RunGroups

MOST_ROWS = 1_000_000  # of one file: a spreadsheet has 1,048,576


def write_csv(run: RunGroups, folder: Path, stem: str) -> list[Path]:
    """Write `STEM.csv` and, for a long run, `STEM-part-2.csv` and so on; return the files."""
    from pyarrow.csv import CSVWriter

    files: list[Path] = []
    writer: Any = None
    rows = 0
    for table in flat_tables(run):
        named = table.rename_columns([safe_cell(name) for name in table.column_names])
        if writer is None or rows + named.num_rows > MOST_ROWS:
            if writer is not None:
                writer.close()
            part = f"-part-{len(files) + 1}" if files else ""
            files.append(folder / f"{stem}{part}.csv")
            writer, rows = CSVWriter(files[-1], named.schema), 0
        writer.write_table(named)
        rows += named.num_rows
    writer.close()
    return files
