"""Reads a table from a Parquet file."""

from collections.abc import Collection
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from app.signals.file_table import Columns, FileTable, listed
from app.signals.row_places import places_of_rows
from app.texts import Text

if TYPE_CHECKING:
    import pyarrow as pa

MOST_NUMBERS: Final = 200_000_000  # ten hours of 52 channels at 100 Hz
FEWEST: Final = 2  # columns of numbers of a recording
UNIT: Final = b"unit"  # key of a column's metadata


def parquet_schema(path: Path) -> "pa.Schema":
    """Return the schema of a Parquet file; raise ValueError in one sentence when it is none."""
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    try:
        return pa_parquet.read_schema(path)
    except pa.ArrowException as error:
        raise ValueError(Text("signals-no-parquet", file=str(path))) from error


def read_parquet_table(path: Path, text: Collection[str], only: Collection[str] | None) -> FileTable:
    """Return the table of a Parquet file; parameters and errors as of `app.signals.columns.read_table`."""
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    schema = parquet_schema(path)
    names = schema.names
    for name in names:
        if names.count(name) > 1:
            raise ValueError(Text("signals-columns-twice", place=str(path), column=name))
    words = columns_of_words(schema) - set(text) if only is None else frozenset()
    if len(names) - len(words) < FEWEST:
        words = frozenset()  # a table of words is refused at the first of them
    columns = [name for name in names if name not in words and (only is None or name in only)]
    if not columns and only:
        raise ValueError(
            Text("signals-columns-missing", place=str(path), names=listed(sorted(only)), there=listed(names))
        )
    try:
        if pa_parquet.read_metadata(path).num_rows * len(columns) > MOST_NUMBERS:  # equal values are packed
            raise ValueError(Text("signals-numbers", file=str(path), most=MOST_NUMBERS))
        table = pa_parquet.read_table(path, columns=columns)
    except pa.ArrowException as error:
        raise ValueError(Text("signals-parquet-damaged", file=str(path))) from error
    if table.num_rows == 0:
        raise ValueError(Text("signals-no-rows", file=str(path)))
    read: Columns = {name: _as_array(path, name, table.column(name), text) for name in columns}
    whole = FileTable(read, units_of_schema(schema), places_of_rows(path)).without_empty_rows()
    left_out = listed([name for name in names if name in words])
    return whole.with_note(Text("signals-columns-left-out", names=left_out)) if words else whole


def columns_of_words(schema: "pa.Schema") -> frozenset[str]:
    """Return the columns that hold something else than numbers, moments or durations."""
    return frozenset(field.name for field in schema if not _is_number(field.type))


def _is_number(kind: "pa.DataType") -> bool:
    from pyarrow import types

    return any(
        is_of(kind)
        for is_of in (
            *(types.is_floating, types.is_integer, types.is_boolean, types.is_decimal, types.is_null),
            *(types.is_timestamp, types.is_duration, types.is_time),
        )
    )


def units_of_schema(schema: "pa.Schema") -> dict[str, str]:
    """Return the units that the metadata of columns state; times by the calendar are in seconds."""
    import pyarrow as pa

    units = {field.name: field.metadata[UNIT].decode() for field in schema if field.metadata and UNIT in field.metadata}
    return units | {field.name: "s" for field in schema if pa.types.is_temporal(field.type)}


def _as_array(path: Path, name: str, column: Any, text: Collection[str]) -> NDArray[np.generic]:
    import pyarrow as pa

    if name in text:
        return np.array([str(cell).strip() for cell in column.to_pylist()], dtype=np.str_)
    if pa.types.is_null(column.type):
        return np.full(len(column), np.nan)
    if pa.types.is_boolean(column.type) or pa.types.is_decimal(column.type):
        column = column.cast(pa.int8() if pa.types.is_boolean(column.type) else pa.float64())
    if pa.types.is_floating(column.type) or pa.types.is_integer(column.type):
        array: NDArray[np.generic] = column.to_numpy()
        return array if array.dtype == np.float32 else array.astype(np.float64, copy=False)
    if pa.types.is_timestamp(column.type) or pa.types.is_duration(column.type) or pa.types.is_time(column.type):
        return _seconds(column)
    raise ValueError(Text("signals-column-type", file=str(path), column=name, kind=str(column.type)))


def _seconds(column: Any) -> NDArray[np.float64]:
    """Return moments, durations or times of day in s."""
    import pyarrow as pa

    per_second = {"s": 1.0, "ms": 1e3, "us": 1e6, "ns": 1e9}[column.type.unit]
    whole = pa.int32() if pa.types.is_time32(column.type) else pa.int64()
    counted: NDArray[np.generic] = column.cast(whole).to_numpy()
    return counted.astype(np.float64) / per_second
