"""A recording: written rows are read; a cut or changed byte loses only what comes after it, and is reported."""

import errno
import os
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

import app.recording.writer as recording_module
from app.faults import State
from app.messages import Tick
from app.process.ring import RING_SLOTS
from app.recording.format import SCALARS
from app.recording.reader import read_run
from app.recording.writer import RunWriter
from building import make_layout

CHANNELS, GESTURES = 6, 2
META = {"run_id": "r1", "kind": "rest", "layout": make_layout(CHANNELS).model_dump(mode="json"), "gestures": ["a", "b"]}


@pytest.fixture(autouse=True)
def _on_disk_at_once(monkeypatch):
    monkeypatch.setattr(recording_module, "WRITE_EVERY", 0.01)
    monkeypatch.setattr(recording_module, "SYNC_EVERY", 0.0)


def write_ticks(ring, count, run=1, first=0):
    values = np.zeros(CHANNELS, dtype=np.float32)
    tick = Tick(values=values, state=State.ARMED, driven_v=0.5)
    for i in range(first, first + count):
        values[:] = i + np.arange(CHANNELS) / 8
        tick.t, tick.t_device, tick.frame_seq, tick.x = 100 + i / 100, i / 100, i, 0.5 * i
        tick.score, tick.rate, tick.activation = [i, -i], [i + 0.5, 0.0], [0.25, 0.75]
        ring.write(tick, run, i / 100, i // 10, 0, 0)


def record(ring, folder, count, batches=4):
    """Return the folder of a closed run of `count` rows, written in some batches."""
    writer = RunWriter(folder, META, CHANNELS, GESTURES)
    writer.start(ring, ring.number, 1)
    for batch in range(batches):
        write_ticks(ring, count // batches, first=batch * (count // batches))
        wait_for(lambda goal=(batch + 1) * (count // batches): writer.rows >= goal)
    assert writer.close(ring.number) == (count, 0)
    assert writer.damage is None
    return folder


def wait_for(condition):
    for _ in range(2000):
        if condition():
            return
        threading.Event().wait(0.005)
    raise AssertionError("it did not happen within ten seconds")


@pytest.fixture
def cut_run(ring, tmp_path, monkeypatch):
    """Return the folder of a run that was written, synced, but never made compact: as after a power cut."""
    monkeypatch.setattr(recording_module, "compact", lambda *_: (_ for _ in ()).throw(OSError("no room")))
    return record(ring, tmp_path / "cut", 400)


def assert_rows_begin(run, longest):
    """Assert that the rows are the first ones of what `write_ticks` wrote."""
    n = run.rows
    assert n <= longest
    i = np.arange(n)
    assert run.columns["frame_seq"].tolist() == i.tolist()
    assert run.columns["x"].tolist() == (0.5 * i).tolist()
    assert run.columns["run_t"].tolist() == (i / 100).tolist()
    if n:
        assert (run.columns["values"] == i[:, np.newaxis] + np.arange(CHANNELS, dtype=np.float32) / 8).all()
        assert (run.columns["score"] == np.stack([i, -i], axis=1)).all()
        assert (run.columns["activation"] == [0.25, 0.75]).all()


def test_what_is_recorded_is_read(ring, tmp_path):
    folder = record(ring, tmp_path / "run", 400)
    run = read_run(folder)
    assert run.damage is None
    assert run.meta == META
    assert run.rows == 400
    assert run.dropped == 0
    assert_rows_begin(run, 400)
    assert set(run.columns) == {*SCALARS, "score", "rate", "activation", "values"}
    assert run.columns["state"].tolist() == [State.ARMED] * 400
    assert run.columns["cue"].tolist() == [i // 10 for i in range(400)]
    assert run.columns["driven_v"].tolist() == [0.5] * 400
    assert sorted(file.name for file in folder.iterdir()) == ["end.json", "run.json", "run.parquet"]


def test_only_the_rows_of_the_run_are_recorded(ring, tmp_path):
    write_ticks(ring, 10, run=0)
    writer = RunWriter(tmp_path / "run", META, CHANNELS, GESTURES)
    writer.start(ring, ring.number, 3)
    write_ticks(ring, 20, run=3)
    until = ring.number
    write_ticks(ring, 10, run=4)
    assert writer.close(until) == (20, 0)


def test_rows_without_frame_and_without_gestures(ring, tmp_path):
    writer = RunWriter(tmp_path / "run", META, CHANNELS, 0)
    writer.start(ring, 0, 1)
    ring.write(Tick(t=1.0), 1, 0.0, -1, 0, 0)
    ring.write(Tick(t=2.0, values=np.ones(CHANNELS, dtype=np.float32)), 1, 1.0, -1, 0, 0)
    writer.close(ring.number)
    run = read_run(tmp_path / "run")
    assert run.columns["has_frame"].tolist() == [0, 1]
    assert np.isnan(run.columns["values"][0]).all()
    assert run.columns["score"].shape == (2, 0)
    assert run.frames()["t"].tolist() == [2.0]


def test_an_empty_run_is_a_run(ring, tmp_path):
    writer = RunWriter(tmp_path / "run", META, CHANNELS, GESTURES)
    writer.start(ring, ring.number, 1)
    assert writer.close(ring.number) == (0, 0)
    run = read_run(tmp_path / "run")
    assert (run.rows, run.damage) == (0, None)
    assert run.columns["values"].shape == (0, CHANNELS)


def test_ticks_that_the_writer_missed_are_counted(ring, tmp_path):
    writer = RunWriter(tmp_path / "run", META, CHANNELS, GESTURES)
    write_ticks(ring, RING_SLOTS + 50)
    writer.start(ring, 0, 1)
    assert writer.close(ring.number) == (RING_SLOTS, 50)
    assert read_run(tmp_path / "run").dropped == 50


def test_many_segments_are_one_run(ring, tmp_path, monkeypatch):
    monkeypatch.setattr(recording_module, "SEGMENT_SIZE", 20_000)
    removed = []
    monkeypatch.setattr(Path, "unlink", lambda self, **_: removed.append(self) or os.unlink(self))
    run = read_run(record(ring, tmp_path / "run", 400))
    assert sum(file.name.endswith(".arrows") for file in removed) > 2
    assert_rows_begin(run, 400)
    assert run.rows == 400


def test_a_folder_is_recorded_into_once(ring, tmp_path):
    record(ring, tmp_path / "run", 40)
    with pytest.raises(FileExistsError, match="begin a new one"):
        RunWriter(tmp_path / "run", META, CHANNELS, GESTURES)


def test_no_recording_is_one_sentence(tmp_path):
    with pytest.raises(ValueError, match="there is no recording in this folder"):
        read_run(tmp_path)


def test_a_run_that_was_not_closed_is_read_and_described(cut_run):
    run = read_run(cut_run)
    assert run.rows == 400
    assert_rows_begin(run, 400)
    assert run.meta == META
    assert str(run.damage) == "The recording was cut: what had been written by then is here."


@pytest.mark.parametrize("name", ["segment-0000.arrows", "segment-0000.check", "run.json"])
def test_cut_at_any_byte_the_longest_whole_beginning_is_read(cut_run, name):
    file = cut_run / name
    content = file.read_bytes()
    rows = []
    for length in sorted({*range(0, len(content), max(1, len(content) // 60)), len(content) - 1}):
        file.write_bytes(content[:length])
        run = read_run(cut_run)
        assert_rows_begin(run, 400)
        assert run.damage
        rows.append(run.rows)
    if name.endswith(".arrows"):
        assert rows == sorted(rows)
        assert set(rows) >= {0, 100, 200, 300, 400}
    else:
        assert set(rows) == {400}
        assert run.meta == META


def test_both_are_said_of_a_cut_run_whose_description_was_changed(cut_run):
    file = cut_run / "run.json"
    file.write_bytes(file.read_bytes().replace(b"r1", b"r2"))
    run = read_run(cut_run)
    assert run.meta == META
    assert ("was cut" in str(run.damage), "run.json was changed" in str(run.damage)) == (True, True)


@pytest.mark.parametrize("name", ["run.parquet", "run.json", "end.json"])
def test_a_closed_run_cut_at_any_byte_raises_nothing(ring, tmp_path, name):
    folder = record(ring, tmp_path / "run", 400)
    file = folder / name
    content = file.read_bytes()
    for length in sorted({*range(0, len(content), max(1, len(content) // 25)), len(content) - 1}):
        file.write_bytes(content[:length])
        run = read_run(folder)
        assert run.damage
        assert_rows_begin(run, 400)
        if name != "run.parquet":
            assert run.rows == 400
            assert run.meta == META


@pytest.mark.parametrize("name", ["segment-0000.arrows", "segment-0000.check"])
def test_before_a_changed_byte_of_a_cut_run_all_rows_are_read(cut_run, name):
    file = cut_run / name
    content = bytearray(file.read_bytes())
    for place in range(0, len(content), max(1, len(content) // 60)):
        content[place] ^= 0x10
        file.write_bytes(content)
        run = read_run(cut_run)
        assert "changed" in str(run.damage)
        assert_rows_begin(run, 400)
        content[place] ^= 0x10


@pytest.mark.parametrize("name", ["run.parquet", "run.json", "end.json"])
def test_a_changed_byte_of_a_closed_run_is_reported(ring, tmp_path, name):
    folder = record(ring, tmp_path / "run", 400)
    file = folder / name
    content = bytearray(file.read_bytes())
    for place in range(0, len(content), max(1, len(content) // 40)):
        content[place] ^= 0x01
        file.write_bytes(content)
        assert read_run(folder).damage, place
        content[place] ^= 0x01


def test_scalars_alone_are_those_of_the_whole_run_or_damaged(ring, tmp_path):
    folder = record(ring, tmp_path / "run", 400)
    whole, file = read_run(folder), folder / "run.parquet"
    content = bytearray(file.read_bytes())
    assert read_run(folder, SCALARS).columns["values"].size == 0 < whole.columns["values"].size
    for place in range(0, len(content), max(1, len(content) // 40)):
        content[place] ^= 0x01
        file.write_bytes(content)
        scalars = read_run(folder, SCALARS)
        for name in SCALARS:
            assert scalars.damage or np.array_equal(scalars.columns[name], whole.columns[name], equal_nan=True)
        content[place] ^= 0x01
    file.write_bytes(content)
    scalars = read_run(folder, SCALARS)
    assert (scalars.meta, scalars.rows, scalars.damage) == (whole.meta, whole.rows, None)
    few = read_run(folder, ["t", "x"]).columns
    assert {name for name, column in few.items() if column.size} == {"t", "x"}
    assert np.array_equal(few["x"], whole.columns["x"])


@pytest.mark.parametrize("failing", ["write", "fsync"])
def test_a_failing_disk_is_reported_once_and_not_tried_again(ring, tmp_path, monkeypatch, failing):
    writer = RunWriter(tmp_path / "run", META, CHANNELS, GESTURES)
    real, calls = getattr(os, failing), []

    def fail_once(*given):
        calls.append(given)
        if len(calls) == 5:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return real(*given)

    monkeypatch.setattr(recording_module.os, failing, fail_once)
    writer.start(ring, 0, 1)
    for batch in range(1000):
        write_ticks(ring, 10, first=10 * batch)
        if writer.done:
            break
        threading.Event().wait(0.01)
    writer.close(ring.number)
    monkeypatch.undo()
    assert writer.damage is not None
    rows = writer.rows
    assert str(writer.damage).startswith("The recording could not be written (No space left on device)")
    run = read_run(tmp_path / "run")
    assert_rows_begin(run, writer._written)
    assert run.rows >= rows  # what was said is on the disk; what was written after the last fsync may be, too
    assert run.damage == writer.damage


@pytest.mark.parametrize("noted", ["The disk is full.", '{"tex', "7", '{"file": "a"}'])
def test_what_an_earlier_version_noted_or_what_was_damaged_is_shown_as_it_is(cut_run, noted):
    (cut_run / "damaged.txt").write_text(noted)
    assert str(read_run(cut_run).damage) == noted


def test_no_room_for_the_compact_form_leaves_the_segments(cut_run):
    assert not (cut_run / "run.parquet").exists()
    assert not list(cut_run.glob("*.part"))


ENCODE = """
import sys
import numpy as np
from app.messages import TICK
from app.recording.writer import Encoder
before = set(sys.modules)
encoder = Encoder(b"{}", 52, 4)
encoder.schema()
encoder.batch(np.zeros(10, dtype=TICK))
print(*sorted({name.split(".")[0] for name in set(sys.modules) - before}))
"""


def test_the_first_rows_load_no_library():
    """The encoder runs beside the control loop, and nothing may be loaded while somebody drives."""
    seen = subprocess.run([sys.executable, "-c", ENCODE], capture_output=True, text=True, check=True)
    assert seen.stdout.split() == []
