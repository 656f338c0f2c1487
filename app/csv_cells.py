"""Cells of CSV files that spreadsheets show as text: one that begins like a formula could run one when it is opened."""

import csv
import io
from collections.abc import Sequence

SPREADSHEET_BEGIN = "\ufeff"  # of a file for spreadsheets: without a byte order mark they do not read it as UTF-8
FULL_WIDTH = ("\uff1d", "\uff0b", "\uff0d", "\uff20")  # = + - @ as typed on Japanese keyboards
FORMULA_BEGINS = ("=", "+", "-", "@", "\t", "\r", "\n", *FULL_WIDTH)


def safe_cell(text: str) -> str:
    """Return a text that no spreadsheet runs as a formula: an apostrophe stands before one that begins like it."""
    return f"'{text}" if text.startswith(FORMULA_BEGINS) else text


def csv_line(cells: Sequence[str | float | None]) -> str:
    """Return one line of a CSV file: each text safe, each number as it is, an empty cell for None."""
    line = io.StringIO()
    csv.writer(line).writerow([safe_cell(cell) if isinstance(cell, str) else cell for cell in cells])
    return line.getvalue()
