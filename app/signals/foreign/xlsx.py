"""Reads the largest sheet of a workbook as a table in text, which has the dialects of any other."""

import datetime
from collections.abc import Iterable
from pathlib import Path
from typing import Final

from app.signals.foreign.recording import library

MOST_CELLS: Final = 20_000_000


def read(file: Path) -> str:
    """Return the sheet with the most cells, tabs between its cells."""
    workbook = library("openpyxl").load_workbook(file, read_only=True, data_only=True)
    sheets = [sheet for sheet in workbook.worksheets if hasattr(sheet, "iter_rows")]
    largest = max(sheets, key=lambda sheet: (sheet.max_row or 0) * (sheet.max_column or 0))
    largest.reset_dimensions()  # some programs state wrong ones
    return "".join(f"{line_of(row)}\n" for row in largest.iter_rows(values_only=True))


def line_of(row: Iterable[object]) -> str:
    """Return the cells of a row with tabs between them."""
    return "\t".join(map(_text_of, row))


def _text_of(cell: object) -> str:
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return str(int(cell))
    if isinstance(cell, datetime.timedelta):
        return repr(cell.total_seconds())
    if isinstance(cell, datetime.datetime | datetime.time):
        return cell.isoformat()
    return " ".join(str(cell).split()) if isinstance(cell, str) else repr(cell)
