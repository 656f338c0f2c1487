"""Reads the columns of a CSV or Parquet file, and describes in one sentence what is wrong with an invalid file."""

import csv
from collections.abc import Collection
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.signals.csv_dialect import Dialect, cells_of, decimals_to_try, separator_of
from app.texts import Text

if TYPE_CHECKING:
    import pyarrow as pa

Table = dict[str, NDArray[np.generic]]

NOT_A_NUMBER = ("", "NaN", "nan", "NA", "N/A", "null", "NULL")  # cells that stand for a missing number
LONGEST_QUOTE = 30
MOST_NUMBERS = 200_000_000  # ten hours of 52 channels at 100 Hz


class Columns(NamedTuple):
    """The columns of a file, and the dialect of a CSV file."""

    table: Table
    dialect: Dialect | None  # None for Parquet


def read_columns(path: Path, text: Collection[str] = (), only: Collection[str] | None = None) -> Table:
    """Return the columns of a CSV or Parquet file by name; parameters and errors as of `read_columns_and_dialect`."""
    return read_columns_and_dialect(path, text, only).table


def read_columns_and_dialect(path: Path, text: Collection[str] = (), only: Collection[str] | None = None) -> Columns:
    """Read the columns of a CSV or Parquet file by name: float64 or float32 (n,), missing numbers as NaN.

    A CSV file has commas, semicolons or tabs between its columns, and points or commas in its numbers. Columns named in
    `text` are read as text. Of the others, those named in `only` are read (all when None); names that the file does not
    have are not in the answer. A file that ends in `.parquet` is Parquet, any other is CSV.

    Raises
    ------
    ValueError
        One sentence that names the file, the line and column, and what to do.
    """
    if not path.exists():
        raise ValueError(Text("signals-file-missing", file=str(path)))
    if path.is_dir():
        raise ValueError(Text("signals-folder", file=str(path)))
    if not path.is_file():
        raise ValueError(Text("signals-device", file=str(path)))
    try:
        table, dialect = (_read_parquet(path, only), None) if _is_parquet(path) else _read_csv(path, text, only)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("signals-file-unreadable", file=str(path), reason=reason)) from error
    if table.num_rows == 0:
        raise ValueError(Text("signals-no-rows", file=str(path)))
    arrays = {name: _as_array(path, name, table.column(i), text) for i, name in enumerate(table.column_names)}
    return Columns(arrays, dialect)


def require_column(table: Table, path: Path, name: str) -> NDArray[np.float64]:
    """Return a column (n,) of finite numbers; raise ValueError with the first line that has none."""
    if name not in table:
        raise ValueError(Text("signals-column-missing", file=str(path), column=name, names=listed(list(table))))
    values = table[name].astype(np.float64)
    bad = np.flatnonzero(~np.isfinite(values))
    if len(bad):
        raise ValueError(Text("signals-no-number", place=row_place(path, int(bad[0])), column=name))
    return values


def row_place(path: Path, row: int) -> Text:
    """Return the place of row `row` (from 0): the line of a CSV file, the row of a Parquet file."""
    return Text("signals-row", file=str(path), row=row + 1) if _is_parquet(path) else _line_place(path, row + 2)


def _line_place(path: Path, line: int) -> Text:
    return Text("signals-line", file=str(path), line=line)


def _is_parquet(path: Path) -> bool:
    return path.suffix.lower() == ".parquet"


def _read_parquet(path: Path, only: Collection[str] | None) -> "pa.Table":
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    try:
        described = pa_parquet.read_metadata(path)
        names = described.schema.to_arrow_schema().names
    except pa.ArrowException as error:
        raise ValueError(Text("signals-no-parquet", file=str(path))) from error
    _refuse_twins(str(path), names)
    columns = [name for name in names if only is None or name in only]
    if described.num_rows * len(columns) > MOST_NUMBERS:  # a small file may hold any number of equal, packed values
        raise ValueError(Text("signals-numbers", file=str(path), most=MOST_NUMBERS))
    try:
        return pa_parquet.read_table(path, columns=columns)
    except pa.ArrowException as error:
        raise ValueError(Text("signals-parquet-damaged", file=str(path))) from error


def _read_csv(path: Path, text: Collection[str], only: Collection[str] | None) -> tuple["pa.Table", Dialect]:
    import pyarrow as pa

    header, separator = _header(path)
    columns = [name for name in header if only is None or name in only]
    if not columns:
        wanted, there = listed(sorted(only or ())), listed(header)
        raise ValueError(Text("signals-columns-missing", place=_line_place(path, 1), names=wanted, there=there))
    types = {name: pa.string() if name in text else pa.float64() for name in header}
    first_wrong: Text | None = None
    for decimal in decimals_to_try(path, separator):
        dialect = Dialect(separator, decimal)
        try:
            return _table_of_csv(path, header, types, columns, dialect), dialect
        except pa.ArrowException as error:
            if "Empty CSV" in str(error) or "Could not skip initial" in str(error):
                raise ValueError(Text("signals-no-rows", file=str(path))) from error
            first_wrong = first_wrong or _what_is_wrong(path, header, set(columns) - set(text), dialect, str(error))
    raise ValueError(first_wrong)


def _table_of_csv(
    path: Path, header: list[str], types: dict[str, "pa.DataType"], columns: list[str], dialect: Dialect
) -> "pa.Table":
    import pyarrow.csv as pa_csv

    return pa_csv.read_csv(
        path,
        read_options=pa_csv.ReadOptions(column_names=header, skip_rows=1),
        parse_options=pa_csv.ParseOptions(delimiter=dialect.separator),
        convert_options=pa_csv.ConvertOptions(
            column_types=types,
            include_columns=columns,
            null_values=list(NOT_A_NUMBER),
            strings_can_be_null=False,
            decimal_point=dialect.decimal,
        ),
    )


def _header(path: Path) -> tuple[list[str], str]:
    """Return the trimmed names in the first line and their separator; raise ValueError when it is no header."""
    with path.open("rb") as file:
        start = file.readline(100_000)
    if not start.strip():
        raise ValueError(Text("signals-empty", file=str(path)))
    try:
        line = start.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(Text("signals-no-csv", file=str(path))) from error
    if "\0" in line:
        raise ValueError(Text("signals-no-csv", file=str(path)))
    if "\r" in line.rstrip("\r\n"):
        raise ValueError(Text("signals-line-ends", file=str(path)))
    try:
        separator = separator_of(line)
        names = cells_of(line, separator)
    except csv.Error as error:
        raise ValueError(Text("signals-no-csv", file=str(path))) from error
    for column, name in enumerate(names, start=1):
        if not name:
            raise ValueError(Text("signals-column-unnamed", place=_line_place(path, 1), number=column))
    _refuse_twins(_line_place(path, 1), names)
    return names, separator


def _refuse_twins(place: Text | str, names: list[str]) -> None:
    for name in names:
        if names.count(name) > 1:
            raise ValueError(Text("signals-columns-twice", place=place, column=_quoted(name)))


def _what_is_wrong(path: Path, header: list[str], numeric: set[str], dialect: Dialect, otherwise: str) -> Text:
    """Return one sentence on the first invalid line; slow, therefore called only after the fast reader has failed."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            lines = csv.reader(file, delimiter=dialect.separator)
            next(lines)
            for cells in lines:
                if not cells:
                    continue
                if len(cells) != len(header):
                    place = _line_place(path, lines.line_num)
                    return Text("signals-cells", place=place, count=len(cells), expected=len(header))
                for name, cell in zip(header, cells, strict=True):
                    if name in numeric and not _is_number(cell, dialect.decimal):
                        place = _line_place(path, lines.line_num)
                        return Text("signals-not-a-number", place=place, column=name, cell=_quoted(cell))
    except (UnicodeDecodeError, csv.Error):
        return Text("signals-no-csv", file=str(path))
    return Text("signals-csv-unreadable", file=str(path), reason=otherwise.splitlines()[0])


def _is_number(cell: str, decimal: str) -> bool:
    if cell in NOT_A_NUMBER:
        return True
    if decimal == "," and "." in cell:
        return False
    try:
        float(cell.replace(decimal, "."))
    except ValueError:
        return False
    return cell.isascii() and "_" not in cell


def _as_array(path: Path, name: str, column: Any, text: Collection[str]) -> NDArray[np.generic]:
    import pyarrow as pa

    if name in text:
        return np.array([str(cell).strip() for cell in column.to_pylist()], dtype=np.str_)
    if pa.types.is_null(column.type):
        return np.full(len(column), np.nan)
    if pa.types.is_floating(column.type) or pa.types.is_integer(column.type):
        array: NDArray[np.generic] = column.to_numpy()
        return array if array.dtype == np.float32 else array.astype(np.float64, copy=False)
    raise ValueError(Text("signals-column-type", file=str(path), column=name, kind=str(column.type)))


def listed(names: list[str], most: int = 6) -> Text | str:
    """Return the first names, and how many more there are."""
    first = ", ".join(map(_quoted, names[:most]))
    return Text("signals-names-more", names=first, count=len(names) - most) if len(names) > most else first


def _quoted(text: str) -> str:
    return " ".join(text[:LONGEST_QUOTE].split()) + ("..." if len(text) > LONGEST_QUOTE else "")
