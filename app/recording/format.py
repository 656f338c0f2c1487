"""The format of a recording's files, shared by its writer and its reader.

A run's folder holds `run.json`, which describes the run. While the run is recorded, the folder holds Arrow IPC streams
`segment-0000.arrows`, `segment-0001.arrows` ..., each with a file of checksums, `segment-0000.check` .... A closed run
has `run.parquet` instead of the segments, and `end.json`: the number of rows and the checksums of the two other files,
and on its second line the checksum of the first line.
"""

import json
from struct import Struct
from typing import Any, NamedTuple, TypedDict
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

META_FILE = "run.json"
END_FILE = "end.json"
PARQUET_FILE = "run.parquet"
DAMAGE_FILE = "damaged.txt"  # the document of a text; a plain sentence in recordings of earlier versions
SEGMENT, SEGMENT_CHECK = "segment-{:04d}.arrows", "segment-{:04d}.check"

LOST_AT_MOST = 0.5  # s of a recording, when the power fails

META_KEY = b"bodydrive"  # key of the copy of run.json in the Arrow schema's metadata
END_OF_STREAM = b"\xff\xff\xff\xff\x00\x00\x00\x00"  # the end marker of an Arrow IPC stream

# The columns of a recording, in their order: fields of `TICK`, with its types.
SCALARS = (
    *("t", "run_t", "t_device", "has_frame", "frame_seq", "u1", "u2", "v", "omega", "x", "y", "theta"),
    *("state", "fault", "cue", "in_contact", "contacts"),
    *("driven_v", "driven_omega", "scene_t", "head_yaw", "head_pitch", "head_roll"),
    "dial",  # the speed dial, without which the commands cannot be computed again
)
PER_GESTURE = ("score", "rate", "activation")
PER_CHANNEL = "values"

CHECK = Struct("<QII")  # end of a piece in the segment, CRC-32 of the piece, CRC-32 of the twelve bytes before


Columns = dict[str, NDArray[Any]]
"""The columns of a recording by name, each of its own type of number."""


class RecordingEnd(TypedDict):
    """The document in `end.json`."""

    rows: int
    dropped: int  # ticks that were overwritten in the ring before they were written
    checksums: dict[str, int]  # CRC-32 of `run.json` and `run.parquet`, by name


class Piece(NamedTuple):
    """A part of a segment that was written at once: the schema, a batch of rows, or the end marker."""

    start: int
    end: int
    checksum: int


def check_record(end: int, piece: bytes) -> bytes:
    """Return the record of a piece that ends at byte `end` of its segment."""
    record = CHECK.pack(end, crc32(piece), 0)
    return record[:12] + crc32(record[:12]).to_bytes(4, "little")


def check_pieces(records: bytes) -> tuple[list[Piece], bool]:
    """Return the pieces of a segment from its check records, and whether a record is damaged (not only cut off)."""
    pieces: list[Piece] = []
    start = 0
    for at in range(0, len(records) - CHECK.size + 1, CHECK.size):
        end, checksum, record_checksum = CHECK.unpack_from(records, at)
        if crc32(records[at : at + 12]) != record_checksum or end <= start:
            return pieces, True
        pieces.append(Piece(start, end, checksum))
        start = end
    return pieces, False


def end_bytes(rows: int, dropped: int, checksums: dict[str, int]) -> bytes:
    """Return the content of `end.json`."""
    line = json.dumps({"rows": rows, "dropped": dropped, "checksums": checksums}).encode()
    return line + b"\n" + str(crc32(line)).encode() + b"\n"


def parse_end(content: bytes) -> RecordingEnd | None:
    """Return the document in `end.json`, None when the file was cut or changed."""
    line, _, rest = content.partition(b"\n")
    if rest != str(crc32(line)).encode() + b"\n":
        return None
    parsed: RecordingEnd = json.loads(line)
    return parsed


def rows_to_columns(rows: NDArray[np.void], n_channels: int, n_gestures: int) -> Columns:
    """Return the columns of ticks (n,): scalars (n,), `values` (n, n_channels), per gesture (n, n_gestures)."""
    columns: Columns = {name: np.ascontiguousarray(rows[name]) for name in SCALARS}
    for name in PER_GESTURE:
        columns[name] = np.ascontiguousarray(rows[name][:, :n_gestures])
    columns[PER_CHANNEL] = np.ascontiguousarray(rows[PER_CHANNEL][:, :n_channels])
    return columns
