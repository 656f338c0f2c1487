"""What a file of signals holds: its columns with their units and ranges, its time, its sample rate, its channels."""

from collections.abc import Collection
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from app.layout import ShirtLayout
from app.signals.columns import NamedColumns, named_columns, read_table
from app.signals.csv_dialect import Dialect
from app.signals.file_table import Columns, FilePart, FileTable
from app.signals.signals import AS_THE_FILE_SAYS, NO_COLUMN, ReadingOptions, Signals, read_signals
from app.signals.time_columns import TimeColumn, is_counter, time_of_table
from app.signals.time_names import time_rank
from app.texts import Text, text_of

Role = Literal["time", "channel", "other-time", "counter", "text", "empty", "constant", "unused"]

DIGITS: Final = 6  # that count, of a range
RECORDING_KIND: Final = "bodydrive"  # a run's folder


@dataclass(frozen=True, slots=True)
class ColumnOverview:
    """One column of a file."""

    name: str
    unit: str  # empty where the file says none
    role: Role
    least: float | None  # of its numbers, None without one
    most: float | None
    missing: float | None  # share of its rows; None where it was not read


@dataclass(frozen=True, slots=True)
class FileOverview:
    """What a file holds, and how it would be read."""

    kind: str  # of the file, "CSV" for all tables in text
    parts: tuple[FilePart, ...]  # of which one can be read alone; empty where there is one table
    rows: int | None
    columns: tuple[ColumnOverview, ...]
    dialect: Dialect | None  # of a table in text
    time: str | None  # the column of times
    unit: str | None  # of the time
    is_stated: bool  # whether the file, or a person, says the unit
    signals: Signals | None  # None where a person must correct something first
    problem: Text | str | None  # what that is


def overview(path: Path, layout: ShirtLayout | None = None, options: ReadingOptions = AS_THE_FILE_SAYS) -> FileOverview:
    """Return what a file or a run's folder holds; raise ValueError with one sentence when it cannot be read at all."""
    if path.is_dir():
        return _of_recording(read_signals(path, layout))
    named = named_columns(path, options.part)
    problem: Text | str | None = None
    signals: Signals | None = None
    time: TimeColumn | None = None
    table: FileTable | None = None
    try:
        signals = read_signals(path, layout, options)
    except ValueError as error:
        problem = text_of(error)
    with suppress(ValueError):  # of a column that nobody has chosen; a sample rate alone can say the times
        table = read_table(path, part=options.part)
        time = None if options.time == NO_COLUMN else time_of_table(table, options.time, options.unit)
    channels = () if signals is None else signals.channel_names
    columns = _columns_of(signals) if table is None else table.columns
    facts = [
        _column(name, named, columns.get(name), None if time is None else time.column, channels) for name in named.names
    ]
    return FileOverview(
        kind=named.kind,
        parts=named.parts,
        rows=max(map(len, columns.values()), default=None),
        columns=tuple(facts),
        dialect=None if table is None else table.dialect,
        time=None if time is None else time.column,
        unit=None if time is None else time.unit,
        is_stated=time is not None and time.is_stated,
        signals=signals,
        problem=problem,
    )


def _columns_of(signals: Signals | None) -> Columns:
    """Return the columns of the channels."""
    return {} if signals is None else dict(zip(signals.channel_names, signals.values.T, strict=True))


def _of_recording(signals: Signals) -> FileOverview:
    columns = [
        ColumnOverview(name, "", "channel", *_range_of(signals.values[:, index]))
        for index, name in enumerate(signals.channel_names)
    ]
    return FileOverview(RECORDING_KIND, (), len(signals.t), tuple(columns), None, "t", "s", True, signals, None)


def _column(
    name: str, named: NamedColumns, values: NDArray[np.generic] | None, time: str | None, channels: Collection[str]
) -> ColumnOverview:
    unit = named.units.get(name, "")
    if values is None:
        return ColumnOverview(name, unit, "text" if name in named.texts else "unused", None, None, None)
    least, most, missing = _range_of(values)
    role: Role = "unused" if channels else "channel"
    if name == time:
        role = "time"
    elif name in channels:
        role = "channel"
    elif least is None:
        role = "empty"
    elif is_counter(name, values):
        role = "counter"
    elif time_rank(name) is not None:
        role = "other-time"
    elif least == most:
        role = "constant"
    return ColumnOverview(name, unit, role, least, most, missing)


def _range_of(column: NDArray[np.generic]) -> tuple[float | None, float | None, float]:
    """Return the least and the greatest number of a column (n,), and the share of its rows without one."""
    values = column.astype(np.float64, copy=False)
    numbers = values[np.isfinite(values)]
    missing = 1.0 - len(numbers) / len(values)
    if not len(numbers):
        return None, None, missing
    return _rounded(float(numbers.min())), _rounded(float(numbers.max())), missing


def _rounded(number: float) -> float:
    return float(f"{number:.{DIGITS}g}")
