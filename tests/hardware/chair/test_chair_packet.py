"""The bytes of the link to a chair, held against docs/protocols.md (9) with struct and hmac alone; and its key."""

import hashlib
import hmac
import math
import os
import stat
import struct
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.chair.key import SENTENCES, Key, KeyRefused, new_key, read_key, write_key
from app.hardware.chair.link_texts import refusal_text
from app.hardware.chair.packet import (
    ChairCommand,
    Telemetry,
    decode_command,
    decode_telemetry,
    encode_command,
    encode_hello,
    encode_telemetry,
    is_hello,
)

KEY = Key(513, bytes(range(32)))
NONCE = b"\xa0\xa1\xa2\xa3\xa4\xa5\xa6\xa7"
DIGEST = b"\x01\x02\x03\x04\x05\x06\x07\x08"
COMMAND = ChairCommand(5, 513, 0xDEADBEEF, 2**40 + 3, 123_456_789_012, 0.5, -1.25, 0.75, 1.5, DIGEST)
TELEMETRY = Telemetry(
    2, 513, 0xDEADBEEF, 2**40 + 3, 987_654_321, NONCE, 0.5, -1.25, 0.875, 1, 4, 1, 1, 0.375, -1.5, DIGEST
)

u8, u16, u32, u64 = (st.integers(0, 2**bits - 1) for bits in (8, 16, 32, 64))
f32 = st.floats(width=32)
eight = st.binary(min_size=8, max_size=8)
keys = st.builds(Key, u16, st.binary(min_size=32, max_size=32))


def written_anew(body, secret, nonce=b""):
    return body + hmac.new(secret, body + nonce, hashlib.sha256).digest()[:16]


def same(one, other):
    """Compare field by field; two NaN count as equal."""
    return [repr(field) for field in one] == [repr(field) for field in other]


def test_a_command_has_exactly_the_bytes_of_the_contract():
    body = b"BMIW" + bytes([1, 5]) + (513).to_bytes(2, "little") + (0xDEADBEEF).to_bytes(4, "little")
    body += (2**40 + 3).to_bytes(8, "little") + (123_456_789_012).to_bytes(8, "little")
    body += struct.pack("<f", 0.5) + struct.pack("<f", -1.25) + struct.pack("<f", 0.75) + struct.pack("<f", 1.5)
    body += b"\x01\x02\x03\x04\x05\x06\x07\x08"
    assert len(body) == 52
    assert encode_command(COMMAND, KEY, NONCE) == written_anew(body, KEY.secret, NONCE)
    assert decode_command(written_anew(body, KEY.secret, NONCE), KEY, NONCE) == COMMAND


def test_a_telemetry_has_exactly_the_bytes_of_the_contract():
    body = b"BMIT" + bytes([2, 2]) + (513).to_bytes(2, "little") + (0xDEADBEEF).to_bytes(4, "little")
    body += (2**40 + 3).to_bytes(8, "little") + (987_654_321).to_bytes(8, "little") + NONCE
    body += struct.pack("<f", 0.5) + struct.pack("<f", -1.25) + struct.pack("<f", 0.875) + bytes([1, 4, 1, 1])
    body += struct.pack("<f", 0.375) + struct.pack("<f", -1.5) + DIGEST
    assert len(body) == 68
    assert encode_telemetry(TELEMETRY, KEY) == written_anew(body, KEY.secret)
    assert decode_telemetry(written_anew(body, KEY.secret), KEY) == TELEMETRY


def test_a_hello_has_exactly_the_bytes_of_the_contract():
    hello = b"BMIH\x01\x00\x01\x02\x00\x00\x00\x00"
    assert encode_hello(513) == hello
    assert is_hello(hello, 513)
    for position in range(12):
        flipped = bytearray(hello)
        flipped[position] ^= 1
        assert not is_hello(bytes(flipped), 513)
    assert not is_hello(hello + b"\x00", 513)
    assert not is_hello(hello[:11], 513)
    assert not is_hello(b"", 513)


@given(keys, eight, st.tuples(u8, u32, u64, u64, f32, f32, f32, f32, eight))
def test_any_command_comes_back_as_it_was(key, nonce, fields):
    flags, *rest = fields
    command = ChairCommand(flags, key.id, *rest)
    datagram = encode_command(command, key, nonce)
    assert len(datagram) == 68
    assert same(decode_command(datagram, key, nonce), command)


@given(keys, st.tuples(u8, u32, u64, u64, eight, f32, f32, f32, u8, u8, u8, u8, f32, f32, eight))
def test_any_telemetry_comes_back_as_it_was(key, fields):
    state, *rest = fields
    telemetry = Telemetry(state, key.id, *rest)
    datagram = encode_telemetry(telemetry, key)
    assert len(datagram) == 84
    assert same(decode_telemetry(datagram, key), telemetry)


def test_an_unknown_charge_is_not_a_number():
    telemetry = decode_telemetry(encode_telemetry(TELEMETRY._replace(battery=math.nan), KEY), KEY)
    assert math.isnan(telemetry.battery)


def test_every_flipped_bit_is_seen():
    for datagram, decode in (
        (encode_command(COMMAND, KEY, NONCE), lambda bytes_: decode_command(bytes_, KEY, NONCE)),
        (encode_telemetry(TELEMETRY, KEY), lambda bytes_: decode_telemetry(bytes_, KEY)),
    ):
        assert decode(datagram) is not None
        for bit in range(8 * len(datagram)):
            flipped = bytearray(datagram)
            flipped[bit // 8] ^= 1 << bit % 8
            assert decode(bytes(flipped)) is None, bit


@given(st.binary(max_size=80))
def test_junk_is_nothing(junk):
    assert decode_command(junk, KEY, NONCE) is None
    assert decode_telemetry(junk, KEY) is None
    assert not is_hello(junk, KEY.id)


def test_a_command_counts_for_one_nonce_one_key_and_one_way_only():
    datagram = encode_command(COMMAND, KEY, NONCE)
    assert decode_command(datagram, KEY, b"another!") is None
    assert decode_command(datagram, KEY, b"") is None
    assert decode_command(datagram, new_key(513), NONCE) is None
    assert decode_command(datagram, Key(514, KEY.secret), NONCE) is None
    assert decode_telemetry(datagram, KEY) is None
    assert decode_command(encode_telemetry(TELEMETRY, KEY), KEY, NONCE) is None


@pytest.mark.parametrize(
    ("at", "value"), [(0, b"BMIX"), (4, b"\x00"), (4, b"\x03"), (6, b"\x02\x02")], ids=["magic", "0", "3", "key"]
)
def test_a_right_tag_over_a_wrong_head_does_not_help(at, value):
    for datagram, nonce in ((encode_command(COMMAND, KEY, NONCE), NONCE), (encode_telemetry(TELEMETRY, KEY), b"")):
        body = bytearray(datagram[:-16])
        body[at : at + len(value)] = value
        forged = written_anew(bytes(body), KEY.secret, nonce)
        assert decode_command(forged, KEY, NONCE) is None
        assert decode_telemetry(forged, KEY) is None


def test_a_telemetry_of_version_1_counts_no_more():
    body = struct.pack("<4sBBHIQQ8sfffBBH", b"BMIT", 1, *TELEMETRY[:11], 0)
    assert decode_telemetry(written_anew(body, KEY.secret), KEY) is None
    longer = struct.pack("<4sBBHIQQ8sfffBBBBff8s", b"BMIT", 1, *TELEMETRY)
    assert decode_telemetry(written_anew(longer, KEY.secret), KEY) is None


def test_only_whole_frames_count():
    for datagram, nonce in ((encode_command(COMMAND, KEY, NONCE), NONCE), (encode_telemetry(TELEMETRY, KEY), b"")):
        whole = len(datagram)
        for length in (*range(whole), whole + 1, whole + 2, 2 * whole):
            cut = (datagram * 2)[:length]
            assert decode_command(cut, KEY, nonce) is None, length
            assert decode_telemetry(cut, KEY) is None, length


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
        *("", "\n", SECRET.hex(), f"{LINE}0", LINE[:-1], LINE.replace(" ", "  "), LINE.replace(" ", "\t")),
        *(f"-1 {SECRET.hex()}", f"65536 {SECRET.hex()}", f"999999 {SECRET.hex()}", f"x {SECRET.hex()}"),
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


@pytest.mark.parametrize("problem", SENTENCES)
def test_a_refusal_is_the_same_sentence_with_and_without_the_catalogue(problem):
    refused = KeyRefused(problem, Path("chair.key"), "No such file or directory")
    assert str(refusal_text(refused)) == str(refused)


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
