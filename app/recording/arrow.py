"""Encodes recordings with Arrow: the batches of an IPC stream, and the Parquet file of a closed run."""

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pa_parquet
from numpy.typing import NDArray

from app.messages import TICK
from app.recording.format import META_KEY, PER_CHANNEL, PER_GESTURE, SCALARS, rows_to_columns

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
