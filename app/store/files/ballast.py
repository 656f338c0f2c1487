"""Room on the disk that is kept back, so that on a full disk a session can be ended and people can sign out."""

import errno
import os
import secrets
import shutil
import tempfile
import threading
from pathlib import Path

from app.file_modes import OWNER_FILE

SIZE = 16 << 20  # bytes: more than a thousand transactions that close something
PART = 2 << 20  # bytes given up at a time: another program may take what becomes free before we can use it
NEEDED = 1 << 20  # bytes that a closing transaction and the log's head take at most
HEADROOM = 16 << 20  # bytes that stay free beside a ballast that was made whole again
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}  # the disk, a quota, a limit of this process
BLOCK = 512  # bytes, the unit of `st_blocks`


class Ballast:
    """A file beside the database that only takes room. SQLite cannot even delete a row when the disk is full.

    It is given up in parts when a closing transaction finds no room, and made whole again when there is enough.
    From any thread.
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        self._one_at_a_time = threading.Lock()

    @property
    def size(self) -> int:
        """Bytes that are kept back now."""
        try:
            return self.file.stat().st_size
        except OSError:
            return 0

    def has_room(self) -> bool:
        """Tell whether a closing transaction fits on the disk, by trying it: a quota shows in no figure."""
        try:
            with tempfile.TemporaryFile(dir=self.file.parent) as probe:
                _allocate(probe.fileno(), NEEDED)
        except OSError as error:
            return error.errno not in FULL
        return True

    def make_room(self) -> None:
        """Give up parts until a closing transaction fits on the disk, or nothing is left to give."""
        with self._one_at_a_time:
            while not self.has_room() and self.size:
                os.truncate(self.file, max(0, self.size - PART))

    def refill(self) -> None:
        """Make the ballast, or make it whole again, where enough room stays free beside it; else leave it as it is."""
        with self._one_at_a_time:
            before = self.size
            missing = SIZE - before
            if missing <= 0 or shutil.disk_usage(self.file.parent).free < missing + HEADROOM:
                return
            descriptor = os.open(self.file, os.O_RDWR | os.O_CREAT, OWNER_FILE)
            try:
                _allocate(descriptor, SIZE)
                os.fsync(descriptor)
            except OSError:  # a quota, or another program was quicker
                os.ftruncate(descriptor, before)
            finally:
                os.close(descriptor)


def _allocate(descriptor: int, size: int) -> None:
    """Let a file take `size` bytes on the disk, in blocks that are really its own; raise OSError where it cannot."""
    if hasattr(os, "posix_fallocate"):
        os.posix_fallocate(descriptor, 0, size)
    if os.fstat(descriptor).st_blocks * BLOCK < size:  # a file of zeros may take no room on this disk; noise does
        os.lseek(descriptor, 0, os.SEEK_SET)
        for _ in range(0, size, NEEDED):
            noise = memoryview(secrets.token_bytes(NEEDED))
            while noise:
                noise = noise[os.write(descriptor, noise) :]
        os.fsync(descriptor)
