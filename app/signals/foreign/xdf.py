"""Reads all streams of numbers of an XDF file with pyxdf, which puts them on one clock."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from app.signals.column_names import unique_names
from app.signals.file_table import listed
from app.signals.foreign.recording import ForeignRecording, SampledStream, library, of_streams
from app.texts import Text

FEWEST = 2  # samples of a stream


def read(file: Path, part: str | None = None) -> ForeignRecording:
    """Return the streams at the times of the one with the most samples, or one alone; those of words are left out."""
    found, _ = library("pyxdf").load_xdf(str(file), verbose=False)
    streams = [stream for stream in map(_stream, found) if stream is not None]
    left_out = [_first(stream["info"], "name") for stream in found if _stream(stream) is None]
    note = Text("signals-streams-left-out", names=listed(left_out)) if left_out and part is None else None
    return replace(of_streams(file, streams, part), note=note)


def _stream(stream: Any) -> SampledStream | None:
    """Return a stream of numbers; None for one of words, or without samples."""
    values, t = stream["time_series"], np.asarray(stream["time_stamps"], np.float64)
    if not isinstance(values, np.ndarray) or values.dtype.kind not in "biuf" or len(t) < FEWEST:
        return None
    numbers = values.astype(np.float64).reshape(len(t), -1)
    described = _channels(stream["info"])
    labels = [_first(channel, "label") for channel in described]
    units = [_first(channel, "unit") for channel in described]
    if len(labels) != numbers.shape[1] or not all(labels):
        labels = [f"channel {number}" for number in range(1, numbers.shape[1] + 1)]
        units = [""] * len(labels)
    order = np.argsort(t, kind="stable")
    return SampledStream(_first(stream["info"], "name"), t[order], numbers[order], unique_names(labels), units)


def _channels(info: Any) -> list[Any]:
    """Return the descriptions of the channels, none where the stream has none."""
    try:
        return list(info["desc"][0]["channels"][0]["channel"])
    except (KeyError, IndexError, TypeError):
        return []


def _first(holder: Any, name: str) -> str:
    """Return the first text of that name, empty without one."""
    try:
        return str(holder[name][0] or "").strip()
    except (KeyError, IndexError, TypeError):
        return ""
