"""Reads a BVH file (Biovision hierarchy): the channels of its joints, at the time between its frames."""

import re
from pathlib import Path
from typing import Final

import numpy as np

from app.signals.column_names import unique_names
from app.signals.foreign.recording import OWN_TIME, ForeignRecording
from app.texts import Text

JOINT: Final = re.compile(r"^\s*(?:ROOT|JOINT)\s+(.+?)\s*$")
CHANNELS: Final = re.compile(r"^\s*CHANNELS\s+(\d+)\s+(.+?)\s*$")
FRAME_TIME: Final = re.compile(r"^\s*Frame Time:\s*(\S+)\s*$", re.IGNORECASE)


def read(file: Path, _part: str | None = None) -> ForeignRecording:
    """Return t and a column for each channel of each joint: positions in the file's unit, rotations in degrees.

    Raises
    ------
    ValueError
        One sentence for a file without channels, or with rows of another length.
    """
    names: list[str] = []
    joint, period = "", 0.0
    lines = iter(file.read_text(encoding="utf-8", errors="replace").splitlines())
    for line in lines:
        if match := JOINT.match(line):
            joint = match[1]
        elif match := CHANNELS.match(line):
            names += [f"{joint} {channel}" for channel in match[2].split()[: int(match[1])]]
        elif match := FRAME_TIME.match(line):
            period = float(match[1])
            break
    rows = [line.split() for line in lines if line.strip()]
    if rows and len(rows[-1]) < len(names):
        rows.pop()  # cut
    if not names or period <= 0.0 or not rows or any(len(row) != len(names) for row in rows):
        raise ValueError(Text("signals-foreign-damaged", file=str(file), kind="BVH"))
    values = np.array(rows, dtype=np.float64)
    names = unique_names(names)
    units = {name: "deg" for name in names if name.lower().endswith("rotation")}
    columns = {OWN_TIME: np.arange(len(values)) * period, **dict(zip(names, values.T, strict=True))}
    return ForeignRecording(columns, units)
