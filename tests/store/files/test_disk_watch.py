"""How long a disk may be full until people are told, counted in the time that the watch waits, not in real time."""

import asyncio
import shutil
from pathlib import Path
from types import SimpleNamespace

import pytest

from app.api.live import picture_sender
from app.news import News
from app.store.files import disk_watch
from app.store.files.ballast import Ballast
from app.store.files.disk_watch import DiskWatch

TOLD_WITHIN = 2.0  # s, as promised
FULL, EMPTY = 10_000_000, 50_000_000_000  # bytes free


class FullAt:
    """A disk that becomes full at a moment, and time that goes on only while the watch waits."""

    def __init__(self, full: float) -> None:
        self.full = full
        self.time = 0.0
        self.told: list[float] = []

    def usage(self, _folder: Path) -> SimpleNamespace:
        return SimpleNamespace(free=FULL if self.time >= self.full else EMPTY)

    async def sleep(self, seconds: float) -> None:
        self.time += seconds
        if self.told or self.time > self.full + 10.0 * TOLD_WITHIN:  # nobody was told
            raise asyncio.CancelledError
        await asyncio.to_thread(lambda: None)

    def notify(self, news: News) -> None:
        assert news == News(what="disk")
        self.told.append(self.time)


@pytest.mark.parametrize("full", [0.001, 0.5, 0.999, 1.0, 7.3])  # s after the watch began
def test_open_pages_are_told_within_two_seconds_of_a_full_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, full: float
) -> None:
    disk = FullAt(full)
    monkeypatch.setattr(shutil, "disk_usage", disk.usage)
    monkeypatch.setattr(disk_watch, "asyncio", SimpleNamespace(sleep=disk.sleep, to_thread=asyncio.to_thread))
    watch = DiskWatch(tmp_path, Ballast(tmp_path), disk.notify)
    with pytest.raises(asyncio.CancelledError):
        asyncio.run(watch._watch())
    (told,) = disk.told
    assert full <= told
    assert told + picture_sender.EVERY - full < TOLD_WITHIN  # the next picture carries it to the pages
