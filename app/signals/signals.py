"""Reads a shirt's signals from a file, or from a recorded run."""

import json
from codecs import BOM_UTF8
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import reduce
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from app.layout import MAX_CHANNELS, ShirtLayout
from app.recording.reader import RunRecording, both, read_run
from app.sentences import one_sentence
from app.signals.column_names import bare_name, columns_of_channels
from app.signals.columns import NamedColumns, named_columns, read_table
from app.signals.csv_dialect import Dialect
from app.signals.file_table import Columns, FileTable, listed
from app.signals.row_places import places_of_rows
from app.signals.sampling_times import (
    FASTEST,
    SLOWEST,
    SamplingTimes,
    TimeSource,
    refuse_falling_times,
    sampling_times,
    strictly_rising,
)
from app.signals.time_columns import TimeColumn, is_channel, sentence_of_time, time_of_table
from app.signals.time_names import time_names
from app.texts import Text, text_of

NO_COLUMN = ""  # in place of the name of a column of times
SHORTEST = 10  # samples
LONGEST_PAIR = 80  # letters of a channel and its column
RATE_TOLERANCE = 0.1  # share by which the times of a file may differ from a sample rate that a person or the file gives
# Refusals that the sample rate answers which the file states: of unknown times, and of times of arrival.
NO_TIME = frozenset(("signals-time-missing", "signals-time-units"))
ARRIVAL = frozenset(("signals-uneven", "signals-shared-uneven", "signals-bursts-uneven"))
ROWS_AT_ONCE = 4096
LARGEST = 1e10  # no sensor gives more; sums of such values do not overflow float32, nor the limits of a profile


@dataclass(slots=True)
class Signals:
    """The values of all channels over time, one row per frame."""

    t: NDArray[np.float64]  # (n,) s, strictly rising
    values: NDArray[np.float64] | NDArray[np.float32]  # (n, n_channels), NaN where a sample is missing
    channel_names: list[str]
    sample_rate: float  # Hz
    t_device: NDArray[np.float64] | None = None  # (n,) s on the shirt's own clock, where a recording has it
    damage: Text | None = None  # what is damaged or missing in the recording, or was mended
    dialect: Dialect | None = None  # of a CSV file

    def between(self, start: float | None, end: float | None) -> slice:
        """Return the rows with `start` <= t < `end` (s); None means the recording's start or end."""
        first = 0 if start is None else int(np.searchsorted(self.t, start, side="left"))
        last = len(self.t) if end is None else int(np.searchsorted(self.t, end, side="left"))
        return slice(first, last)


@dataclass(frozen=True, slots=True)
class ReadingOptions:
    """How a person corrects what a file says of itself; None: as the file says."""

    time: str | None = None  # the column of times; empty: none is right, and the sample rate counts
    unit: str | None = None  # of it, a key of `app.signals.time_columns.SECONDS`
    rate: float | None = None  # Hz; the samples are even
    channels: tuple[str, ...] | None = None  # the columns of the channels, in their order
    part: str | None = None  # of the file, that is read alone: a stream, or a sheet


AS_THE_FILE_SAYS = ReadingOptions()


def read_signals(
    path: str | Path, layout: ShirtLayout | None = None, options: ReadingOptions = AS_THE_FILE_SAYS
) -> Signals:
    """Read the signals of a file or of a run's folder: the layout's channels in its order, else all columns of numbers.

    The columns of times are no channels. A column is a channel of the layout by its name, apart from a unit, or by the
    last words of it.

    Raises
    ------
    ValueError
        One sentence that names the file, the line or column, and what to do.
    """
    path = Path(path)
    if path.is_dir():
        return signals_of_run(read_run(path), path, layout)
    named = named_columns(path, options.part)
    times = _times_beside(path, named.names, layout, options)
    chosen = _chosen_columns(path, named, times, layout, options)
    only = None if chosen is None or not times else {*times, *chosen.values()}
    table = read_table(path, only=only, part=options.part)
    time = _time(table, options, () if chosen is None else chosen.values())
    if chosen is None:
        numbers = {name: values for name, values in table.columns.items() if time is None or name != time.column}
        chosen = {name: name for name, values in numbers.items() if is_channel(name, values)}
    if layout is not None and (missing := [name for name in layout.channel_names if name not in chosen]):
        raise ValueError(_missing(path, missing, layout))
    if not chosen:
        raise ValueError(Text("signals-no-channel", file=str(path), column=time.column if time else "t"))
    if layout is None and len(chosen) > MAX_CHANNELS:
        raise ValueError(Text("signals-channels", file=str(path), count=len(chosen), most=MAX_CHANNELS))
    count = len(next(iter(table.columns.values())))
    if count < SHORTEST:
        raise ValueError(Text("signals-samples-few", file=str(path), count=count))
    even = _sampling_times(table, time, options.rate, count)
    said = [table.note, None if time is None else sentence_of_time(time), _sentence_of_channels(chosen), even.note]
    values = _stack_columns(table.columns, list(chosen.values()))
    return Signals(even.t, values, list(chosen), even.sample_rate, damage=reduce(both, said), dialect=table.dialect)


def _times_beside(path: Path, names: Sequence[str], layout: ShirtLayout | None, options: ReadingOptions) -> list[str]:
    """Return the columns that can be the time; a channel of the layout is none."""
    if options.time == NO_COLUMN:
        return []
    times = [options.time] if options.time is not None else time_names(names)
    channels = () if layout is None else layout.channel_names
    others = [name for name in times if name not in channels]
    if times and not others and layout is not None:
        raise ValueError(Text("signals-channel-named-t", file=str(path), layout=layout.name, column=times[0]))
    return others


def _time(table: FileTable, options: ReadingOptions, channels: Collection[str]) -> TimeColumn | None:
    """Return the time of a table; None where only a sample rate says it, of a person or of the file."""
    if options.time == NO_COLUMN:
        if options.rate is None and table.rate is None:
            raise ValueError(Text("signals-rate-needed", file=table.places.file))
        return None
    try:
        return time_of_table(table, options.time, options.unit, channels)
    except ValueError as error:
        by_the_file = _is_refused(error, NO_TIME) and options.unit is None and table.rate is not None
        if options.time is not None or (options.rate is None and not by_the_file):
            raise
        return None


def _sampling_times(table: FileTable, time: TimeColumn | None, rate: float | None, count: int) -> SamplingTimes:
    """Return the times of the samples; a given sample rate replaces those of the file unless they contradict it.

    The rate that the file states replaces its times only where these are not even: the samples were stamped when they
    arrived.
    """
    if rate is None and time is not None:
        try:
            return sampling_times(time.t, table.places, time.column, time.is_stated)
        except ValueError as error:
            if table.rate is None or not _is_refused(error, ARRIVAL) or not _agree(time.t, table.rate):
                raise
            rate = table.rate
    rate = rate or table.rate
    assert rate is not None  # else there would be a time
    if not SLOWEST <= rate <= FASTEST:
        limits = {"slowest": SLOWEST, "fastest": FASTEST}
        raise ValueError(Text("signals-rate-beyond", file=table.places.file, rate=rate, **limits))
    if time is not None and not _agree(time.t, rate):
        span = float(time.t[-1] - time.t[0])
        found = float(f"{(count - 1) / span:.4g}") if span > 0 else 0.0
        file = table.places.file
        raise ValueError(Text("signals-rate-wrong", file=file, rate=rate, column=time.column, found=found))
    first = 0.0 if time is None else float(time.t[0])
    return SamplingTimes(first + np.arange(count) / rate, rate, Text("signals-rate-set", rate=rate))


def _is_refused(error: ValueError, reasons: Collection[str]) -> bool:
    """Return whether an error is a refusal for one of the reasons, the ids of their texts."""
    problem = text_of(error)
    return isinstance(problem, Text) and problem.id in reasons


def _agree(t: NDArray[np.float64], rate: float) -> bool:
    """Return whether times (n,) are those of about so many samples a second (Hz)."""
    return abs(float(t[-1] - t[0]) * rate / (len(t) - 1) - 1.0) <= RATE_TOLERANCE


def _chosen_columns(
    path: Path, named: NamedColumns, times: Sequence[str], layout: ShirtLayout | None, options: ReadingOptions
) -> dict[str, str] | None:
    """Return the column of each channel that has one, None for all columns; `times` can be the time."""
    names = [name for name in named.names if name not in times]
    if options.channels is not None:
        names = [name for name in named.names if name != options.time]  # a person may know that one is no time
        if missing := [name for name in options.channels if name not in names]:
            raise ValueError(Text("signals-column-missing", file=str(path), column=missing[0], names=listed(names)))
        if layout is None:
            return {name: name for name in options.channels}
        if len(options.channels) != len(layout.channel_names):
            counts = {"count": len(options.channels), "expected": len(layout.channel_names)}
            raise ValueError(Text("signals-channels-count", file=str(path), layout=layout.name, **counts))
        return dict(zip(layout.channel_names, options.channels, strict=True))
    if layout is None:
        return None
    columns = columns_of_channels(layout.channel_names, names)
    if not columns and not times:
        wanted = listed(sorted(["t", *layout.channel_names]))
        raise ValueError(Text("signals-columns-missing", place=named.place, names=wanted, there=listed(names)))
    return {name: columns[name] for name in layout.channel_names if name in columns}


def _sentence_of_channels(chosen: dict[str, str]) -> Text | None:
    """Return which columns of other names are channels, None when there is none."""
    pairs = [f"{name} = {column}" for name, column in chosen.items() if name not in {column, bare_name(column)[0]}]
    return Text("signals-channels-taken", pairs=listed(pairs, longest=LONGEST_PAIR)) if pairs else None


def signals_of_run(run: RunRecording, path: Path, layout: ShirtLayout | None = None) -> Signals:
    """Return the frames of a recorded run, `t` from its start; raise ValueError with one sentence."""
    layout_document = run.meta.get("layout")
    if layout_document is None:
        raise ValueError(both(Text("signals-run-without-layout", file=str(path)), run.damage))
    try:
        names = ShirtLayout.model_validate_json(json.dumps(layout_document)).channel_names
    except ValidationError as error:
        raise ValueError(one_sentence(error, Text("signals-layout-place", file=str(path)))) from error
    chosen_names = names if layout is None else layout.channel_names
    if missing := [name for name in chosen_names if name not in names]:
        raise ValueError(_missing(path, missing, layout))
    frames = run.frames()
    values = frames["values"]
    if len(values) < SHORTEST:
        raise ValueError(both(Text("signals-frames-few", file=str(path), count=len(values)), run.damage))
    chosen = values[:, [names.index(name) for name in chosen_names]]
    chosen[np.abs(chosen) > LARGEST] = np.nan
    t, damage, stated_rate = frames["run_t"], run.damage, run.meta.get("sample_rate")
    if isinstance(stated_rate, int | float) and SLOWEST <= stated_rate <= FASTEST:  # the times are those of arrival
        refuse_falling_times(t, TimeSource(places_of_rows(path)))
        t, sample_rate = strictly_rising(t), float(stated_rate)
    else:
        t, sample_rate, note = sampling_times(t, places_of_rows(path))
        damage = both(damage, note)
    t_device = frames["t_device"] if np.isfinite(frames["t_device"]).all() else None
    return Signals(t, chosen, chosen_names, sample_rate, t_device, damage)


def read_layout(path: str | Path) -> ShirtLayout:
    """Read a shirt layout, or raise ValueError with one sentence."""
    path = Path(path)
    try:
        return ShirtLayout.model_validate_json(path.read_bytes().removeprefix(BOM_UTF8))
    except ValidationError as error:
        raise ValueError(one_sentence(error, str(path))) from error
    except FileNotFoundError as error:
        raise ValueError(Text("signals-layout-missing", file=str(path))) from error
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("signals-layout-unreadable", file=str(path), reason=reason)) from error


def _missing(path: Path, missing: list[str], layout: ShirtLayout | None) -> Text:
    names = listed(missing, 5)
    return Text("signals-channel-missing", file=str(path), names=names, layout=layout.name if layout else "")


def _stack_columns(table: Columns, names: list[str]) -> NDArray[np.float64] | NDArray[np.float32]:
    """Return the named columns as (n, n_channels), with NaN for infinities and for values beyond LARGEST."""
    single = all(table[name].dtype == np.float32 for name in names)
    shape = (len(table[names[0]]), len(names))
    values: NDArray[np.float64] | NDArray[np.float32]
    values = np.empty(shape, dtype=np.float32) if single else np.empty(shape, dtype=np.float64)
    for first in range(0, len(values), ROWS_AT_ONCE):  # by blocks that fit into the processor's cache
        rows = slice(first, first + ROWS_AT_ONCE)
        for column, name in enumerate(names):
            values[rows, column] = table[name][rows]
        block = values[rows]
        block[np.abs(block) > LARGEST] = np.nan
    return values
