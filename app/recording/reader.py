"""Reads a recorded run, up to its first damaged byte."""

import json
import os
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any
from zlib import crc32

import numpy as np

from app.messages import TICK
from app.recording.format import (
    DAMAGE_FILE,
    END_FILE,
    END_OF_STREAM,
    LOST_AT_MOST,
    META_FILE,
    META_KEY,
    PARQUET_FILE,
    PER_CHANNEL,
    PER_GESTURE,
    SCALARS,
    SEGMENT,
    Columns,
    RecordingEnd,
    check_pieces,
    parse_end,
)
from app.texts import Figure, Text, from_document

if TYPE_CHECKING:
    import pyarrow as pa

CHUNK = 1 << 20  # bytes read at once for a checksum
CUT = Text("recording-cut")
UNREADABLE = (ValueError, TypeError, AttributeError, KeyError, NotImplementedError)
"""What a changed name or type of a column raises, which the Parquet file does not protect by a checksum."""


@dataclass(slots=True)
class RunRecording:
    """One recorded run.

    `columns` holds arrays (n_rows,), for `values` (n_rows, n_channels), for `score`, `rate` and `activation`
    (n_rows, n_gestures). A row without `has_frame` is a tick in which no frame came: its values are NaN.
    """

    meta: dict[str, Any]  # the content of `run.json`; empty when it cannot be read
    columns: Columns
    dropped: int  # ticks that were overwritten in the ring before they were written; 0 when unknown
    damage: Text | None  # None: the recording is whole and closed

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self.columns["t"])

    @property
    def loss(self) -> Text | None:
        """The damage, of a recording that was cut with how much its end lost at most; None when it is whole."""
        if self.damage != CUT or not self.rows:
            return self.damage
        end = float(self.columns["t"][-1] - self.columns["t"][0])
        return Text("recording-cut-loss", end=Figure(end, 2), lost=LOST_AT_MOST)

    def frames(self) -> Columns:
        """Return the columns of the rows in which a frame came."""
        chosen = self.columns["has_frame"].astype(bool)
        return {name: column[chosen] for name, column in self.columns.items()}


def read_run(folder: str | Path, names: Collection[str] | None = None) -> RunRecording:
    """Return the run in `folder`; of a damaged one, the rows before the first damaged byte.

    `RunRecording.damage` describes missing and changed bytes; they raise no error.

    Parameters
    ----------
    folder
        The folder of the run.
    names
        The columns that are needed, with `t`; None: all. Of a closed run, the others are neither read nor checked. The
        columns of channels and gestures, which are nine tenths of a run, are then empty, and the others missing.

    Raises
    ------
    ValueError
        One sentence, when the folder holds no recording.
    """
    folder = Path(folder)
    segments = sorted(folder.glob("segment-*.arrows"))
    parquet = folder / PARQUET_FILE
    meta_file = _bytes_of(folder / META_FILE)
    if meta_file is None and not segments and not parquet.exists():
        raise ValueError(Text("recording-none", folder=str(folder)))
    end = parse_end(_bytes_of(folder / END_FILE) or b"")
    damage = _noted_damage(folder / DAMAGE_FILE)
    problem: Text | None = None
    tables: list[pa.Table] = []
    if parquet.exists() and (end is not None or not segments):
        tables, problem = _read_parquet(parquet, end, names)
    if not tables and segments:
        tables, problem = _read_segments(segments)
    copy = _copied_meta(tables)
    meta = _object(copy) or _object(meta_file) or {}
    if copy is not None and meta_file != copy:
        problem = both(problem, Text("recording-run-json-changed", folder=str(folder)))
    if not meta:
        problem = problem or Text("recording-run-json-unreadable", folder=str(folder))
    try:
        columns = columns_of(tables, meta)
    except UNREADABLE:
        columns, problem = _no_rows(meta), problem or Text("recording-unreadable", file=str(parquet))
    return RunRecording(meta, columns, end["dropped"] if end else 0, damage or problem)


def both(first: Text | None, second: Text | None) -> Text | None:
    """Return what is to be said when either, or both, of two sentences are."""
    return Text("recording-both", first=first, second=second) if first and second else first or second


def _noted_damage(file: Path) -> Text | None:
    """Return what the recorder noted when it failed."""
    noted = (_bytes_of(file) or b"").decode(errors="replace")
    try:
        text = from_document(json.loads(noted))
    except UNREADABLE:
        text = noted
    if isinstance(text, Text):
        return text
    return Text("recording-noted", sentence=text) if text else None


def _read_parquet(
    file: Path, end: RecordingEnd | None, names: Collection[str] | None
) -> tuple[list["pa.Table"], Text | None]:
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    try:
        with pa_parquet.ParquetFile(file, page_checksum_verification=True) as opened:
            schema = opened.schema_arrow
            table = opened.read(None if names is None else [name for name in schema.names if name in names])
        table.validate(full=True)
        is_whole = _has_all_columns(schema)
    except (pa.ArrowException, OSError, *UNREADABLE):
        return [], Text("recording-unreadable", file=str(file))
    problem = None
    if end is None:
        problem = Text("recording-unchecked", file=str(file.parent / END_FILE))
    elif names is None and end["checksums"][PARQUET_FILE] != file_checksum(file):
        problem = Text("recording-changed", file=str(file))
    return ([table] if is_whole else []), problem


def _read_segments(segments: list[Path]) -> tuple[list["pa.Table"], Text]:
    """Return the rows before the first missing or wrong byte, and one sentence on the damage."""
    tables: list[pa.Table] = []
    for number, segment in enumerate(segments):
        if segment.name != SEGMENT.format(number):
            return tables, Text("recording-file-missing", file=str(segment))
        content = _bytes_of(segment) or b""
        sound, changed = _sound_part(content, _bytes_of(segment.with_suffix(".check")) or b"")
        tables += [table for table in _batches(content[:sound]) if not tables or table.schema.equals(tables[0].schema)]
        if changed:
            return tables, Text("recording-bytes-changed", file=str(segment))
        if not content[:sound].endswith(END_OF_STREAM):
            break
    return tables, CUT


def _sound_part(content: bytes, records: bytes) -> tuple[int, bool]:
    """Return the number of readable bytes of a segment, and whether a changed byte limits them (not the file's end).

    Bytes after the last check record were written just before a crash: the Arrow decoder has to find their end.
    """
    pieces, changed = check_pieces(records)
    for piece in pieces:
        if piece.end > len(content):
            return piece.start, False
        if crc32(content[piece.start : piece.end]) != piece.checksum:
            return piece.start, True
    if changed:
        return (pieces[-1].end if pieces else 0), True
    return len(content), False


def _batches(content: bytes) -> list["pa.Table"]:
    """Return the batches of a stream that may be cut anywhere."""
    import pyarrow as pa

    batches: list[pa.RecordBatch] = []
    try:
        with pa.ipc.open_stream(content) as stream:
            if not _has_all_columns(stream.schema):
                return []
            batches = [pa.RecordBatch.from_pylist([], schema=stream.schema)]  # keeps the columns when there are no rows
            while True:
                batch = stream.read_next_batch()
                batch.validate(full=True)
                batches.append(batch)
    except (StopIteration, pa.ArrowException, OSError):
        return [pa.Table.from_batches(batches)] if batches else []


def _has_all_columns(columns: "pa.Schema") -> bool:
    return set(SCALARS) <= set(columns.names) and PER_CHANNEL in columns.names


def columns_of(tables: list["pa.Table"], meta: dict[str, Any]) -> Columns:
    """Return the rows of all tables as arrays."""
    import pyarrow as pa

    if not tables:
        return _no_rows(meta)
    rows = pa.concat_tables(tables)
    columns: Columns = {name: rows.column(name).to_numpy() for name in SCALARS if name in rows.column_names}
    for name in (*PER_GESTURE, PER_CHANNEL):
        if name in rows.column_names:
            lists: Any = rows.column(name)
            flat = np.concatenate(
                [np.empty(0, lists.type.value_type.to_pandas_dtype())]
                + [chunk.flatten().to_numpy() for chunk in lists.chunks]
            )
            columns[name] = flat.reshape(rows.num_rows, lists.type.list_size)
        else:
            columns[name] = np.empty((rows.num_rows, 0))
    return columns


def _no_rows(meta: dict[str, Any]) -> Columns:
    columns: Columns = {name: np.empty(0, TICK[name]) for name in SCALARS}
    columns |= {name: np.empty((0, len(meta.get("gestures") or ()))) for name in PER_GESTURE}
    layout = meta.get("layout")
    channels = layout.get("channels") if isinstance(layout, dict) else None
    columns[PER_CHANNEL] = np.empty((0, len(channels or ())), np.float32)
    return columns


def _copied_meta(tables: list["pa.Table"]) -> bytes | None:
    """Return the copy of `run.json` that the recording itself carries."""
    metadata = tables[0].schema.metadata if tables else None
    return metadata.get(META_KEY) if metadata else None


def _object(content: bytes | None) -> dict[str, Any] | None:
    try:
        parsed = json.loads(content) if content else None
    except (ValueError, RecursionError):
        return None
    return parsed if isinstance(parsed, dict) else None


def _bytes_of(file: Path) -> bytes | None:
    try:
        return file.read_bytes()
    except OSError:
        return None


def file_checksum(file: Path) -> int | None:
    """Return the CRC-32 of a file, None when it cannot be read."""
    checksum = 0
    try:
        with file.open("rb") as opened:
            while chunk := opened.read(CHUNK):
                checksum = crc32(chunk, checksum)
    except OSError:
        return None
    return checksum


def kept_rows(folder: Path) -> int | None:
    """Return how many rows of a run are on the disk, brought there when they were not; None when none can be read."""
    try:
        for file in folder.glob("segment-*"):
            with file.open("rb") as opened:
                os.fsync(opened.fileno())
        return read_run(folder, ["t"]).rows
    except (ValueError, OSError):
        return None
