"""Which signs a CSV file uses: commas, semicolons or tabs between its columns, a point or a comma in its numbers."""

import csv
import mmap
from pathlib import Path
from typing import Final, NamedTuple

SEPARATORS: Final = {",": "commas", ";": "semicolons", "\t": "tabs"}
DECIMALS: Final = {".": "points", ",": "commas"}


class Dialect(NamedTuple):
    """How the cells of a line are told apart, and the sign before a number's fraction."""

    separator: str = ","
    decimal: str = "."

    @property
    def words(self) -> str:
        """Return the dialect in a sentence; an empty string for commas between columns and decimal points."""
        if self == Dialect():
            return ""
        return f"It was read with {SEPARATORS[self.separator]} between columns and decimal {DECIMALS[self.decimal]}."


def separator_of(header: str) -> str:
    """Return what separates the columns of a header: the sign that makes the most columns, a comma rather than others.

    Raises
    ------
    csv.Error
        When the line cannot be taken apart.
    """
    return max(SEPARATORS, key=lambda separator: len(cells_of(header, separator)))


def cells_of(line: str, separator: str) -> list[str]:
    """Return the cells of one line, trimmed; raises csv.Error when it cannot be taken apart."""
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator))]


def decimals_to_try(file: Path, separator: str) -> tuple[str, ...]:
    """Return the decimal signs with which a file may be read, the likely one first.

    A comma that separates no columns stands in numbers, or in a column of words: then the points are in the numbers.
    """
    if separator == ",":
        return (".",)
    with file.open("rb") as opened, mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ) as content:
        below = content.find(b"\n")
        return (",", ".") if below >= 0 and content.find(b",", below) >= 0 else (".",)
