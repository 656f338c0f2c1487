"""Reads a table with its times, for all that is no shirt: movements of a body or a head, trajectories."""

from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.signals.column_names import columns_of_channels
from app.signals.columns import named_columns, read_table
from app.signals.file_table import FileTable
from app.signals.time_columns import time_of_table
from app.signals.time_names import time_names


def read_timed(
    path: Path, only: Collection[str] | None = None, time: str | None = None, unit: str | None = None
) -> tuple[NDArray[np.float64], FileTable]:
    """Return the times (n,) in s and the table of a file, of the columns `only` where they are given.

    A column that is called otherwise (`x [m]`) is found as that of a channel is. `time` and `unit` correct which column
    is the time, and in which unit it is.

    Raises
    ------
    ValueError
        One sentence that names the file, the line or column, and what to do.
    """
    names = named_columns(path).names
    times = [time] if time is not None else time_names(names)
    if only is None:
        table = read_table(path)
        return time_of_table(table, time, unit).t, table
    columns = columns_of_channels(list(only), [name for name in names if name not in times])
    table = read_table(path, only={*times, *columns.values()} if times else None)
    t = time_of_table(table, time, unit, columns.values()).t
    wanted = {name: table.columns[column] for name, column in columns.items() if column in table.columns}
    return t, replace(table, columns=wanted)
