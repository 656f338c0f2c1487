"""Reserved room on the disk, so that on a full disk a session can be ended and people can sign out."""

import errno
import os
import secrets
import shutil
import tempfile
import threading
from pathlib import Path

from app.file_modes import OWNER_FILE

SIZE = 16 << 20  # bytes: more than a thousand transactions that close something
PART = 2 << 20  # bytes released at a time: another program may take them before we can use them
NEEDED = 1 << 20  # bytes that a closing transaction and the log's head take at most
HEADROOM = 16 << 20  # bytes that must stay free beside a refilled ballast
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}  # the disk, a quota, a limit of this process
BLOCK = 512  # bytes, the unit of `st_blocks`


class Ballast:
    """A file beside the database that reserves room: on a full disk, SQLite cannot even delete a row.

    It is released in parts when a closing transaction finds no room, and refilled when there is enough. Thread-safe.
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        self._one_at_a_time = threading.Lock()

    @property
    def size(self) -> int:
        """Bytes that are reserved now."""
        try:
            return self.file.stat().st_size
        except OSError:
            return 0

    def has_room(self) -> bool:
        """Return whether a closing transaction fits on the disk; tried by writing: free space ignores quotas."""
        try:
            with tempfile.TemporaryFile(dir=self.file.parent) as probe:
                _allocate(probe.fileno(), NEEDED)
        except OSError as error:
            return error.errno not in FULL
        return True

    def make_room(self) -> None:
        """Release parts until a closing transaction fits on the disk, or nothing is left."""
        with self._one_at_a_time:
            while not self.has_room() and self.size:
                os.truncate(self.file, max(0, self.size - PART))

    def refill(self) -> None:
        """Fill the ballast to SIZE when HEADROOM stays free beside it; otherwise leave it unchanged."""
        with self._one_at_a_time:
            before = self.size
            missing = SIZE - before
            if missing <= 0 or shutil.disk_usage(self.file.parent).free < missing + HEADROOM:
                return
            descriptor = os.open(self.file, os.O_RDWR | os.O_CREAT, OWNER_FILE)
            try:
                _allocate(descriptor, SIZE)
                os.fsync(descriptor)
            except OSError:  # a quota, or another program has taken the room
                os.ftruncate(descriptor, before)
            finally:
                os.close(descriptor)


def _allocate(descriptor: int, size: int) -> None:
    """Allocate `size` bytes on the disk for a file; raise OSError when there is no room."""
    if hasattr(os, "posix_fallocate"):
        os.posix_fallocate(descriptor, 0, size)
    if os.fstat(descriptor).st_blocks * BLOCK < size:  # this disk may compress zeros: write random bytes
        os.lseek(descriptor, 0, os.SEEK_SET)
        for _ in range(0, size, NEEDED):
            noise = memoryview(secrets.token_bytes(NEEDED))
            while noise:
                noise = noise[os.write(descriptor, noise) :]
        os.fsync(descriptor)
