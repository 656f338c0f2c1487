"""Writes a run to disk while it is recorded: a thread reads the ring, so that the loop never waits for the disk."""

import json
import os
import threading
from contextlib import suppress
from pathlib import Path
from typing import Any
from zlib import crc32

from app.clock import monotonic
from app.files import write_atomically
from app.process.ring import TickRing
from app.realtime import RECORDER_PRIORITY, take_priority
from app.recording.arrow import Encoder, compact
from app.recording.format import (
    DAMAGE_FILE,
    END_FILE,
    END_OF_STREAM,
    LOST_AT_MOST,
    META_FILE,
    PARQUET_FILE,
    SEGMENT,
    SEGMENT_CHECK,
    check_record,
    end_bytes,
)

WRITE_EVERY = 0.08  # s
SYNC_EVERY = LOST_AT_MOST - WRITE_EVERY  # s: the next write is WRITE_EVERY later
SEGMENT_SIZE = 32_000_000  # bytes, after which the next segment begins


class RunWriter:
    """Records the ticks of one run from the ring.

    Attributes
    ----------
    rows : int
        Ticks on the disk so far: written and synced, so that a cut of the power leaves them.
    dropped : int
        Ticks that were overwritten in the ring before they could be written.
    damage : str
        One sentence on why the recording is damaged; empty while it is whole.
    """

    def __init__(self, folder: Path, meta: dict[str, Any], n_channels: int, n_gestures: int) -> None:
        """Make the folder and `run.json`; raise OSError when that fails, FileExistsError for a folder with a run."""
        folder.mkdir(parents=True, exist_ok=True)
        if (folder / META_FILE).exists():
            raise FileExistsError(f"{folder.name}: there is a recording of this name already, begin a new run")
        self.folder = folder
        self.rows = self.dropped = 0
        self._written = 0  # ticks, of which the last may not be on the disk yet
        self.damage = ""
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
        self.damage = f"The recording could not be written ({reason}): free some disk space, then start a new run."
        for descriptor in self._descriptors:
            with suppress(OSError):
                os.close(descriptor)
        self._descriptors = []
        with suppress(OSError):
            write_atomically(self.folder / DAMAGE_FILE, self.damage.encode())

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
