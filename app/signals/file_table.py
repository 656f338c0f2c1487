"""The table of a file: its columns by name, their units, and where its rows stand."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.recording.reader import both
from app.signals.csv_dialect import Dialect
from app.signals.row_places import RowPlaces
from app.texts import Text

Columns = dict[str, NDArray[np.generic]]
LONGEST_QUOTE = 30  # letters of what a file has


class FilePart(NamedTuple):
    """A part of a file that can be read alone: a stream, or the sheet of a workbook."""

    name: str
    channels: int  # 0 where nobody has counted them
    samples: int  # 0 where nobody has counted them


@dataclass(frozen=True, slots=True)
class FileTable:
    """Columns (n,) float64 or float32, missing numbers as NaN; those that were asked for as text are text."""

    columns: Columns
    units: Mapping[str, str]  # of the columns that have one
    places: RowPlaces
    dialect: Dialect | None = None  # of a table in text
    note: Text | None = None  # what was left out
    rate: float | None = None  # Hz, as the file states it beside its rows

    def numbers(self, name: str) -> NDArray[np.float64]:
        """Return a column (n,) of finite numbers; raise ValueError with the first row that has none."""
        if name not in self.columns:
            names = listed(list(self.columns))
            raise ValueError(Text("signals-column-missing", file=self.places.file, column=name, names=names))
        values = self.columns[name].astype(np.float64)
        bad = np.flatnonzero(~np.isfinite(values))
        if len(bad):
            raise ValueError(Text("signals-no-number", place=self.places.row(int(bad[0])), column=name))
        return values

    def only(self, names: Collection[str] | None) -> "FileTable":
        """Return the table of the columns `names`; None: of all."""
        if names is None:
            return self
        columns = {name: values for name, values in self.columns.items() if name in names}
        if not columns:
            there, wanted = listed(list(self.columns)), listed(sorted(names))
            raise ValueError(Text("signals-columns-missing", place=self.places.file, names=wanted, there=there))
        return replace(self, columns=columns)

    def without_empty_rows(self) -> "FileTable":
        """Return the table without the rows that hold nothing, as spreadsheets write below the last one."""
        filled = np.zeros(len(next(iter(self.columns.values()))), dtype=np.bool_)
        for column in self.columns.values():
            filled |= (column != "") if column.dtype.kind == "U" else ~np.isnan(column.astype(np.float64, copy=False))
            if filled.all():
                return self
        rows = np.flatnonzero(filled)
        first = 1 if self.places.first_line is None else self.places.first_line
        lines = rows + first if self.places.lines is None else np.asarray(self.places.lines)[rows]
        columns = {name: values[rows] for name, values in self.columns.items()}
        return replace(self, columns=columns, places=self.places._replace(lines=lines.tolist()))

    def with_note(self, note: Text | None) -> "FileTable":
        """Return the table with a further note."""
        return replace(self, note=both(self.note, note))


def listed(names: list[str], most: int = 6, longest: int = LONGEST_QUOTE) -> Text | str:
    """Return the first names, and how many more there are."""
    first = ", ".join(quoted(name, longest) for name in names[:most])
    return Text("signals-names-more", names=first, count=len(names) - most) if len(names) > most else first


def quoted(text: str, longest: int = LONGEST_QUOTE) -> str:
    """Return what a file has in one short line."""
    return " ".join(text[:longest].split()) + ("..." if len(text) > longest else "")
