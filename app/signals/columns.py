"""Reads the columns of a CSV or Parquet file, and describes in one sentence what is wrong with an invalid file."""

import csv
from collections.abc import Collection
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.signals.csv_dialect import Dialect, cells_of, decimals_to_try, separator_of

if TYPE_CHECKING:
    import pyarrow as pa

Table = dict[str, NDArray[np.generic]]

NOT_A_NUMBER = ("", "NaN", "nan", "NA", "N/A", "null", "NULL")  # cells that stand for a missing number
LONGEST_QUOTE = 30
MOST_NUMBERS = 200_000_000  # ten hours of 52 channels at 100 Hz
NO_ROWS = "{}: there is no row below the header, record again or name another file"
NOT_TEXT = "{}: this is not a CSV file but something binary or not in UTF-8, save it as CSV in UTF-8 or as Parquet"


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
        raise ValueError(f"{path}: there is no such file, check its name")
    if path.is_dir():
        raise ValueError(f"{path}: this is a folder, name a file in it")
    if not path.is_file():
        raise ValueError(f"{path}: this is a device or a pipe, name an ordinary file")
    try:
        table, dialect = (_read_parquet(path, only), None) if _is_parquet(path) else _read_csv(path, text, only)
    except OSError as error:
        raise ValueError(f"{path}: this file cannot be read ({error.strerror or error}), check it") from error
    if table.num_rows == 0:
        raise ValueError(NO_ROWS.format(path))
    arrays = {name: _as_array(path, name, table.column(i), text) for i, name in enumerate(table.column_names)}
    return Columns(arrays, dialect)


def require_column(table: Table, path: Path, name: str) -> NDArray[np.float64]:
    """Return a column (n,) of finite numbers; raise ValueError with the first line that has none."""
    if name not in table:
        raise ValueError(f"{path}: there is no column '{name}' (there are {_listed(list(table))}), add it")
    values = table[name].astype(np.float64)
    bad = np.flatnonzero(~np.isfinite(values))
    if len(bad):
        raise ValueError(f"{row_place(path, int(bad[0]))}: '{name}' has no number there, fill it in")
    return values


def row_place(path: Path, row: int) -> str:
    """Return the place of row `row` (from 0) as text: the line of a CSV file, the row of a Parquet file."""
    return f"{path}, row {row + 1}" if _is_parquet(path) else f"{path}, line {row + 2}"


def _is_parquet(path: Path) -> bool:
    return path.suffix.lower() == ".parquet"


def _read_parquet(path: Path, only: Collection[str] | None) -> "pa.Table":
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    try:
        described = pa_parquet.read_metadata(path)
        names = described.schema.to_arrow_schema().names
    except pa.ArrowException as error:
        raise ValueError(f"{path}: this is not a Parquet file, save it as one or give it the name of a CSV") from error
    _refuse_twins(str(path), names)
    columns = [name for name in names if only is None or name in only]
    if described.num_rows * len(columns) > MOST_NUMBERS:  # a small file may hold any number of equal, packed values
        raise ValueError(f"{path}: this holds more than {MOST_NUMBERS:,} numbers, cut it into shorter recordings")
    try:
        return pa_parquet.read_table(path, columns=columns)
    except pa.ArrowException as error:
        raise ValueError(f"{path}: this Parquet file was cut or changed and cannot be read, save it anew") from error


def _read_csv(path: Path, text: Collection[str], only: Collection[str] | None) -> tuple["pa.Table", Dialect]:
    import pyarrow as pa

    header, separator = _header(path)
    columns = [name for name in header if only is None or name in only]
    if not columns:
        raise ValueError(
            f"{path}, line 1: none of the columns {_listed(sorted(only or ()))} is there, only {_listed(header)}, "
            f"add them or name another file"
        )
    types = {name: pa.string() if name in text else pa.float64() for name in header}
    first_wrong = ""
    for decimal in decimals_to_try(path, separator):
        dialect = Dialect(separator, decimal)
        try:
            return _table_of_csv(path, header, types, columns, dialect), dialect
        except pa.ArrowException as error:
            if "Empty CSV" in str(error) or "Could not skip initial" in str(error):
                raise ValueError(NO_ROWS.format(path)) from error
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
        raise ValueError(f"{path}: this file is empty (or begins with an empty line), name another one")
    try:
        line = start.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(NOT_TEXT.format(path)) from error
    if "\0" in line:
        raise ValueError(NOT_TEXT.format(path))
    if "\r" in line.rstrip("\r\n"):
        raise ValueError(f"{path}: its lines end in carriage returns alone, save the file with other line ends")
    try:
        separator = separator_of(line)
        names = cells_of(line, separator)
    except csv.Error as error:
        raise ValueError(NOT_TEXT.format(path)) from error
    for column, name in enumerate(names, start=1):
        if not name:
            raise ValueError(f"{path}, line 1: column {column} has no name, give it one")
    _refuse_twins(f"{path}, line 1", names)
    return names, separator


def _refuse_twins(where: str, names: list[str]) -> None:
    for name in names:
        if names.count(name) > 1:
            raise ValueError(f"{where}: there are two columns '{_quoted(name)}', rename one of them")


def _what_is_wrong(path: Path, header: list[str], numeric: set[str], dialect: Dialect, otherwise: str) -> str:
    """Return one sentence on the first invalid line; slow, therefore called only after the fast reader has failed."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            lines = csv.reader(file, delimiter=dialect.separator)
            next(lines)
            for cells in lines:
                if not cells:
                    continue
                if len(cells) != len(header):
                    return (
                        f"{path}, line {lines.line_num}: {len(cells)} cells where the header has {len(header)}, "
                        f"correct or remove this line"
                    )
                for name, cell in zip(header, cells, strict=True):
                    if name in numeric and not _is_number(cell, dialect.decimal):
                        return (
                            f"{path}, line {lines.line_num}, column '{name}': '{_quoted(cell)}' is not a number, "
                            f"write one or leave the cell empty"
                        )
    except (UnicodeDecodeError, csv.Error):
        return NOT_TEXT.format(path)
    return f"{path}: this CSV file cannot be read ({otherwise.splitlines()[0]}), save it anew"


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
    raise ValueError(f"{path}: column '{name}' holds {column.type} and not numbers, leave it out or convert it")


def _listed(names: list[str], most: int = 6) -> str:
    return ", ".join(map(_quoted, names[:most])) + (f" and {len(names) - most} more" if len(names) > most else "")


def _quoted(text: str) -> str:
    return " ".join(text[:LONGEST_QUOTE].split()) + ("..." if len(text) > LONGEST_QUOTE else "")
