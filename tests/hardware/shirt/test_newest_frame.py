import threading

import pytest

from app.hardware.base import HardwareError
from app.hardware.shirt import newest_frame as newest_module
from app.hardware.shirt.newest_frame import LARGEST_SEQ, NewestFrame, read_newest, write_newest

AHEAD = 10


@pytest.fixture
def file(tmp_path):
    made = tmp_path / "shirt-1.newest"
    write_newest(made, (0, 0))
    return made


@pytest.fixture
def opened(file):
    made = []

    def open_one():
        made.append(NewestFrame(file, AHEAD))
        made[-1].open()
        return made[-1]

    yield open_one
    for newest in made:
        newest.close()


def taken(newest, boot, seq):
    """Accept a frame as soon as the number on the disk allows it."""
    pause = threading.Event()
    for _ in range(1000):
        if newest.is_new(boot, seq) and newest.accept(boot, seq):
            return True
        pause.wait(0.005)
    return False


def test_a_frame_is_taken_once(opened):
    newest = opened()
    assert taken(newest, 1, 0)
    assert not newest.is_new(1, 0)
    assert taken(newest, 1, 5)
    assert [newest.is_new(*place) for place in ((0, 9), (1, 0), (1, 5), (1, 6), (2, 0))] == [False] * 3 + [True] * 2


def test_after_a_regular_end_exactly_the_next_frame_is_new(opened, file):
    first = opened()
    taken(first, 3, 41)
    first.close()
    assert read_newest(file) == (3, 41)
    second = opened()
    assert not second.is_new(3, 41)
    assert second.is_new(3, 42)


def test_after_a_crash_nothing_that_was_taken_is_new(opened, file):
    crashed = opened()
    for seq in range(35):
        assert taken(crashed, 1, seq)
        place = read_newest(file)
        assert place >= (1, seq)  # the disk is ahead of what was taken: whenever it dies, the frame is old
        assert place <= (1, seq + AHEAD)
    after = opened()
    assert not after.is_new(1, 34)
    assert after.is_new(1, 35 + AHEAD)
    assert after.is_new(2, 0)


def test_a_disk_that_cannot_be_written_lets_nothing_through_and_is_said(opened, file, monkeypatch):
    newest = opened()
    assert taken(newest, 1, 0)

    def full(_file, _place):
        raise OSError(28, "No space left on device")

    write = newest_module.write_newest
    monkeypatch.setattr(newest_module, "write_newest", full)
    assert newest.accept(1, 1)  # that was allowed before
    assert not newest.accept(2, 0)
    pause = threading.Event()
    while not newest.trouble:
        pause.wait(0.005)
    assert "No space left" in str(newest.trouble)
    assert not newest.accept(2, 0)
    monkeypatch.setattr(newest_module, "write_newest", write)
    assert taken(newest, 2, 0)
    assert newest.trouble is None


def test_the_last_seq_of_a_start_is_taken(opened):
    newest = opened()
    assert taken(newest, 1, LARGEST_SEQ)
    assert taken(newest, 2, 0)


@pytest.mark.parametrize("content", [None, "", "1", "1 2 3", "-1 0", "a b", "1 99999999999", "é 1"])
def test_a_note_that_says_nothing_opens_nothing(file, content):
    file.unlink()
    if content is not None:
        file.write_text(content)
    with pytest.raises(HardwareError, match="pair the shirt anew"):
        NewestFrame(file, AHEAD).open()
