"""The recorder brings its rows to the disk often enough that no more than half a second can be lost."""

import uuid
from pathlib import Path

import pytest
from recording.test_recording import CHANNELS, GESTURES, META, write_ticks

from app.process.ring import TickRing
from app.recording import writer as writer_module
from app.recording.writer import LOST_AT_MOST, RunWriter

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


def test_no_row_waits_longer_than_half_a_second_for_the_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ring = TickRing.create(f"bodydrive-test-{uuid.uuid4().hex}")
    ring.unlink()
    writer = RunWriter(tmp_path / "run", META, CHANNELS, GESTURES)
    turns = Turns(ring, writer)
    on_disk: list[float] = []  # when each row was brought to the disk

    def sync(_descriptor: int) -> None:
        on_disk.extend([turns.now] * (writer.rows - len(on_disk)))

    monkeypatch.setattr(writer_module, "monotonic", lambda: turns.now)
    monkeypatch.setattr(writer_module.os, "fsync", sync)
    monkeypatch.setattr(writer, "_wake", turns)
    writer._record(ring, 0, 1, real_time=False)
    ring.close()
    waited = [synced - came for came, synced in zip(turns.came, on_disk, strict=True)]
    assert LOST_AT_MOST - 0.1 < max(waited) <= LOST_AT_MOST
