"""Free room on the disk of the database and the recordings, and the sentence about it."""

import asyncio
import logging
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from app.disk_room import LITTLE_ROOM, NO_ROOM, ROOM_TO_RECORD
from app.refusals import DiskFull
from app.store.files.ballast import Ballast

WATCH_EVERY = 1.0  # s: people are notified of a full disk within 2 s

logger = logging.getLogger("bodydrive")


@dataclass(frozen=True, slots=True)
class DiskRoom:
    """The free room on a disk."""

    free: int  # bytes
    message: str  # what to do about it, empty while there is enough


def disk_room(folder: Path) -> DiskRoom:
    """Return how much room is left on the disk of `folder`."""
    free = shutil.disk_usage(folder).free
    if free < NO_ROOM:
        return DiskRoom(
            free,
            "The disk of the recordings is full: nothing more is recorded, driven or saved. The session can still be "
            "ended, and people can sign out. Make room on the computer that runs bodydrive.",
        )
    if free < LITTLE_ROOM:
        return DiskRoom(
            free,
            f"Only {free / 1e9:.1f} GB are free on the disk of the recordings, and below "
            f"{ROOM_TO_RECORD / 1e9:.1f} GB nothing is recorded or driven any more: make room.",
        )
    return DiskRoom(free, "")


def require_room_to_record(folder: Path) -> None:
    """Raise DiskFull when nothing could be recorded on the disk of `folder`."""
    free = disk_room(folder).free
    if free < ROOM_TO_RECORD:
        raise DiskFull(
            f"No session is opened: only {free // 1_000_000} MB are free on the disk of the recordings. Make "
            f"{ROOM_TO_RECORD / 1e6:.0f} MB free on the computer that runs bodydrive, then open it again."
        )


class DiskWatch:
    """Checks the disk every second: notifies the pages when the sentence changes, and refills the ballast."""

    def __init__(self, folder: Path, ballast: Ballast, notify: Callable[[str], None]) -> None:
        self._folder = folder
        self._ballast = ballast
        self._notify = notify
        self._message = ""
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin to check."""
        self._task = asyncio.create_task(self._watch())

    async def close(self) -> None:
        """Stop checking."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    async def _watch(self) -> None:
        while True:
            try:
                message = await asyncio.to_thread(self._check)
            except OSError:  # keep checking: a disk that is gone may come back
                logger.exception("The disk of the recordings could not be checked")
                message = self._message
            if message != self._message:
                self._message = message
                self._notify("disk")
            await asyncio.sleep(WATCH_EVERY)

    def _check(self) -> str:
        self._ballast.refill()
        return disk_room(self._folder).message
