"""Tables in which each signal has its own column of times, because its sample rate is another (Delsys).

`X [s],EMG 1 [mV],X [s],ACC X [g],ACC Y [g]`: a column of times counts for those up to the next one. The signals with
fewer samples end earlier.
"""

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.signals.column_names import bare_name
from app.signals.file_table import FileTable
from app.signals.foreign.recording import SampledStream, joined
from app.signals.time_names import SECONDS, time_rank, unit_of_word
from app.texts import Text


def time_groups(names: Sequence[str], units: Sequence[str]) -> tuple[int, ...]:
    """Return the columns of times when there are several, each in front of its signals; none otherwise."""
    times = [index for index, unit in enumerate(units) if unit_of_word(unit) is not None]
    groups = [names[begin + 1 : end] for begin, end in pairwise([*times, len(names)])]
    if len(times) < 2 or times[0] != 0 or any(all(time_rank(name) is not None for name in each) for each in groups):
        return ()
    bare = {bare_name(names[index])[0].casefold() for index in times}
    is_one_name = len(bare) == 1 or all(time_rank(names[index]) is not None for index in times)
    return tuple(times) if is_one_name else ()


def joined_groups(table: FileTable, times: Collection[str]) -> FileTable:
    """Return the table at the times of the group with the most samples; `times` are the names of the columns of times.

    The other signals have their newest sample there, as `app.signals.foreign.recording.joined` says.

    Raises
    ------
    ValueError
        One sentence when no column of times has any.
    """
    names = list(table.columns)
    begins = [index for index, name in enumerate(names) if name in times]
    groups = [names[begin:end] for begin, end in pairwise([*begins, len(names)])]
    streams = [_stream(table, time, channels) for time, *channels in groups if channels]
    if not any(len(stream.t) for stream in streams):
        raise ValueError(Text("signals-no-rows", file=table.places.file))
    recording = joined([stream for stream in streams if len(stream.t)])
    return replace(table, columns=dict(recording.columns), units=recording.units)


def _stream(table: FileTable, time: str, channels: Sequence[str]) -> SampledStream:
    t = table.columns[time].astype(np.float64) * SECONDS[unit_of_word(table.units[time]) or "s"]
    count = _count_of_samples(t)
    values = np.column_stack([table.columns[name].astype(np.float64) for name in channels])[:count]
    return SampledStream("", t[:count], values, channels, [table.units.get(name, "") for name in channels])


def _count_of_samples(t: NDArray[np.float64]) -> int:
    """Return up to which row times (n,) rise: below the last sample there is nothing, or zeros."""
    ends = np.flatnonzero(~np.isfinite(t) | (np.diff(t, prepend=-np.inf) < 0))
    return int(ends[0]) if len(ends) else len(t)
