"""Writes a run to disk while it is recorded: a thread reads the ring, so that the loop never waits for the disk.

The ticks become the batches of an Arrow IPC stream, and a closed run one Parquet file.
"""

import json
import os
import threading
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pa_parquet
from numpy.typing import NDArray

from app.clock import monotonic
from app.files import write_atomically
from app.messages import TICK
from app.process.ring import TickRing
from app.realtime import RECORDER_PRIORITY, take_priority
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
    SEGMENT_CHECK,
    check_record,
    end_bytes,
    rows_to_columns,
)
from app.texts import Text, to_document

WRITE_EVERY = 0.08  # s
SYNC_EVERY = LOST_AT_MOST - WRITE_EVERY  # s: the next write is WRITE_EVERY later
SEGMENT_SIZE = 32_000_000  # bytes, after which the next segment begins
ROW_GROUP = 4_000  # rows in memory while the segments become a Parquet file
CHUNK = 1 << 20  # bytes read at once for a checksum


class Encoder:
    """Encodes the ticks of one run as messages of an Arrow IPC stream."""

    def __init__(self, meta: bytes, n_channels: int, n_gestures: int) -> None:
        fields = [pa.field(name, pa.from_numpy_dtype(TICK[name])) for name in SCALARS]
        if n_gestures:  # Parquet knows no lists of length 0
            fields += [pa.field(name, pa.list_(pa.float64(), n_gestures)) for name in PER_GESTURE]
        fields.append(pa.field(PER_CHANNEL, pa.list_(pa.float32(), n_channels)))
        self._schema = pa.schema(fields, metadata={META_KEY: meta})
        self._n_channels, self._n_gestures = n_channels, n_gestures

    def schema(self) -> bytes:
        """Return the first message of a segment: the columns, and a copy of `run.json`."""
        return bytes(self._schema.serialize())

    def batch(self, rows: NDArray[np.void]) -> bytes:
        """Return ticks as one message."""
        columns = rows_to_columns(rows, self._n_channels, self._n_gestures)
        arrays = [_array(columns[field.name], field.type) for field in self._schema]
        return bytes(pa.record_batch(arrays, schema=self._schema).serialize())


def _array(column: NDArray[np.generic], kind: Any) -> Any:
    """Return an array on the memory of a contiguous column; `pa.array` may load pandas while somebody drives."""
    numbers_kind = kind if column.ndim == 1 else kind.value_type
    numbers: Any = pa.Array.from_buffers(numbers_kind, column.size, [None, pa.py_buffer(column)])
    return numbers if column.ndim == 1 else pa.FixedSizeListArray.from_arrays(numbers, kind.list_size)


def compact(segments: Sequence[Path], target: Path) -> int:
    """Write the segments as one Parquet file, atomically, and return its CRC-32; raise OSError when that fails."""
    part = target.with_suffix(".part")
    try:
        writer = None
        for rows in _row_groups(segments):
            if writer is None:
                # Hardly a number of a signal comes twice: dictionaries made the file larger, and took the most time.
                writer = pa_parquet.ParquetWriter(
                    part, rows.schema, compression="zstd", use_dictionary=False, write_page_checksum=True
                )
            writer.write_table(rows)
        if writer is not None:
            writer.close()
        with part.open("rb") as file:
            checksum = 0
            while chunk := file.read(CHUNK):
                checksum = crc32(chunk, checksum)
            os.fsync(file.fileno())
        part.replace(target)
    except pa.ArrowException as error:
        part.unlink(missing_ok=True)
        raise OSError(str(error)) from error
    except BaseException:
        part.unlink(missing_ok=True)
        raise
    return checksum


def _row_groups(segments: Sequence[Path]) -> Iterator[pa.Table]:
    """Yield the rows of all segments in groups; at least one group, which may be empty, so that the schema is known."""
    waiting: list[pa.RecordBatch] = []
    count, yielded = 0, False
    for segment in segments:
        with pa.OSFile(str(segment), "rb") as file, pa.ipc.open_stream(file) as stream:
            columns = stream.schema
            for batch in stream:
                waiting.append(batch)
                count += batch.num_rows
                if count >= ROW_GROUP:
                    yield pa.Table.from_batches(waiting, schema=columns)
                    waiting, count, yielded = [], 0, True
    if waiting or not yielded:
        yield pa.Table.from_batches(waiting, schema=columns)


class RunWriter:
    """Records the ticks of one run from the ring.

    Attributes
    ----------
    rows : int
        Ticks on the disk so far: written and synced, so that a cut of the power leaves them.
    dropped : int
        Ticks that were overwritten in the ring before they could be written.
    damage : Text or None
        Why the recording is damaged; None while it is whole.
    """

    def __init__(self, folder: Path, meta: dict[str, Any], n_channels: int, n_gestures: int) -> None:
        """Make the folder and `run.json`; raise OSError when that fails, FileExistsError for a folder with a run."""
        folder.mkdir(parents=True, exist_ok=True)
        if (folder / META_FILE).exists():
            raise FileExistsError(Text("recording-exists", folder=folder.name))
        self.folder = folder
        self.rows = self.dropped = 0
        self._written = 0  # ticks, of which the last may not be on the disk yet
        self.damage: Text | None = None
        self._meta = json.dumps(meta, separators=(",", ":"), sort_keys=True).encode()
        write_atomically(folder / META_FILE, self._meta)
        self._encoder = Encoder(self._meta, n_channels, n_gestures)
        self._descriptors: list[int] = []
        self._segment = 0
        self._size = 0
        self._until: int | None = None
        self._wake = threading.Event()
        self._thread: threading.Thread | None = None

    @property
    def done(self) -> bool:
        """Whether the recording is closed and on disk."""
        return self._thread is not None and not self._thread.is_alive()

    def start(self, ring: TickRing, after: int, run: int, real_time: bool = False) -> None:
        """Start to write the ticks of `run` after tick number `after`.

        `real_time`: request a priority just below that of the control loop. Without it, any program could preempt this
        thread while it holds the interpreter, and so delay the loop, which runs in the same process.
        """
        arguments = (ring, after, run, real_time)
        self._thread = threading.Thread(target=self._record, args=arguments, name="recorder", daemon=True)
        self._thread.start()

    def finish(self, until: int) -> None:
        """Close the recording when tick number `until` is written; `done` is true once it is closed."""
        self._until = until
        self._wake.set()

    def close(self, until: int) -> tuple[int, int]:
        """Close the recording, wait for it, and return the numbers of written and of dropped rows."""
        self.finish(until)
        self.wait()
        return self.rows, self.dropped

    def wait(self) -> None:
        """Wait until the recording is closed, after `finish` was called."""
        if self._thread is not None:
            self._thread.join()

    def _record(self, ring: TickRing, last: int, run: int, real_time: bool) -> None:
        if real_time:
            take_priority(RECORDER_PRIORITY)
        synced = monotonic()
        try:
            self._open_segment()
            while True:
                self._wake.wait(WRITE_EVERY)
                until = self._until
                last = self._write_new_ticks(ring, last, run)
                if monotonic() - synced >= SYNC_EVERY:
                    synced = monotonic()
                    self._sync()
                if until is not None and last >= until:
                    break
            self._close_segment()
        except Exception as error:  # in a thread, no caller would see it
            self._fail(error)
            return
        if real_time:
            take_priority(0)
        with suppress(OSError):  # without room for the Parquet file, the segments stay, which hold the same rows
            self._compact()

    def _write_new_ticks(self, ring: TickRing, last: int, run: int) -> int:
        ticks, missed = ring.since(last)
        self.dropped += missed
        if len(ticks):
            last = int(ticks["number"][-1])
            rows = ticks[ticks["run"] == run]
            if len(rows):
                self._write(self._encoder.batch(rows))
                self._written += len(rows)
        if self._size > SEGMENT_SIZE:
            self._close_segment()
            self._open_segment()
        return last

    def _open_segment(self) -> None:
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL
        for name in (SEGMENT, SEGMENT_CHECK):
            self._descriptors.append(os.open(self.folder / name.format(self._segment), flags, 0o600))
        self._segment += 1
        self._size = 0
        self._write(self._encoder.schema())
        self._sync()

    def _write(self, piece: bytes) -> None:
        segment, check = self._descriptors
        self._size += len(piece)
        _write_all(segment, piece)
        _write_all(check, check_record(self._size, piece))

    def _sync(self) -> None:
        for descriptor in self._descriptors:
            os.fsync(descriptor)
        self.rows = self._written

    def _close_segment(self) -> None:
        self._write(END_OF_STREAM)
        self._sync()
        for descriptor in self._descriptors:
            os.close(descriptor)
        self._descriptors = []

    def _fail(self, error: Exception) -> None:
        """Note the failure and close the files; do not retry: after a failed write the file's content is unknown."""
        reason = getattr(error, "strerror", None) or str(error)
        self.damage = Text("recording-not-written", reason=reason)
        for descriptor in self._descriptors:
            with suppress(OSError):
                os.close(descriptor)
        self._descriptors = []
        with suppress(OSError):
            write_atomically(self.folder / DAMAGE_FILE, json.dumps(to_document(self.damage)).encode())

    def _compact(self) -> None:
        segments = [self.folder / SEGMENT.format(number) for number in range(self._segment)]
        checksum = compact(segments, self.folder / PARQUET_FILE)
        checksums = {META_FILE: crc32(self._meta), PARQUET_FILE: checksum}
        write_atomically(self.folder / END_FILE, end_bytes(self.rows, self.dropped, checksums))
        for segment in segments:
            segment.unlink()
            segment.with_suffix(".check").unlink()


def _write_all(descriptor: int, content: bytes) -> None:
    """Write all bytes; on a nearly full disk, the first call writes a part and the next one raises OSError."""
    view = memoryview(content)
    while view:
        view = view[os.write(descriptor, view) :]
