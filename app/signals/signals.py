"""Reads a shirt's signals from a CSV or Parquet file, or from a recorded run."""

import json
from codecs import BOM_UTF8
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from app.layout import MAX_CHANNELS, ShirtLayout
from app.recording.reader import RunRecording, both, read_run
from app.sentences import one_sentence
from app.signals.columns import Table, listed, read_columns_and_dialect, require_column
from app.signals.csv_dialect import Dialect
from app.signals.sampling_times import FASTEST, SLOWEST, refuse_falling_times, sampling_times, strictly_rising
from app.texts import Text

SHORTEST = 10  # samples
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


def read_signals(path: str | Path, layout: ShirtLayout | None = None) -> Signals:
    """Read the signals of a file or of a run's folder: the layout's channels in its order, else every column but `t`.

    Raises
    ------
    ValueError
        One sentence that names the file, the line or column, and what to do.
    """
    path = Path(path)
    if path.is_dir():
        return signals_of_run(read_run(path), path, layout)
    only = None if layout is None else {"t", *layout.channel_names}
    table, dialect = read_columns_and_dialect(path, only=only)
    t = require_column(table, path, "t")
    names = [name for name in table if name != "t"] if layout is None else layout.channel_names
    if not names:
        raise ValueError(Text("signals-no-channel", file=str(path)))
    if layout is None and len(names) > MAX_CHANNELS:
        raise ValueError(Text("signals-channels", file=str(path), count=len(names), most=MAX_CHANNELS))
    if layout is not None and "t" in names:
        raise ValueError(Text("signals-channel-named-t", file=str(path), layout=layout.name))
    if missing := [name for name in names if name not in table]:
        raise ValueError(_missing(path, missing, layout))
    if len(t) < SHORTEST:
        raise ValueError(Text("signals-samples-few", file=str(path), count=len(t)))
    even, sample_rate, note = sampling_times(t, path)
    return Signals(even, _stack_columns(table, names), names, sample_rate, damage=note, dialect=dialect)


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
        refuse_falling_times(t, path)
        t, sample_rate = strictly_rising(t), float(stated_rate)
    else:
        t, sample_rate, note = sampling_times(t, path)
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


def _stack_columns(table: Table, names: list[str]) -> NDArray[np.float64] | NDArray[np.float32]:
    """Return the named columns as (n, n_channels), with NaN for infinities and for values beyond LARGEST."""
    single = all(table[name].dtype == np.float32 for name in names)
    shape = (len(table["t"]), len(names))
    values: NDArray[np.float64] | NDArray[np.float32]
    values = np.empty(shape, dtype=np.float32) if single else np.empty(shape, dtype=np.float64)
    for first in range(0, len(values), ROWS_AT_ONCE):  # by blocks that fit into the processor's cache
        rows = slice(first, first + ROWS_AT_ONCE)
        for column, name in enumerate(names):
            values[rows, column] = table[name][rows]
        block = values[rows]
        block[np.abs(block) > LARGEST] = np.nan
    return values
