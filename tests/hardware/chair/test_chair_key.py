"""The key of a chair: one line, readable by its owner only, never overwritten and never shown."""

import os
import stat

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.chair.key import Key, KeyRefused, new_key, read_key, write_key

SECRET = bytes(range(32))
LINE = f"513 {SECRET.hex()}"


@pytest.fixture
def key_file(tmp_path):
    """Return a function that writes a file which only its owner can read."""

    def write(content, mode=0o600):
        file = tmp_path / "chair.key"
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        file.chmod(mode)
        return file

    return write


def refusal(file):
    with pytest.raises(KeyRefused) as refused:
        read_key(file)
    sentence = str(refused.value)
    assert sentence
    assert "\n" not in sentence
    assert SECRET.hex() not in sentence
    assert SECRET.hex()[:16] not in sentence
    return sentence


def test_a_key_file_is_one_line_for_its_owner_only(tmp_path):
    file = tmp_path / "513.key"
    before = os.umask(0)
    try:
        write_key(file, Key(513, SECRET))
    finally:
        os.umask(before)
    assert file.read_bytes() == LINE.encode() + b"\n"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert read_key(file) == Key(513, SECRET)


@given(st.integers(0, 65_535), st.binary(min_size=32, max_size=32))
def test_any_key_comes_back(tmp_path_factory, key_id, secret):
    file = tmp_path_factory.mktemp("keys") / "a.key"
    write_key(file, Key(key_id, secret))
    assert read_key(file) == Key(key_id, secret)


def test_what_a_hand_wrote_is_understood(key_file):
    assert read_key(key_file(LINE)) == Key(513, SECRET)
    assert read_key(key_file(f"{LINE.upper()}\r\n")) == Key(513, SECRET)


@pytest.mark.parametrize("mode", [0o640, 0o604, 0o660, 0o602, 0o620, 0o601, 0o610, 0o644, 0o777])
def test_a_key_that_others_can_reach_is_refused(key_file, mode):
    assert "chmod 600" in refusal(key_file(LINE, mode))


@pytest.mark.parametrize(
    "content",
    [
        "",
        "\n",
        SECRET.hex(),
        f"{LINE}0",
        LINE[:-1],
        LINE.replace(" ", "  "),
        LINE.replace(" ", "\t"),
        f"-1 {SECRET.hex()}",
        f"65536 {SECRET.hex()}",
        f"999999 {SECRET.hex()}",
        f"x {SECRET.hex()}",
        f"513 {'g' * 64}",
        f"{LINE}\n{LINE}\n",
        b"\xff\xfe" + LINE.encode(),
        b"\x00" * 100,
    ],
)
def test_what_is_no_key_is_refused(key_file, content):
    refusal(key_file(content))


def test_a_file_that_is_not_there_or_no_file_is_refused(tmp_path):
    assert str(tmp_path / "none.key") in refusal(tmp_path / "none.key")
    refusal(tmp_path)


def test_a_key_is_never_written_over(tmp_path):
    file = tmp_path / "1.key"
    write_key(file, Key(1, SECRET))
    with pytest.raises(FileExistsError):
        write_key(file, new_key(1))
    assert read_key(file) == Key(1, SECRET)


def test_nothing_half_written_is_left_behind(tmp_path, monkeypatch):
    def full(_handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("app.hardware.chair.key.os.fsync", full)
    with pytest.raises(OSError, match="No space left"):
        write_key(tmp_path / "1.key", new_key(1))
    assert list(tmp_path.iterdir()) == []


def test_no_two_keys_are_alike():
    keys = [new_key(1) for _ in range(100)]
    assert len({key.secret for key in keys}) == 100
    assert all(len(key.secret) == 32 for key in keys)


def test_a_key_does_not_tell_itself():
    key = Key(513, SECRET)
    for words in (repr(key), str(key), f"{key}", f"{[key]}", f"{key!r}"):
        assert "513" in words
        assert SECRET.hex() not in words
        assert repr(SECRET) not in words
    assert key.line == LINE
