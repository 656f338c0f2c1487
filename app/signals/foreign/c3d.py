"""Reads the markers and the analogue channels of a C3D file with ezc3d."""

from pathlib import Path
from typing import Any

import numpy as np

from app.signals.column_names import unique_names
from app.signals.foreign.recording import ForeignRecording, SampledStream, even_times, library, of_streams

AXES = ("x", "y", "z")


def read(file: Path, part: str | None = None) -> ForeignRecording:
    """Return markers (three columns each) and analogue channels at the faster rate of both, or one of both."""
    content = library("ezc3d").c3d(str(file))
    streams = [stream for stream in (_points(content), _analogues(content)) if stream is not None]
    return of_streams(file, streams, part)


def _points(content: Any) -> SampledStream | None:
    points = np.asarray(content["data"]["points"], np.float64)  # (4, markers, frames)
    facts = content["parameters"]["POINT"]
    if not points.size:
        return None
    places = points[:3].copy()
    residuals = np.asarray(content["data"]["meta_points"]["residuals"], np.float64)  # (1, markers, frames)
    places[:, residuals[0] < 0] = np.nan  # a marker that no camera saw
    values = places.transpose(2, 1, 0).reshape(points.shape[2], -1)
    labels = _labels(facts, points.shape[1], "marker")
    names = [f"{label} {axis}" for label in labels for axis in AXES]
    units = [_texts(facts, "UNITS")[0] if _texts(facts, "UNITS") else ""] * len(names)
    return SampledStream("markers", even_times(len(values), _rate(facts)), values, names, units)


def _analogues(content: Any) -> SampledStream | None:
    analogues = np.asarray(content["data"]["analogs"], np.float64)  # (1, channels, samples)
    facts = content["parameters"]["ANALOG"]
    if not analogues.size:
        return None
    values = analogues[0].T
    units = _texts(facts, "UNITS")
    units = (units + [""] * values.shape[1])[: values.shape[1]]
    names = _labels(facts, values.shape[1], "channel")
    return SampledStream("analogue", even_times(len(values), _rate(facts)), values, names, units)


def _labels(facts: Any, count: int, otherwise: str) -> list[str]:
    """Return names for all; labels beyond the first 255 stand in further parameters."""
    labels = [label for number in ("", *map(str, range(2, 10))) for label in _texts(facts, f"LABELS{number}")]
    return unique_names((labels + [f"{otherwise} {number}" for number in range(len(labels) + 1, count + 1)])[:count])


def _texts(facts: Any, name: str) -> list[str]:
    return [str(text).strip() for text in facts[name]["value"]] if name in facts else []


def _rate(facts: Any) -> float:
    return float(facts["RATE"]["value"][0])
