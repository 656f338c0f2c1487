import os
import stat

import pytest

from app.files import write_atomically


def test_a_file_is_written_whole_and_replaced_whole(tmp_path):
    file = tmp_path / "new" / "plan.json"
    write_atomically(file, b"one")
    write_atomically(file, b"two")
    assert file.read_bytes() == b"two"
    assert os.listdir(file.parent) == ["plan.json"]
    assert stat.S_IMODE(file.stat().st_mode) & 0o400


def test_when_it_fails_the_old_file_stays_and_nothing_else(tmp_path, monkeypatch):
    file = tmp_path / "plan.json"
    write_atomically(file, b"old")

    def full(descriptor):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space"):
        write_atomically(file, b"new")
    assert file.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["plan.json"]
