"""Where a row of a table stands in its file, for the sentence of a refusal."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from app.texts import Text


class RowPlaces(NamedTuple):
    """The file of a table, and where its rows stand: in lines of a text, or counted as rows."""

    file: str
    first_line: int | None = 2  # of row 0, from 1; None where a file has rows and no lines
    lines: Sequence[int] | None = None  # of all rows, where they do not follow each other

    def row(self, row: int) -> Text:
        """Return the place of row `row` (from 0)."""
        if self.lines is not None:
            row = int(self.lines[row])
            return self.line(row) if self.first_line is not None else Text("signals-row", file=self.file, row=row)
        if self.first_line is None:
            return Text("signals-row", file=self.file, row=row + 1)
        return self.line(row + self.first_line)

    def line(self, line: int) -> Text:
        """Return the place of a line (from 1)."""
        return Text("signals-line", file=self.file, line=line)


def places_of_rows(file: Path) -> RowPlaces:
    """Return the places of the rows of a file without lines."""
    return RowPlaces(str(file), None)
