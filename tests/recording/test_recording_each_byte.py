"""A recording that is cut at each byte, and one of which each bit is changed: the long forms of `test_recording.py`."""

import pytest
from recording.test_recording import META, assert_rows_begin, record

import app.recording.writer as recording_module
from app.recording.reader import read_run
from building import make_ring

pytestmark = [pytest.mark.long]

ROWS = 8
CLOSED, CUT = ("run.json", "run.parquet", "end.json"), ("run.json", "segment-0000.arrows", "segment-0000.check")


@pytest.fixture(params=["closed", "cut"])
def folder(request, tmp_path, monkeypatch):
    """Return the folder of a closed run, and of one whose recorder was killed before it made the compact form."""
    ring = make_ring()
    if request.param == "cut":
        monkeypatch.setattr(recording_module, "compact", lambda *_: (_ for _ in ()).throw(OSError("no room")))
    made = record(ring, tmp_path / request.param, ROWS, batches=2)
    ring.close()
    return made


def files_of(folder):
    return [folder / name for name in (CLOSED if folder.name == "closed" else CUT)]


def test_cut_at_each_byte_the_longest_whole_beginning_is_read(folder):
    assert sorted(file.name for file in folder.iterdir()) == sorted(file.name for file in files_of(folder))
    for file in files_of(folder):
        content, rows = file.read_bytes(), []
        for length in range(len(content)):
            file.write_bytes(content[:length])
            run = read_run(folder)
            assert run.damage, (file.name, length)
            assert_rows_begin(run, ROWS)
            rows.append(run.rows)
        file.write_bytes(content)
        assert rows == sorted(rows), file.name
        if file.suffix == ".arrows":
            assert set(rows) == {0, ROWS // 2, ROWS}
        elif file.suffix != ".parquet":
            assert set(rows) == {ROWS}


@pytest.mark.parametrize("bit", range(8))
def test_each_changed_bit_is_noticed_and_no_wrong_row_is_read(folder, bit):
    known = read_run(folder).damage
    for file in files_of(folder):
        content = bytearray(file.read_bytes())
        for place in range(len(content)):
            content[place] ^= 1 << bit
            file.write_bytes(content)
            run = read_run(folder)
            assert run.damage != known, (file.name, place)
            if folder.name == "cut":  # the rows and facts of a closed one are marked as not to be relied on
                assert_rows_begin(run, ROWS)
                assert run.meta == META
            content[place] ^= 1 << bit
        file.write_bytes(content)
