"""What a reader of a foreign file gives: columns of one length with their units, and the time."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import import_module
from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.signals.column_names import unique_names
from app.signals.file_table import FilePart, listed
from app.texts import Text

OWN_TIME: Final = "t"
ROUNDING: Final = 1e-6  # s by which a sample may be later, for what clocks are rounded to
OLDEST: Final = 3.0  # periods: an older sample stands for none


@dataclass(frozen=True, slots=True)
class ForeignRecording:
    """Columns (n,), with their units where the file says them; a time that a rate says is the column t, in s."""

    columns: dict[str, NDArray[np.float64]]
    units: Mapping[str, str] = field(default_factory=dict)
    note: Text | None = None
    rate: float | None = None  # Hz, as the file states it beside its columns
    parts: tuple[FilePart, ...] = ()  # of the file, of which one can be read alone


class ForeignText(NamedTuple):
    """A table in text that a foreign file holds."""

    text: str
    rate: float | None = None  # Hz, as the file states it elsewhere
    parts: tuple[FilePart, ...] = ()
    note: Text | None = None


class SampledStream(NamedTuple):
    """Channels that were sampled together."""

    name: str
    t: NDArray[np.float64]  # (n,) s, not falling
    values: NDArray[np.float64]  # (n, k)
    names: Sequence[str]  # of the k channels
    units: Sequence[str]  # empty where the file says none


def library(name: str) -> Any:
    """Return a library of the extra `files`; raise MissingLibraryError when it is not installed."""
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingLibraryError(name.partition(".")[0]) from error


class MissingLibraryError(Exception):
    """A library that reads a kind of files is not installed; its argument is the library's name."""


def even_times(count: int, rate: float) -> NDArray[np.float64]:
    """Return the times (count,) of samples at `rate` (Hz), s."""
    return np.arange(count) / rate


def of_streams(file: Path, streams: Sequence[SampledStream], part: str | None) -> ForeignRecording:
    """Return the streams of a file as one table, or the one that is called `part`; the file's parts are its streams.

    Raises
    ------
    ValueError
        One sentence when there is no stream of this name.
    """
    if not streams:
        return ForeignRecording({})
    named = dict(zip(unique_names(stream.name for stream in streams), streams, strict=True))
    if part is not None and part not in named:
        raise part_missing(file, part, [*named])
    parts = tuple(FilePart(name, len(stream.names), len(stream.t)) for name, stream in named.items())
    recording = joined(streams if part is None else [named[part]])
    return replace(recording, parts=parts if len(parts) > 1 else ())


def part_missing(file: Path, part: str, names: Sequence[str]) -> ValueError:
    """Return the refusal of a part that a file does not have."""
    return ValueError(Text("signals-part-missing", file=str(file), part=part, names=listed([*names])))


def joined(streams: Sequence[SampledStream]) -> ForeignRecording:
    """Return streams as one table at the times of the one with the most samples.

    The others have their newest sample there, and NaN where that is older than 3 of their periods. With several
    streams, the name of each, if it has one, stands before those of its channels.
    """
    base = max(streams, key=lambda stream: len(stream.t))
    columns: dict[str, NDArray[np.float64]] = {OWN_TIME: base.t}
    units: dict[str, str] = {OWN_TIME: "s"}
    several = len(streams) > 1
    for stream in streams:
        values = stream.values if stream is base else newest_samples(stream, base.t)
        names = unique_names(f"{stream.name} {name}".strip() if several else name for name in stream.names)
        for index, name in enumerate(names):
            own = name if name not in columns else f"{name} ({len(columns)})"
            columns[own] = values[:, index]
            if stream.units[index]:
                units[own] = stream.units[index]
    return ForeignRecording(columns, units)


def newest_samples(stream: SampledStream, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the newest samples (m, k) of a stream at the times `t` (m,), NaN where there is none, or an old one."""
    newest = np.searchsorted(stream.t, t + ROUNDING, side="right") - 1
    values = stream.values[np.maximum(newest, 0)]
    steps = np.diff(stream.t)
    period = float(np.median(steps)) if len(steps) else np.inf
    missing = (newest < 0) | (t - stream.t[np.maximum(newest, 0)] > OLDEST * period)
    values[missing] = np.nan
    return values
