"""A recording as one table with a column for each number: what CSV and Parquet files of an export hold."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from app.recording.format import PER_CHANNEL, PER_GESTURE, SCALARS
from app.recording.groups import RunGroups

if TYPE_CHECKING:
    import pyarrow as pa


def channel_names(meta: dict[str, Any]) -> list[str]:
    """Return the names of the shirt's channels, in the order of a frame's values."""
    return [str(channel["name"]) for channel in meta["layout"]["channels"]]


def gesture_names(meta: dict[str, Any]) -> list[str]:
    """Return the names of the gestures, in the order of the vocabulary."""
    return [str(name) for name in meta["gestures"]]


def flat_tables(run: RunGroups) -> Iterator["pa.Table"]:
    """Yield the rows of a run, group by group.

    The columns are the recorded scalars under their names, `score.NAME`, `rate.NAME` and `activation.NAME` for each
    gesture, and `values.NAME` for each channel. A number that was not measured is null.
    """
    import pyarrow as pa

    parts = {PER_CHANNEL: channel_names(run.meta), **{name: gesture_names(run.meta) for name in PER_GESTURE}}
    for columns in run.groups:
        arrays = {name: _array(columns[name]) for name in SCALARS}
        for name in (*PER_GESTURE, PER_CHANNEL):
            for place, part in enumerate(parts[name]):
                arrays[f"{name}.{part}"] = _array(columns[name][:, place])
        yield pa.table(arrays)


def _array(column: Any) -> Any:
    import pyarrow as pa

    column = np.ascontiguousarray(column)
    missing = np.isnan(column) if column.dtype.kind == "f" else None
    return pa.array(column, mask=missing)
