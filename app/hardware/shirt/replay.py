"""A file as a shirt: its frames come at their recorded times."""

import math
from typing import Annotated, Literal

from pydantic import Field

from app.arrivals import Arrivals
from app.clock import Clock
from app.hardware.base import HardwareError
from app.hardware.shirt.arrival_watch import GOOD
from app.hardware.shirt.kind import (
    FieldTexts,
    OwnLayout,
    ShirtConfig,
    ShirtKind,
    SignalFile,
    SourceFacts,
    Trust,
    page_texts,
)
from app.hardware.shirt.playback import FrameFile, FramePlayer, read_frames
from app.layout import ShirtLayout
from app.messages import SensorFrame
from app.texts import Figure, Text

LONGEST_LAG = 1.0  # s: after a longer hold-up the replay resumes where it stopped; a device would have gone on


class ReplayConfig(ShirtConfig):
    """Signals that were recorded before, played as if they came now."""

    model_config = page_texts(
        Text("shirtdev-replay-title"),
        about=Text("shirtdev-replay-about"),
        in_use=Text("shirtdev-replay-in-use", file="{file}"),
        facts=SourceFacts(Text("shirtdev-replay-needs"), Text("shirtdev-replay-costs"), Text("shirtdev-replay-takes")),
    )

    kind: Literal["replay"]
    file: SignalFile
    loop: Annotated[bool, FieldTexts(Text("shirtdev-replay-loop"))] = True
    layout: Annotated[
        OwnLayout | None,
        Field(json_schema_extra={"format": "layout"}),
        FieldTexts(Text("shirtdev-layout"), Text("shirtdev-replay-layout-hint")),
    ] = None  # None: the layout that the file has


class ReplayedShirt:
    """Plays a recorded run, a CSV or a Parquet file, once or in a loop."""

    def __init__(self, config: ReplayConfig, clock: Clock) -> None:
        self.lost = 0
        self._config = config
        self._clock = clock
        self._file: FrameFile | None = None
        self._player: FramePlayer | None = None
        self._start = 0.0  # monotonic s
        self._next_seq = 0
        self._t = 0.0  # s into the replay

    @property
    def layout(self) -> ShirtLayout:
        """Names and places of the channels."""
        return self._read().layout

    @property
    def sample_rate(self) -> float:
        """Frames per second, Hz."""
        return self._read().sample_rate

    def open(self) -> None:
        """Begin at the file's first frame.

        Raises
        ------
        HardwareError
            When the file is missing, cannot be read, or, without a layout, does not name the joint of each channel.
        """
        self._player = FramePlayer(self._read(), self._config.loop)
        self.lost = self._next_seq = 0
        self._t = 0.0
        self._start = self._clock.now()

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame when it is due within `timeout` (s)."""
        now = self._clock.now()
        player = self._player
        if player is None or self._start + player.due > now + timeout:
            self._clock.sleep_until(now + timeout)
            return None
        due = self._start + player.due
        if due > now:
            self._clock.sleep_until(due)
        elif now - due > LONGEST_LAG:
            self._start += now - due
        seq, t, values = player.next_frame()
        self.lost += seq - self._next_seq
        self._next_seq = seq + 1
        self._t = t
        return SensorFrame(seq & 0xFFFFFFFF, t, self._clock.now(), values)

    def pending(self) -> bool:
        """Return whether the next frame is due already."""
        return self._player is not None and self._start + self._player.due <= self._clock.now()

    def description(self) -> Text:
        """Return the shirt's state in words."""
        if self._player is None or self._file is None:
            return Text("shirtdev-replay-closed")
        if math.isinf(self._player.due):
            return Text("shirtdev-replay-ended", file=self._file.name)
        length = float(self._file.t[-1])
        return Text(
            "shirtdev-replay",
            file=self._file.name,
            sensors=len(self._file.layout.channels),
            rate=round(self._file.sample_rate, 2),
            played=Figure(self._t % length if length else 0.0),
            length=Figure(length),
            note=self._file.note or "none",
        )

    def arrivals(self) -> Arrivals:
        """Return whether frames still come of the file."""
        if self._player is None:
            return Arrivals("gone", self.description())
        has_ended = math.isinf(self._player.due)
        return Arrivals("ended", self.description()) if has_ended else Arrivals("arrives", GOOD)

    def close(self) -> None:
        """End the replay."""
        self._player = None

    def _read(self) -> FrameFile:
        if self._file is None:
            try:
                self._file = read_frames(self._config.file, layout=self._config.layout)
            except OSError as error:
                raise HardwareError(
                    Text("shirtdev-replay-failed", file=self._config.file, why=error.strerror or "")
                ) from error
        return self._file


KIND = ShirtKind(ReplayConfig, ReplayedShirt, Trust.NEVER, simulated=True)
