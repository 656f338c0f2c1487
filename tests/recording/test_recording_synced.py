"""The recorder brings its rows to the disk often enough that no more than half a second can be lost."""

import os
import shutil
from pathlib import Path

import pytest
from recording.test_recording import CHANNELS, GESTURES, META, write_ticks

from app.process.ring import TickRing
from app.recording import writer as writer_module
from app.recording.format import LOST_AT_MOST
from app.recording.reader import read_run
from app.recording.writer import RunWriter

TURNS = 40


class Turns:
    """What the recorder waits for between its looks: the clock moves on, and a tick comes at the beginning."""

    def __init__(self, ring: TickRing, writer: RunWriter) -> None:
        self.now = 100.0
        self.came: list[float] = []  # when each row came
        self._ring, self._writer = ring, writer

    def wait(self, timeout: float) -> None:
        write_ticks(self._ring, 1, first=len(self.came))
        self.came.append(self.now)
        self.now += timeout
        if len(self.came) == TURNS:
            self._writer.finish(self._ring.number)

    def set(self) -> None:
        """Do nothing: it does not sleep."""


def test_no_row_waits_longer_than_half_a_second_for_the_disk(
    ring: TickRing, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer = RunWriter(tmp_path / "run", META, CHANNELS, GESTURES)
    turns = Turns(ring, writer)
    on_disk: list[float] = []  # when each row was brought to the disk

    def sync(_descriptor: int) -> None:
        on_disk.extend([turns.now] * (writer._written - len(on_disk)))

    monkeypatch.setattr(writer_module, "monotonic", lambda: turns.now)
    monkeypatch.setattr(os, "fsync", sync)
    monkeypatch.setattr(writer, "_wake", turns)
    writer._record(ring, 0, 1, real_time=False)
    waited = [synced - came for came, synced in zip(turns.came, on_disk, strict=True)]
    assert LOST_AT_MOST - 0.1 < max(waited) <= LOST_AT_MOST


def test_the_rows_that_are_said_are_on_the_disk_whenever_the_power_fails(
    ring: TickRing, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of each file, what was there at its last fsync is all that a cut of the power is sure to leave."""
    folder, left = tmp_path / "run", tmp_path / "left"
    writer = RunWriter(folder, META, CHANNELS, GESTURES)
    turns = Turns(ring, writer)
    synced: dict[int, int] = {}  # size of a file by its number, at its last fsync
    too_few: list[tuple[int, int]] = []
    wait = turns.wait

    def sync(descriptor: int) -> None:
        known = os.fstat(descriptor)
        synced[known.st_ino] = known.st_size

    def cut_and_wait(timeout: float) -> None:
        shutil.rmtree(left, ignore_errors=True)
        left.mkdir()
        for file in folder.iterdir():
            kept = synced.get(file.stat().st_ino, 0) if file.suffix in {".arrows", ".check"} else None
            (left / file.name).write_bytes(file.read_bytes()[:kept])
        rows = read_run(left).rows
        if rows < writer.rows:
            too_few.append((rows, writer.rows))
        wait(timeout)

    monkeypatch.setattr(writer_module, "monotonic", lambda: turns.now)
    monkeypatch.setattr(os, "fsync", sync)
    monkeypatch.setattr(turns, "wait", cut_and_wait)
    monkeypatch.setattr(writer, "_wake", turns)
    writer._record(ring, 0, 1, real_time=False)
    assert (too_few, writer.rows) == ([], TURNS)
