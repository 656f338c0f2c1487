"""Free room on the disk of the database and the recordings, and the sentence about it."""

import asyncio
import logging
import shutil
from dataclasses import dataclass
from pathlib import Path

from app.disk_room import LITTLE_ROOM, NO_ROOM, ROOM_TO_RECORD
from app.news import News, Notify
from app.refusals import DiskFull
from app.store.files.ballast import Ballast
from app.texts import Figure, Text

WATCH_EVERY = 1.0  # s: people are notified of a full disk within 2 s

logger = logging.getLogger("bodydrive")


@dataclass(frozen=True, slots=True)
class DiskRoom:
    """The free room on a disk."""

    free: int  # bytes
    message: Text | None  # what to do about it, None while there is enough


def disk_room(folder: Path) -> DiskRoom:
    """Return how much room is left on the disk of `folder`."""
    free = shutil.disk_usage(folder).free
    if free < NO_ROOM:
        return DiskRoom(free, Text("store-disk-full"))
    if free < LITTLE_ROOM:
        shown = Figure(round(free / 1e9, 1), 1)  # rounded, so that the text changes only when its sentence does
        return DiskRoom(free, Text("store-disk-little", free=shown, needed=Figure(ROOM_TO_RECORD / 1e9, 1)))
    return DiskRoom(free, None)


def require_room_to_record(folder: Path) -> None:
    """Raise DiskFull when nothing could be recorded on the disk of `folder`."""
    free = disk_room(folder).free
    if free < ROOM_TO_RECORD:
        needed = Figure(ROOM_TO_RECORD / 1e6)
        raise DiskFull(Text("store-disk-no-session", free=free // 1_000_000, needed=needed))


class DiskWatch:
    """Checks the disk every second: notifies the pages when the sentence changes, and refills the ballast."""

    def __init__(self, folder: Path, ballast: Ballast, notify: Notify) -> None:
        self._folder = folder
        self._ballast = ballast
        self._notify = notify
        self._message: Text | None = None
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
                self._notify(News(what="disk"))
            await asyncio.sleep(WATCH_EVERY)

    def _check(self) -> Text | None:
        self._ballast.refill()
        return disk_room(self._folder).message
