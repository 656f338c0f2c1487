"""Detects the dialect of a CSV file: commas, semicolons or tabs between columns, a point or a comma in numbers."""

import csv
import mmap
from pathlib import Path
from typing import Final, NamedTuple

from app.texts import Text

SEPARATORS: Final = {",": "commas", ";": "semicolons", "\t": "tabs"}


class Dialect(NamedTuple):
    """The separator between the cells of a line, and the decimal sign of its numbers."""

    separator: str = ","
    decimal: str = "."

    @property
    def sentence(self) -> Text | None:
        """Return the dialect in a sentence; None for the usual one, commas and decimal points."""
        if self == Dialect():
            return None
        decimal = "point" if self.decimal == "." else "comma"
        return Text("signals-dialect", separator=SEPARATORS[self.separator], decimal=decimal)


def separator_of(header: str) -> str:
    """Return the separator that splits a header into the most columns; the comma when several are equal.

    Raises
    ------
    csv.Error
        When the line cannot be parsed.
    """
    return max(SEPARATORS, key=lambda separator: len(cells_of(header, separator)))


def cells_of(line: str, separator: str) -> list[str]:
    """Return the trimmed cells of one line; raise csv.Error when it cannot be parsed."""
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator))]


def decimals_to_try(file: Path, separator: str) -> tuple[str, ...]:
    """Return the decimal signs to try on a file, the likely one first.

    A comma that does not separate columns is a decimal comma, or part of a text column; then the decimal sign is a
    point.
    """
    if separator == ",":
        return (".",)
    with file.open("rb") as opened, mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ) as content:
        below = content.find(b"\n")
        return (",", ".") if below >= 0 and content.find(b",", below) >= 0 else (".",)
