"""The kinds of files of signals that a library, or a reader of their own, opens: one line for each kind.

A module has `read(file, part)`, which returns a `ForeignRecording` or a `ForeignText`, of all parts of the file where
`part` is None. Only the reader of foreign files (`app/isolated_reader.py`) loads it.
"""

from pathlib import Path
from typing import Final, NamedTuple


class ForeignKind(NamedTuple):
    """A kind of files: its name, how its files are called, how they begin, and the module that reads them."""

    name: str
    suffixes: tuple[str, ...]
    beginning: bytes  # empty where it says nothing
    module: str
    extra: str = "files"  # with its library


KINDS: Final = (
    ForeignKind("XLSX", (".xlsx", ".xlsm"), b"PK\x03\x04", "app.signals.foreign.xlsx"),
    ForeignKind("MATLAB", (".mat",), b"MATLAB ", "app.signals.foreign.matlab"),
    ForeignKind("C3D", (".c3d",), b"", "app.signals.foreign.c3d"),
    ForeignKind("EDF", (".edf", ".bdf"), b"", "app.signals.foreign.edf"),
    ForeignKind("XDF", (".xdf", ".xdfz"), b"XDF:", "app.signals.foreign.xdf"),
    ForeignKind("BVH", (".bvh",), b"HIERARCHY", "app.signals.foreign.bvh"),
    ForeignKind("ROS", (".bag", ".db3"), b"#ROSBAG", "app.signals.foreign.ros_bag", "bags"),
    ForeignKind("MCAP", (".mcap",), b"\x89MCAP", "app.signals.foreign.mcap_log", "bags"),
)
LONGEST_BEGINNING: Final = max(len(kind.beginning) for kind in KINDS)


def foreign_kind(path: Path) -> ForeignKind | None:
    """Return the kind of a file, by its name or else by how it begins; None for tables in text and Parquet."""
    suffix = path.suffix.lower()
    for kind in KINDS:
        if suffix in kind.suffixes:
            return kind
    with path.open("rb") as file:
        head = file.read(LONGEST_BEGINNING)
    return next((kind for kind in KINDS if kind.beginning and head.startswith(kind.beginning)), None)
