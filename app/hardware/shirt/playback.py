"""Playback of a file as frames of a shirt: recorded runs, CSV and Parquet."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from app.hardware.base import HardwareError
from app.hardware.body.minimum_jerk import minimum_jerk
from app.layout import ShirtLayout
from app.sentences import one_sentence
from app.signals.column_names import columns_of_channels
from app.signals.joint_names import layout_from_names
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.signals.signals import ReadingOptions

BLEND = 0.5  # s over which the end of a looped recording is blended into its beginning
LONGEST_LOSS = 1 << 20  # frames: a larger step of the counter means that the device was restarted
FEWEST = 10  # frames of a recording that can be played


@dataclass(frozen=True, slots=True)
class FrameFile:
    """The frames of a file, with their times."""

    name: str
    layout: ShirtLayout
    sample_rate: float  # Hz
    t: NDArray[np.float64]  # (n,) s, strictly rising from 0
    seq: NDArray[np.int64]  # (n,) strictly rising from 0; a gap is a loss during the recording
    values: NDArray[np.float32]  # (n, n_channels)
    note: Text | None = None  # what was mended or is missing in the times of the file


def read_frames(
    path: str | Path, options: "ReadingOptions | None" = None, layout: ShirtLayout | None = None
) -> FrameFile:
    """Read the folder of a recorded run, or a file of signals; `options` correct what the file says of itself.

    A `layout` names the channels by the names of the file's columns, or, where it has others, in their order. Without
    it, that of a run is its own, and that of a file `NAME.layout.json` or `layout.json` beside it; without such a file,
    channels named JOINT_NUMBER make one.

    Raises
    ------
    HardwareError
        A text of one sentence that says what, where and what to do.
    """
    path = Path(path)
    try:
        return _read_recording(path, layout) if path.is_dir() else _read_file(path, options, layout)
    except ValueError as error:
        raise HardwareError(text_of(error)) from error


class FramePlayer:
    """Returns the frames one after another; a loop blends the end into the beginning."""

    def __init__(self, file: FrameFile, loop: bool) -> None:
        self.due = 0.0  # s since the start: when the next frame is due; infinite after the last one
        self._file = file
        self._count = len(file.t)
        self._at = 0
        self._loops = loop
        self._passed, self._passed_seq = 0.0, 0  # s and frames of the earlier rounds of the loop
        self._head = file.values[:0]
        if loop:
            blend = max(1, min(round(BLEND * file.sample_rate), self._count // 4))
            self._count -= blend
            share = np.array([[minimum_jerk((i + 0.5) / blend)] for i in range(blend)], dtype=np.float32)
            self._head = share * file.values[:blend] + (1 - share) * file.values[self._count :]

    def next_frame(self) -> tuple[int, float, NDArray[np.float32]]:
        """Return seq, time (s since the start) and values (n_channels,) of the next frame; not after the last one."""
        file, i = self._file, self._at
        in_head = self._passed_seq > 0 and i < len(self._head)
        values = self._head[i] if in_head else file.values[i]
        frame = (self._passed_seq + int(file.seq[i]), self.due, values)
        self._at += 1
        if self._at < self._count:
            self.due = self._passed + float(file.t[self._at])
        elif self._loops:
            self._at = 0
            self._passed += float(file.t[self._count])
            self._passed_seq += int(file.seq[self._count])
            self.due = self._passed
        else:
            self.due = math.inf
        return frame


def layout_beside(path: Path) -> ShirtLayout | None:
    """Return the layout that lies beside a file of signals; None where there is none.

    People bring it: whatever it says, every value has to change (safety S5).

    Raises
    ------
    ValueError
        One sentence when it cannot be read.
    """
    from app.signals.signals import read_layout  # noqa: PLC0415  (loads pyarrow, which other shirts do not need)

    places = (path.with_name(f"{path.stem}.layout.json"), path.with_name("layout.json"))
    file = next((place for place in places if place.exists()), None)
    return read_layout(file).without_liveness if file is not None and path.is_file() else None


def _read_file(path: Path, options: "ReadingOptions | None", layout: ShirtLayout | None) -> FrameFile:
    from app.signals.signals import AS_THE_FILE_SAYS, read_signals  # noqa: PLC0415  (loads pyarrow)

    options = options or AS_THE_FILE_SAYS
    if layout is None:
        layout = layout_beside(path)
    else:
        options = _with_columns(path, layout, options)
    signals = read_signals(path, layout, options)
    if layout is None:
        try:
            layout = layout_from_names(path, signals.channel_names)
        except ValidationError as error:
            raise ValueError(one_sentence(error, Text("shirtdev-file-columns", file=str(path)))) from error
    t = signals.t - signals.t[0]
    seq = _rising(np.rint(t * signals.sample_rate).astype(np.int64))
    return FrameFile(path.name, layout, signals.sample_rate, t, seq, signals.values.astype(np.float32), signals.damage)


def _with_columns(path: Path, layout: ShirtLayout, options: "ReadingOptions") -> "ReadingOptions":
    """Return options that name the columns in their order when these are not named as the layout's channels."""
    from app.signals.columns import named_columns  # noqa: PLC0415  (loads pyarrow)
    from app.signals.signals import read_signals  # noqa: PLC0415

    names = layout.channel_names
    if options.channels is not None or len(columns_of_channels(names, named_columns(path).names)) == len(names):
        return options
    return replace(options, channels=tuple(read_signals(path, options=options).channel_names))


def _read_recording(folder: Path, layout: ShirtLayout | None) -> FrameFile:
    from app.recording.reader import read_run  # noqa: PLC0415  (loads pyarrow, which other shirts do not need)

    run = read_run(folder)
    frames = run.frames()
    if len(frames["t"]) < FEWEST:
        raise ValueError(Text("shirtdev-recording-short", folder=str(folder), frames=len(frames["t"])))
    described, sample_rate = _described(folder, run.meta)
    layout = layout or described
    t = frames["t_device"]
    if not (np.isfinite(t).all() and (np.diff(t) > 0).all()):  # the device was restarted: use the times of arrival
        t = frames["t"]
    if not (np.diff(t) > 0).all():
        raise ValueError(Text("shirtdev-recording-times", folder=str(folder)))
    ahead = np.mod(np.diff(frames["frame_seq"].astype(np.int64)), 1 << 32)
    ahead[(ahead == 0) | (ahead > LONGEST_LOSS)] = 1
    seq = np.concatenate(([0], np.cumsum(ahead)))
    values = frames["values"].astype(np.float32)
    if values.shape[1] != len(layout.channels):
        named = len(layout.channels)
        raise ValueError(Text("shirtdev-recording-channels", folder=str(folder), channels=values.shape[1], named=named))
    return FrameFile(folder.name, layout, sample_rate, t - t[0], seq, values)


def _described(folder: Path, meta: Mapping[str, object]) -> tuple[ShirtLayout, float]:
    """Return the layout and the sample rate (Hz) in the meta of a recording."""
    try:
        layout = ShirtLayout.model_validate(meta.get("layout"))
    except ValidationError as error:
        raise ValueError(one_sentence(error, Text("shirtdev-recording-layout", folder=str(folder)))) from error
    rate = meta.get("sample_rate")
    if not isinstance(rate, int | float) or isinstance(rate, bool) or not 0 < rate < math.inf:
        raise ValueError(Text("shirtdev-recording-rate", folder=str(folder)))
    return layout, float(rate)


def _rising(seq: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return strictly rising counters: uneven times can round two frames to one number."""
    steps = np.maximum(np.diff(seq), 1)
    return np.concatenate(([0], np.cumsum(steps)))
