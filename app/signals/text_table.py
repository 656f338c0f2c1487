"""Reads a table in text: CSV, TSV and their dialects.

The fast reader of pyarrow reads nearly all files. What it refuses (comments between rows, blanks around words for
missing numbers, columns between blanks) is read line by line, which also finds the place of what is wrong.
"""

import csv
import mmap
from array import array
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.signals.bids_motion import named_beside, rate_beside
from app.signals.cells import SPELLINGS, is_missing, number_of
from app.signals.clock_times import seconds_of_moments
from app.signals.csv_dialect import BLANKS, UTF_8, cells_of, is_comment
from app.signals.file_table import Columns, FileTable, listed, quoted
from app.signals.logged_lines import plain_text
from app.signals.row_places import RowPlaces
from app.signals.table_form import HEAD, TableForm, form_of_head
from app.signals.time_groups import joined_groups
from app.texts import Text

if TYPE_CHECKING:
    import pyarrow as pa

TAIL: Final = 100_000  # bytes in which the last line must begin
COMPARED: Final = 200  # lines in front of the last one, with which it is compared
FEWEST_COMPARED: Final = 10
ENDS: Final = b"\0\x1a\r\n"  # what may stand behind the last line
REMARK: Final = "#"  # begins a last cell that is none (LabChart)


class ChosenColumns(NamedTuple):
    """The columns of a table that are read: how, and by which index."""

    numbers: tuple[int, ...]
    moments: tuple[int, ...]
    texts: tuple[int, ...]
    late: tuple[int, ...] = ()  # empty in the first rows: later ones may hold numbers, or words (markers, comments)

    @property
    def all(self) -> tuple[int, ...]:
        """All of them, in the order of the file."""
        return tuple(sorted((*self.numbers, *self.as_text)))

    @property
    def as_text(self) -> tuple[int, ...]:
        """Those that are read as text at first."""
        return (*self.moments, *self.texts, *self.late)


def form_of_file(path: Path) -> TableForm:
    """Return the form of the table in a file; raise ValueError in one sentence when it has none."""
    with path.open("rb") as file:
        head = file.read(HEAD)
    form = form_of_head(head, str(path))
    beside = None if form.has_header else named_beside(path, len(form.names))
    return form if beside is None else form._replace(names=tuple(beside[0]), units=tuple(beside[1]))


def read_text_table(path: Path, text: Collection[str], only: Collection[str] | None) -> FileTable:
    """Return the table of a file; parameters and errors as of `app.signals.columns.read_table`."""
    form = form_of_file(path)
    table = _table_of_content(_content_of(path, form.dialect.encoding), form, str(path), text, only)
    return table if table.rate is not None else replace(table, rate=rate_beside(path))


def read_text_content(content: bytes, file: str, text: Collection[str], only: Collection[str] | None) -> FileTable:
    """Return the table that `content` is, in UTF-8, of a file; other parameters and errors as of `read_text_table`."""
    return _table_of_content(content, form_of_head(content[:HEAD], file), file, text, only)


def _table_of_content(
    content: "bytes | mmap.mmap", form: TableForm, file: str, text: Collection[str], only: Collection[str] | None
) -> FileTable:
    if form.log is not None:
        content = plain_text(content[:].decode(UTF_8, "replace"), form.log).encode()
    if form.groups:
        whole = _plain_table(content, form, file, text, None)
        return joined_groups(whole, [form.names[index] for index in form.groups]).only(only)
    return _plain_table(content, form, file, text, only)


def _plain_table(
    content: "bytes | mmap.mmap", form: TableForm, file: str, text: Collection[str], only: Collection[str] | None
) -> FileTable:
    choice = _choice(form, file, text, only)
    begin = _offset_of_line(content, form.first)
    end = _end_of_rows(content, begin)
    last = _begin_of_last_line(content, begin, end)
    is_whole = content[end : end + 2].strip(b"\0") != b""
    is_cut = last > begin and _is_cut(content[max(begin, last - TAIL) : last], content[last:end], is_whole, form)
    rows = memoryview(content)[begin : last if is_cut else end]
    places = RowPlaces(file, form.first + 1)
    if not len(rows):
        raise ValueError(Text("signals-no-rows", file=file))
    table = _read_fast(rows, form, choice, content, places) or _read_by_lines(rows, form, choice, places)
    if is_cut and table.note is None:  # no further table begins below
        line = form.first + 1 + bytes(memoryview(content)[begin:last]).count(b"\n")
        table = table.with_note(Text("signals-line-cut", place=places.line(line)))
    return _without_unused(table, form, choice, only)


def _choice(form: TableForm, file: str, text: Collection[str], only: Collection[str] | None) -> ChosenColumns:
    """Return which columns are read: those of `only`, or all that have a name and hold values."""
    names = form.names
    header = form.header_place(file)
    late: list[int] = []
    wanted = [index for index, name in enumerate(names) if name and (only is None or name in only)]
    if not wanted:
        there = listed([name for name in names if name])
        raise ValueError(Text("signals-columns-missing", place=header, names=listed(sorted(only or ())), there=there))
    if only is None:
        after = next(index for index, name in enumerate(names) if name)  # those in front are indices
        for index, name in enumerate(names[:-1]):
            if index > after and not name and form.kinds[index] in {"number", "moment"}:
                raise ValueError(Text("signals-column-unnamed", place=header, number=index + 1))
        values = [index for index in wanted if form.kinds[index] != "text" or names[index] in text]
        late = [index for index in values if form.kinds[index] == "empty" and names[index] not in text]
        wanted = values if len(values) > 1 else wanted  # a table of words alone is refused at the first of them
    twins = [names[index] for index in wanted if names.count(names[index]) > 1]
    if twins and only is not None:
        raise ValueError(Text("signals-columns-twice", place=header, column=quoted(twins[0])))
    texts = [index for index in wanted if names[index] in text]
    moments = [index for index in wanted if form.kinds[index] == "moment" and index not in texts]
    numbers = [index for index in wanted if index not in {*texts, *moments, *late}]
    return ChosenColumns(tuple(numbers), tuple(moments), tuple(texts), tuple(late))


def _content_of(path: Path, encoding: str) -> "bytes | mmap.mmap":
    """Return the content of a file in UTF-8."""
    with path.open("rb") as file:
        if encoding in {UTF_8, "utf-8-sig"}:
            return mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        return file.read().decode(encoding, "replace").encode()


def _offset_of_line(content: "bytes | mmap.mmap", line: int) -> int:
    """Return where a line begins; the end of the content when there is no such line."""
    at = 0
    for _ in range(line):
        at = content.find(b"\n", at) + 1
        if at == 0:
            return len(content)
    return at


def _end_of_rows(content: "bytes | mmap.mmap", begin: int) -> int:
    """Return where the last line ends, without blank lines and zeros behind it."""
    end = len(content)
    while end > begin:
        tail = content[max(begin, end - TAIL) : end]
        kept = len(tail.rstrip(ENDS))
        end -= len(tail) - kept
        if kept:
            break
    return end


def _begin_of_last_line(content: "bytes | mmap.mmap", begin: int, end: int) -> int:
    return max(content.rfind(b"\n", begin, end) + 1, begin)


def _is_cut(above: bytes, line: bytes, has_end: bool, form: TableForm) -> bool:
    """Return whether a logger was switched off in the last line: it has fewer cells than a row.

    Without the end of a line, its last number is also cut when it has fewer decimals than each of those above.
    """
    text = line.decode(UTF_8, "replace").rstrip("\r")
    if is_comment(text):
        return False
    try:
        cells = cells_of(text, form.dialect.separator)
        before = [cells_of(each, form.dialect.separator) for each in above.decode(UTF_8, "replace").split("\n")[1:-1]]
    except csv.Error:
        return True
    if len(cells) < len(form.kinds) or has_end:
        return len(cells) < len(form.kinds)
    decimals = [_decimals_of(row[-1], form.dialect.decimal) for row in before[-COMPARED:] if len(row) == len(cells)]
    return len(decimals) >= FEWEST_COMPARED and _decimals_of(cells[-1], form.dialect.decimal) < min(decimals)


def _decimals_of(cell: str, decimal: str) -> int:
    """Return how many digits stand behind the decimal sign."""
    return len(cell.strip().partition(decimal)[2])


def _read_fast(
    rows: memoryview, form: TableForm, choice: ChosenColumns, content: "bytes | mmap.mmap", places: RowPlaces
) -> FileTable | None:
    """Return the table as pyarrow reads it; None when it does not."""
    import pyarrow as pa

    if form.dialect.separator == BLANKS:
        return None
    for decimal in _decimals(form, content):
        try:
            read = _read_by_pyarrow(rows, form, choice, decimal)
        except pa.ArrowException:
            continue
        arrays: dict[int, NDArray[np.generic]] = {
            index: read.column(str(index)).to_numpy().astype(np.float64, copy=False) for index in choice.numbers
        }
        texts = {index: read.column(str(index)).to_pylist() for index in choice.as_text}
        return _table(form._replace(dialect=form.dialect._replace(decimal=decimal)), choice, arrays, texts, places)
    return None


def _decimals(form: TableForm, content: "bytes | mmap.mmap") -> tuple[str, ...]:
    """Return the decimal signs to try, that of the first rows first: a comma may come late, or be part of a text."""
    decimal, separator = form.dialect[:2]
    if separator == "," or content.find(b",", _offset_of_line(content, form.first)) < 0:
        return (decimal,)
    return (decimal, "." if decimal == "," else ",")


def _read_by_pyarrow(rows: memoryview, form: TableForm, choice: ChosenColumns, decimal: str) -> "pa.Table":
    import pyarrow as pa
    import pyarrow.csv as pa_csv

    names = [str(index) for index in range(len(form.kinds))]
    types = {str(index): pa.float64() for index in choice.numbers}
    types |= {str(index): pa.string() for index in choice.as_text}
    return pa_csv.read_csv(
        pa.BufferReader(pa.py_buffer(rows)),
        read_options=pa_csv.ReadOptions(column_names=names),
        parse_options=pa_csv.ParseOptions(delimiter=form.dialect.separator),
        convert_options=pa_csv.ConvertOptions(
            column_types=types,
            include_columns=[str(index) for index in choice.all],
            null_values=SPELLINGS,
            strings_can_be_null=False,
            decimal_point=decimal,
        ),
    )


def _read_by_lines(rows: memoryview, form: TableForm, choice: ChosenColumns, places: RowPlaces) -> FileTable:
    """Return the table, read cell by cell; raise ValueError with the first line that is wrong."""
    decimals = {form.dialect.decimal: None} | ({} if form.dialect.separator == "," else {",": None, ".": None})
    wrong: list[ValueError] = []
    for decimal in decimals:
        try:
            return _rows_by_lines(rows, form, choice, decimal, places)
        except ValueError as error:
            wrong.append(error)
    raise wrong[0]


def _rows_by_lines(
    rows: memoryview, form: TableForm, choice: ChosenColumns, decimal: str, places: RowPlaces
) -> FileTable:
    numbers = {index: array("d") for index in choice.numbers}
    texts: dict[int, list[str]] = {index: [] for index in choice.as_text}
    lines: list[int] = []
    further: list[int] = []
    for line, cells in _cells_by_lines(rows, form, places, further):
        for index, column in numbers.items():
            number = number_of(cells[index], decimal)
            if number is None and not is_missing(cells[index]):
                place = places.line(line)
                name, cell = form.names[index], quoted(cells[index])
                raise ValueError(Text("signals-not-a-number", place=place, column=name, cell=cell))
            column.append(np.nan if number is None else number)
        for index, words in texts.items():
            words.append(cells[index])
        lines.append(line)
    if not lines:
        raise ValueError(Text("signals-no-rows", file=places.file))
    arrays: dict[int, NDArray[np.generic]] = {index: np.array(column) for index, column in numbers.items()}
    form = form._replace(dialect=form.dialect._replace(decimal=decimal))
    table = _table(form, choice, arrays, texts, places._replace(lines=lines))
    return table.with_note(Text("signals-table-further", place=places.line(further[0]))) if further else table


def _cells_by_lines(
    rows: memoryview, form: TableForm, places: RowPlaces, further: list[int]
) -> Iterator[tuple[int, list[str]]]:
    """Yield line (from 1) and cells of each row, without comments, blank lines and headers that stand there again.

    The rows end where another table begins, with two lines or more that are none of this one below a blank line; the
    first of them is added to `further`.
    """
    try:
        text = bytes(rows).decode(UTF_8)
    except UnicodeDecodeError:
        text = bytes(rows).decode("latin-1")
    width, separator = len(form.kinds), form.dialect.separator
    again = [name.strip() for name in form.names if name]
    first = places.first_line or 1
    every = text.split("\n")
    for line, words in enumerate(every, start=first):
        if not words.strip() or (is_comment(words) and not is_missing(words.split(separator)[0])):
            continue
        if "\0" in words:
            raise ValueError(Text("signals-no-csv", file=places.file))
        try:
            cells = cells_of(words.rstrip("\r"), separator)
        except csv.Error as error:
            raise ValueError(Text("signals-no-csv", file=places.file)) from error
        if not any(cells) or [cell for cell in cells if cell] == again:
            continue
        while len(cells) > width and (not cells[-1] or cells[-1].startswith(REMARK)):
            cells.pop()
        if len(cells) != width and _begins_another_table(every, line - first, width, separator):
            further.append(line)
            return
        if len(cells) != width:
            place = places.line(line)
            raise ValueError(Text("signals-cells", place=place, count=len(cells), expected=width))
        yield line, cells


def _begins_another_table(every: Sequence[str], at: int, width: int, separator: str) -> bool:
    """Return whether a line and the next are no rows of `width` cells (a title, a sample rate), below a blank line."""
    if not 0 < at < len(every) - 1 or every[at - 1].strip(f"\r\t {separator}"):
        return False
    try:
        return all(len(cells_of(line, separator)) != width for line in every[at : at + 2])
    except csv.Error:
        return False


def _table(
    form: TableForm,
    choice: ChosenColumns,
    arrays: dict[int, NDArray[np.generic]],
    texts: dict[int, list[str]],
    places: RowPlaces,
) -> FileTable:
    """Return the table of columns by their names; the second of two equal names has its index behind it."""
    read = dict(arrays)
    read |= {index: seconds_of_moments(texts[index]) for index in choice.moments}
    read |= {index: np.array([cell.strip() for cell in texts[index]], np.str_) for index in choice.texts}
    late = {index: _numbers_of(texts[index], form.dialect.decimal) for index in choice.late}
    read |= {index: numbers for index, numbers in late.items() if numbers is not None}
    columns: Columns = {}
    units: dict[str, str] = {}
    for index in choice.all:
        if index not in read:
            continue
        name = form.names[index]
        name = f"{name} ({index + 1})" if name in columns else name
        columns[name] = read[index]
        if unit := "s" if index in choice.moments else form.units[index]:
            units[name] = unit
    return FileTable(columns, units, places, form.dialect, rate=form.rate).without_empty_rows()


def _numbers_of(cells: Sequence[str], decimal: str) -> NDArray[np.float64] | None:
    """Return the numbers in cells (n,), of which the first ones are empty, missing ones as NaN; None for words."""
    numbers = [np.nan if is_missing(cell) else number_of(cell, decimal) for cell in cells]
    return None if None in numbers else np.array(numbers, np.float64)


def _without_unused(
    table: FileTable, form: TableForm, choice: ChosenColumns, only: Collection[str] | None
) -> FileTable:
    """Return the table without unused columns of one name: each holds one value; others of one name are refused."""
    if only is not None:
        return table
    left_out = [name for name, kind in zip(form.names, form.kinds, strict=True) if name and kind == "text"]
    left_out += [form.names[index] for index in choice.late]
    columns = dict(table.columns)
    chosen = [form.names[index] for index in choice.all]
    for name in {name for name in chosen if chosen.count(name) > 1}:
        twins = [name, *(f"{name} ({index + 1})" for index in choice.all if form.names[index] == name)]
        twins = [twin for twin in twins if twin in columns]
        if any(_holds_several(columns[twin]) for twin in twins):
            header = form.header_place(table.places.file)
            raise ValueError(Text("signals-columns-twice", place=header, column=quoted(name)))
        left_out.append(name)
        columns = {twin: values for twin, values in columns.items() if twin not in twins}
    left_out = [name for name in dict.fromkeys(left_out) if name not in columns]
    if not left_out:
        return table
    return replace(table, columns=columns).with_note(Text("signals-columns-left-out", names=listed(left_out)))


def _holds_several(values: NDArray[Any]) -> bool:
    """Return whether numbers (n,) differ."""
    numbers = values[~np.isnan(values)]
    return len(numbers) > 0 and bool(np.ptp(numbers) > 0)
