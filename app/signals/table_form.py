"""Finds the form of a table in text by its beginning: its dialect, its header, its units, where its rows begin.

Programs write lines about the device above the header, units below it or in it, an index without a name before the
first column, and separators behind the last one. The rows at the end of the beginning decide: a dialect is right when
most of their cells are numbers, and the rows begin at the first line that is like them.
"""

import csv
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final, Literal, NamedTuple

from app.signals.cells import is_like_a_number, is_missing, is_moment, is_number, number_of
from app.signals.column_names import bare_names, unique_names
from app.signals.csv_dialect import (
    SEPARATORS,
    UTF_8,
    Dialect,
    cells_of,
    encoding_of,
    is_comment,
    names_of,
    without_mark,
)
from app.signals.logged_lines import LogForm, log_form, plain_text
from app.signals.row_places import RowPlaces
from app.signals.table_header import TIME, Line, header_of, stated_rate
from app.signals.time_columns import FIRST, LAST
from app.signals.time_groups import time_groups
from app.signals.time_names import time_names
from app.texts import Text

HEAD: Final = 200_000  # bytes of a file by which its form is found
SAMPLE: Final = 80  # lines at the end of the head
FOLLOWING: Final = 6  # rows of which half must be like the first one
SURELY_NAMES: Final = 5  # numbers that count from 0 in the first line: fewer can be a row, as of a path
MOST_COUNTED: Final = 10**8  # samples, as a line below the header counts them (AcqKnowledge)

Kind = Literal["number", "moment", "text", "empty"]


class TableForm(NamedTuple):
    """How a table in text is to be read; a column without a name has an empty one."""

    dialect: Dialect
    names: tuple[str, ...]
    units: tuple[str, ...]  # empty where the file says none
    kinds: tuple[Kind, ...]  # by the first rows
    first: int  # line of the first row, from 0; that of the end where there is none
    has_header: bool
    rate: float | None = None  # Hz, as the lines above the rows state it
    groups: tuple[int, ...] = ()  # columns of times, each for those up to the next one; empty: there is one time
    log: LogForm | None = None  # of lines that a monitor of a serial line has written

    def header_place(self, file: str) -> Text:
        """Return the place of the line above the rows, of the first one where there is no header."""
        return RowPlaces(file).line(max(self.first, 1))


class TableStart(NamedTuple):
    """Where the rows begin, behind numbers that are none: names that are numbers, or a sample rate (Hz)."""

    first: int  # among the lines that are no comments
    names: list[str]
    rate: float | None


def form_of_head(head: bytes, file: str) -> TableForm:
    """Return the form of the table in a file that begins with `head`, HEAD bytes or all; errors as of `form_of`."""
    encoding = encoding_of(head)
    if encoding is None:
        raise ValueError(Text("signals-no-csv", file=file))
    text = head.decode(encoding, "ignore").rstrip("\0")
    if len(head) == HEAD:  # the last line may be cut
        text = text[: text.rfind("\n") + 1] or text
    return form_of(text, file, encoding)


def form_of(text: str, file: str, encoding: str = UTF_8) -> TableForm:
    """Return the form of the table that begins with `text`, whole lines of the file.

    Raises
    ------
    ValueError
        One sentence: the file, what is wrong, what to do.
    """
    log = log_form(text)
    text = text if log is None else plain_text(text, log)
    lines = [Line(number, line.rstrip("\r")) for number, line in enumerate(text.split("\n"))]
    filled = [line for line in lines if line.text.strip()]
    rows = [line for line in filled if not is_comment(line.text)]
    if not filled:
        raise ValueError(Text("signals-empty", file=file))
    if any("\r" in line.text for line in filled):
        raise ValueError(Text("signals-line-ends", file=file))
    try:
        dialect, width = _dialect_of(rows[-SAMPLE:], encoding)
        form = _form(filled, rows, dialect, width, file)
    except csv.Error as error:
        raise ValueError(Text("signals-no-csv", file=file)) from error
    if log is None:
        return form
    if len(log.labels) == len(form.names) and not form.has_header:
        form = form._replace(names=log.labels, has_header=True)
    return form._replace(log=log)


def _form(filled: Sequence[Line], rows: Sequence[Line], dialect: Dialect, width: int, file: str) -> TableForm:
    top = _first_row(rows, dialect, width)
    if top is None:
        return _without_rows(filled, rows, dialect, width, file)
    first, numbers, rate = _start_of(rows, top, dialect)
    above = [line for line in filled if line.number < rows[top].number]
    cells = [cells_of(line.text, dialect.separator) for line in rows[first : first + SAMPLE]]
    of_width = [row for row in cells if len(row) == width]
    kinds = _kinds(of_width, width)
    header = header_of(above, dialect.separator, width, width - (kinds[-1] == "empty"))
    names, units = (header.names or numbers), header.units
    place = RowPlaces(file).line(rows[first].number + 1)
    if names and len(names) == width - 1:
        if kinds[-1] == "empty":  # separators behind the rows
            names, units = [*names, ""], [*units, ""]
        elif _is_index([row[0] for row in of_width]):
            names, units = ["", *names], ["", *units]
        else:
            raise ValueError(Text("signals-cells", place=place, count=width, expected=len(names)))
    if not names and above and (expected := _count_of_names(above[-1], dialect)) > 1 < width:
        raise ValueError(Text("signals-cells", place=place, count=width, expected=expected))
    if names and not names[0] and not time_names(names) and _holds_times(kinds[0], [row[0] for row in of_width]):
        names = [TIME, *names[1:]]
    named = names or [f"column_{number}" for number in range(1, width + 1)]
    in_names = [unit for _, unit in bare_names(named)]
    said = [unit or other for unit, other in zip(units or [""] * width, in_names, strict=True)]
    groups = time_groups(named, said)
    return TableForm(
        dialect,
        tuple(unique_names(named) if groups else named),
        tuple(said),
        tuple(kinds),
        rows[first].number,
        bool(names),
        rate or stated_rate(line.text for line in above if header.top is None or line.number < header.top),
        groups,
    )


def _start_of(rows: Sequence[Line], first: int, dialect: Dialect) -> TableStart:
    """Return where the rows begin, of which the first one that is like a row is `first`.

    AcqKnowledge writes how many samples each channel has below the names, pandas numbers as names, and Empatica the
    beginning (s since 1970) and the sample rate in place of a header.
    """
    found = [cells_of(line.text, dialect.separator) for line in rows[first : first + 3]]
    if len(found) < 3:
        return TableStart(first, [], None)
    (top, second, _), at_top = found, first == 0
    filled = [cell for cell in top if cell]
    if not top[0] and len(set(filled)) == 1 and filled[0].isdecimal() and FOLLOWING <= int(filled[0]) <= MOST_COUNTED:
        return TableStart(first + 1, [], None)
    is_counted = filled == [str(number) for number in range(len(filled))]
    if at_top and is_counted and (not top[0] or len(filled) >= SURELY_NAMES):
        return TableStart(first + 1, top, None)
    begin, rate = number_of(top[0], dialect.decimal), number_of(second[0], dialect.decimal)
    are_alike = len({*top}) == len({*second}) == 1
    if at_top and are_alike and begin is not None and rate is not None and FIRST <= begin < LAST and rate > 0:
        return TableStart(2, [], rate)
    return TableStart(first, [], None)


def _holds_times(kind: Kind, cells: Sequence[str]) -> bool:
    """Return whether a first column without a name holds times, and is no index."""
    return kind == "moment" or (kind == "number" and not _is_index(cells))


def _is_index(cells: Sequence[str]) -> bool:
    """Return whether the first column names or counts its rows, as R and pandas write it."""
    counted = [int(cell) for cell in cells if cell.isascii() and cell.isdecimal()]
    if len(counted) < len(cells):
        return not any(map(is_like_a_number, cells))
    return all(after == before + 1 for before, after in pairwise(counted))


def _without_rows(filled: Sequence[Line], rows: Sequence[Line], dialect: Dialect, width: int, file: str) -> TableForm:
    """Return the form of a header alone; raise ValueError for lines that are no rows of it."""
    header, *below = rows or filled[-1:]
    names = names_of(without_mark(header.text) if is_comment(header.text) else header.text, dialect.separator, width)
    for line in below:
        cells = cells_of(line.text, dialect.separator)
        if any(is_number(cell, dialect.decimal) and not is_missing(cell) for cell in cells):
            place = RowPlaces(file).line(line.number + 1)
            raise ValueError(Text("signals-cells", place=place, count=len(cells), expected=len(names)))
    if below:
        raise ValueError(Text("signals-no-numbers", file=file))
    units = [unit for _, unit in bare_names(names)]
    kinds: list[Kind] = ["empty"] * len(names)
    return TableForm(dialect, tuple(names), tuple(units), tuple(kinds), header.number + 1, True)


def _dialect_of(sample: Sequence[Line], encoding: str) -> tuple[Dialect, int]:
    """Return the dialect in which most cells of the lines are numbers, and the count of cells of a row."""
    best, width, highest = Dialect(encoding=encoding), 1, (False, -1.0, 0)
    for separator in SEPARATORS:
        rows = list(_parsed(sample, separator))
        comma_decimals = any("," in cell for row in rows for cell in row)
        for decimal in (",", ".") if comma_decimals else (".",):
            for count in {len(row) for row in rows}:
                rank = (count > 1, _share_of_values(rows, count, decimal), count)
                if rank > highest:
                    best, width, highest = Dialect(separator, decimal, encoding), count, rank
    return best, width


def _parsed(lines: Sequence[Line], separator: str) -> Iterator[list[str]]:
    for line in lines:
        try:
            yield cells_of(line.text, separator)
        except csv.Error:
            continue


def _share_of_values(rows: Sequence[Sequence[str]], count: int, decimal: str) -> float:
    """Return how well rows of `count` cells fit: the share of cells that are values, and the share of such rows."""
    of_count = [row for row in rows if len(row) == count]
    values = sum(is_number(cell, decimal) or is_missing(cell) or is_moment(cell) for row in of_count for cell in row)
    return values / sum(map(len, rows)) * (len(of_count) / len(rows)) ** 2


def _first_row(rows: Sequence[Line], dialect: Dialect, width: int) -> int | None:
    """Return the index of the first line that is a row of the table.

    A line in front of it that is a row but for some cells is one, too: who reads it says what is wrong with them.
    """
    last = [cells_of(line.text, dialect.separator) for line in rows[-SAMPLE:]]
    of_width = [row for row in last if len(row) == width]
    kinds = _kinds(of_width[-((len(of_width) + 1) // 2) :], width)

    def is_row(line: Line) -> bool:
        cells = cells_of(line.text, dialect.separator)
        return len(cells) == width and _is_row(cells, kinds, dialect.decimal)

    def is_faulty_row(line: Line) -> bool:
        cells = cells_of(line.text, dialect.separator)
        return (
            len(cells) == width
            and kinds[_first_of(kinds)] == "number"
            and is_number(cells[_first_of(kinds)], dialect.decimal)
        )

    for index, line in enumerate(rows):
        following = rows[index : index + FOLLOWING]
        if is_row(line) and 2 * sum(map(is_row, following)) >= len(following):
            while index > 1 and is_faulty_row(rows[index - 1]):
                index -= 1  # noqa: PLW2901
            return index
    return None


def _first_of(kinds: Sequence[Kind]) -> int:
    """Return the first column of numbers, or else the first one."""
    return next((column for column, kind in enumerate(kinds) if kind == "number"), 0)


def _is_row(row: Sequence[str], kinds: Sequence[Kind], decimal: str) -> bool:
    values = [cell for cell, kind in zip(row, kinds, strict=True) if kind in {"number", "moment"}]
    filled = [cell for cell in values if not is_missing(cell)]
    return bool(filled) and all(
        is_number(cell, decimal) or is_like_a_number(cell) or is_moment(cell) for cell in filled
    )


def _kinds(rows: Sequence[Sequence[str]], width: int) -> list[Kind]:
    """Return what the columns hold in rows of `width` cells; text where less than half are values."""
    return [_kind([row[column] for row in rows if not is_missing(row[column])]) for column in range(width)]


def _kind(cells: Sequence[str]) -> Kind:
    if not cells:
        return "empty"
    if 2 * sum(map(is_like_a_number, cells)) >= len(cells):
        return "number"
    return "moment" if 2 * sum(map(is_moment, cells)) >= len(cells) else "text"


def _count_of_names(line: Line, dialect: Dialect) -> int:
    """Return how many columns a line above the rows names; 0 for a line that names none."""
    cells = _trimmed(cells_of(line.text, dialect.separator))
    return 0 if is_comment(line.text) or any(map(is_like_a_number, cells)) else len(cells)


def _trimmed(cells: list[str]) -> list[str]:
    """Return the cells without empty ones at the end."""
    count = next((count for count in range(len(cells), 0, -1) if cells[count - 1]), 0)
    return cells[:count]
