"""The bytes of the link to a chair, held against docs/protocols.md (9) with struct and hmac alone."""

import hashlib
import hmac
import math
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.chair.key import Key, new_key
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
TELEMETRY = Telemetry(2, 513, 0xDEADBEEF, 2**40 + 3, 987_654_321, NONCE, 0.5, -1.25, 0.875, 1, 4)

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
    body = b"BMIT" + bytes([1, 2]) + (513).to_bytes(2, "little") + (0xDEADBEEF).to_bytes(4, "little")
    body += (2**40 + 3).to_bytes(8, "little") + (987_654_321).to_bytes(8, "little") + NONCE
    body += struct.pack("<f", 0.5) + struct.pack("<f", -1.25) + struct.pack("<f", 0.875) + bytes([1, 4, 0, 0])
    assert len(body) == 52
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


@given(keys, st.tuples(u8, u32, u64, u64, eight, f32, f32, f32, u8, u8))
def test_any_telemetry_comes_back_as_it_was(key, fields):
    state, *rest = fields
    telemetry = Telemetry(state, key.id, *rest)
    datagram = encode_telemetry(telemetry, key)
    assert len(datagram) == 68
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
    ("at", "value"), [(0, b"BMIX"), (4, b"\x00"), (4, b"\x02"), (6, b"\x02\x02")], ids=["magic", "0", "2", "key"]
)
def test_a_right_tag_over_a_wrong_head_does_not_help(at, value):
    for datagram, nonce in ((encode_command(COMMAND, KEY, NONCE), NONCE), (encode_telemetry(TELEMETRY, KEY), b"")):
        body = bytearray(datagram[:52])
        body[at : at + len(value)] = value
        forged = written_anew(bytes(body), KEY.secret, nonce)
        assert decode_command(forged, KEY, NONCE) is None
        assert decode_telemetry(forged, KEY) is None


def test_only_whole_frames_count():
    for datagram, nonce in ((encode_command(COMMAND, KEY, NONCE), NONCE), (encode_telemetry(TELEMETRY, KEY), b"")):
        for length in (*range(68), 69, 70, 136):
            cut = (datagram * 2)[:length]
            assert decode_command(cut, KEY, nonce) is None, length
            assert decode_telemetry(cut, KEY) is None, length
