"""A recording as an XDF file: streams of signals, gestures, commands, pose and state on one clock.

The bytes follow the XDF specification 1.0 (https://github.com/sccn/xdf/wiki/Specifications). Time stamps are `run_t`,
seconds since the start of the run.
"""

import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree as Xml

import numpy as np
from numpy.typing import NDArray

from app.features.exports.csv_tables import channel_names, gesture_names
from app.recording.format import PER_CHANNEL, PER_GESTURE, Columns
from app.recording.groups import RunGroups

HEADER, STREAM_HEADER, SAMPLES, STREAM_FOOTER = 1, 2, 3, 6  # tags of chunks
COMMANDS = ("u1", "u2", "v", "omega", "driven_v", "driven_omega", "dial")
POSE = ("x", "y", "theta", "head_yaw", "head_pitch", "head_roll", "scene_t")
STATE = ("state", "fault", "cue", "in_contact", "contacts", "frame_seq")
CHUNK = 1.0  # s of samples in a chunk: what the cut of a file takes from each stream beyond the cut itself
IRREGULAR = 0.0  # in place of a nominal rate, by the specification: the loop also makes ticks without a frame
FORMATS = {"float32": "<f4", "double64": "<f8", "int64": "<i8"}


class Stream(NamedTuple):
    """A stream of the file: its number, its columns of the recording, and the names of its channels."""

    id: int
    name: str
    kind: str
    columns: tuple[str, ...]
    labels: tuple[str, ...]
    form: str
    frames_only: bool  # a sample for each frame of the shirt; otherwise for each tick


def streams_of(meta: dict[str, Any]) -> list[Stream]:
    """Return the streams of a run; without gestures there is no stream of them."""
    gestures = tuple(f"{name}.{gesture}" for name in PER_GESTURE for gesture in gesture_names(meta))
    streams = [
        Stream(1, "shirt", "Shirt", (PER_CHANNEL,), tuple(channel_names(meta)), "float32", True),
        Stream(2, "gestures", "Gestures", PER_GESTURE, gestures, "double64", False),
        Stream(3, "commands", "Commands", COMMANDS, COMMANDS, "double64", False),
        Stream(4, "pose", "Pose", POSE, POSE, "double64", False),
        Stream(5, "state", "State", STATE, STATE, "int64", False),
        Stream(6, "clocks", "Clocks", ("t", "t_device"), ("t", "t_device"), "double64", False),
    ]
    return [stream for stream in streams if stream.labels]


def write_xdf(run: RunGroups, facts: dict[str, Any], folder: Path, stem: str) -> list[Path]:
    """Write `STEM.xdf`; `facts` (texts by name) stand in the header of the file and of each stream."""
    path = folder / f"{stem}.xdf"
    streams = streams_of(run.meta)
    rate = float(run.meta["sample_rate"])
    counts = dict.fromkeys(streams, 0)
    ends: dict[Stream, tuple[float, float]] = {}
    with path.open("wb") as file:
        file.write(b"XDF:" + _chunk(HEADER, _xml("info", {"version": "1.0", "desc": facts})))
        for stream in streams:
            header = _header(stream, rate if stream.frames_only else IRREGULAR, facts)
            file.write(_chunk(STREAM_HEADER, _number(stream) + header))
        for columns in _in_chunks(run.groups, max(1, round(CHUNK * rate))):
            for stream, times, values in _samples(streams, columns):
                if len(times):
                    file.write(_chunk(SAMPLES, _number(stream) + _sample_bytes(times, values)))
                    counts[stream] += len(times)
                    ends[stream] = (ends.get(stream, (float(times[0]), 0.0))[0], float(times[-1]))
        for stream in streams:
            first, last = ends.get(stream, (0.0, 0.0))
            footer = {"first_timestamp": repr(first), "last_timestamp": repr(last), "sample_count": counts[stream]}
            file.write(_chunk(STREAM_FOOTER, _number(stream) + _xml("info", footer)))
    return [path]


def _in_chunks(groups: Iterator[Columns], rows: int) -> Iterator[Columns]:
    """Yield the columns of a recording in parts of at most `rows` rows."""
    for columns in groups:
        for start in range(0, len(columns["run_t"]), rows):
            yield {name: column[start : start + rows] for name, column in columns.items()}


def _samples(streams: list[Stream], columns: Columns) -> Iterator[tuple[Stream, NDArray[Any], NDArray[Any]]]:
    frames = columns["has_frame"].astype(bool)
    for stream in streams:
        chosen = frames if stream.frames_only else slice(None)
        values = np.column_stack([columns[name] for name in stream.columns])[chosen]
        yield stream, columns["run_t"][chosen], values.astype(FORMATS[stream.form])


def _sample_bytes(times: NDArray[Any], values: NDArray[Any]) -> bytes:
    """Return the number of samples, then each one: 8 (the length of its time stamp), its time, its values."""
    kind = np.dtype([("length", "u1"), ("time", "<f8"), ("values", values.dtype, (values.shape[1],))])
    samples = np.empty(len(times), kind)
    samples["length"], samples["time"], samples["values"] = 8, times, values
    return b"\x04" + struct.pack("<I", len(times)) + samples.tobytes()


def _header(stream: Stream, rate: float, facts: dict[str, Any]) -> bytes:
    channels = [{"label": label} for label in stream.labels]
    return _xml(
        "info",
        {
            "name": stream.name,
            "type": stream.kind,
            "channel_count": len(stream.labels),
            "nominal_srate": repr(rate),
            "channel_format": stream.form,
            "created_at": 0,
            "desc": {**facts, "channels": {"channel": channels}},
        },
    )


def _chunk(tag: int, content: bytes) -> bytes:
    length = len(content) + 2
    return b"\x08" + struct.pack("<QH", length, tag) + content


def _number(stream: Stream) -> bytes:
    return struct.pack("<I", stream.id)


def _xml(name: str, content: dict[str, Any]) -> bytes:
    root = Xml.Element(name)
    _fill(root, content)
    return b'<?xml version="1.0"?>' + Xml.tostring(root)


def _fill(element: Xml.Element, content: dict[str, Any]) -> None:
    for name, value in content.items():
        for item in value if isinstance(value, list) else [value]:
            inner = Xml.SubElement(element, name)
            if isinstance(item, dict):
                _fill(inner, item)
            else:
                inner.text = str(item)
