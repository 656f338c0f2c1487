"""Reads the largest sheet of a workbook as a table in text, which has the dialects of any other."""

import datetime
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final

from app.signals.file_table import FilePart, listed
from app.signals.foreign.recording import ForeignText, library, part_missing
from app.signals.table_header import stated_rate
from app.texts import Text

FEW_ROWS: Final = 100  # of a sheet about the recording


def read(file: Path, part: str | None = None) -> ForeignText:
    """Return the sheet `part`, else the one with the most cells, tabs between its cells.

    A sample rate may stand in a small sheet beside it.
    """
    workbook = library("openpyxl").load_workbook(file, read_only=True, data_only=True)
    sheets = {str(sheet.title): sheet for sheet in workbook.worksheets if hasattr(sheet, "iter_rows")}
    sizes = {title: ((sheet.max_column or 0), (sheet.max_row or 0)) for title, sheet in sheets.items()}
    if part is not None and part not in sheets:
        raise part_missing(file, part, [*sheets])
    chosen = part or max(sheets, key=lambda title: sizes[title][0] * sizes[title][1])
    beside = [text_of_sheet(sheets[title]) for title in sheets if title != chosen and 0 < sizes[title][1] <= FEW_ROWS]
    parts = tuple(FilePart(title, *sizes[title]) for title in sheets) if len(sheets) > 1 else ()
    rate = stated_rate(line for text in beside for line in text.splitlines())
    others = [title for title in sheets if title != chosen and sizes[title][1] > FEW_ROWS]
    note = Text("signals-sheet-read", sheet=chosen, names=listed(others)) if others and part is None else None
    return ForeignText(text_of_sheet(sheets[chosen]), rate, parts, note)


def text_of_sheet(sheet: Any) -> str:
    """Return a sheet as a table in text."""
    sheet.reset_dimensions()  # some programs state wrong ones
    return "".join(f"{line_of(row)}\n" for row in sheet.iter_rows(values_only=True))


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
    if isinstance(cell, datetime.date | datetime.time):
        return cell.isoformat()
    return " ".join(str(cell).split()) if isinstance(cell, str) else repr(cell)
