import struct
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from app.hardware.shirt.packet import decode, encode, refusal

FLOATS = arrays(np.float32, st.integers(1, 64), elements=st.floats(width=32, allow_nan=True, allow_infinity=True))
FRACTIONS = arrays(np.float32, st.integers(1, 64), elements=st.floats(-1, 1, width=32))
SEQ = st.integers(0, 2**32 - 1)
TIME = st.integers(0, 10**13)  # microseconds


@given(SEQ, TIME, FLOATS)
def test_float32_comes_back_bit_for_bit(seq, microseconds, values):
    packet = encode(seq, microseconds / 1e6, values)
    got_seq, got_time, got = decode(packet, len(packet), len(values))
    assert (got_seq, got_time) == (seq, microseconds)
    assert got.tobytes() == values.tobytes()


@given(SEQ, FRACTIONS)
def test_int16_comes_back_within_half_a_step(seq, values):
    packet = encode(seq, 0.0, values, int16=True)
    got_seq, _, got = decode(packet, len(packet), len(values))
    assert got_seq == seq
    assert got.dtype == np.float32
    np.testing.assert_allclose(got, values, atol=0.5001 / 32767)


@given(FLOATS, st.booleans(), st.data())
def test_any_flipped_byte_is_refused(values, int16, data):
    packet = bytearray(encode(7, 1.0, values, int16))
    packet[data.draw(st.integers(0, len(packet) - 1))] ^= data.draw(st.integers(1, 255))
    assert decode(packet, len(packet), len(values)) is None
    assert refusal(packet, len(packet), len(values))


@given(st.binary(max_size=400), st.integers(1, 64))
def test_junk_never_raises_and_is_never_taken(junk, channels):
    assert decode(junk, len(junk), channels) is None
    assert refusal(junk, len(junk), channels)


@given(FLOATS, st.data())
def test_a_packet_cut_or_continued_is_refused(values, data):
    packet = encode(1, 0.0, values)
    size = data.draw(st.integers(0, len(packet) - 1))
    assert decode(packet, size, len(values)) is None
    assert decode(packet + b"\0", len(packet) + 1, len(values)) is None


def test_the_bytes_are_those_of_the_protocol():
    body = struct.pack("<4sBBHIQ2f", b"SHRT", 1, 0, 2, 3, 4_000_000, 0.5, -2.0)
    assert encode(3, 4.0, np.array([0.5, -2.0], dtype=np.float32)) == body + struct.pack("<I", zlib.crc32(body))
    body = struct.pack("<4sBBHIQ2h", b"SHRT", 1, 1, 2, 3, 4_000_000, 32767, -32767)
    assert encode(3, 4.0, np.array([1.0, -5.0], dtype=np.float32), int16=True) == body + struct.pack(
        "<I", zlib.crc32(body)
    )


def test_another_number_of_channels_is_refused_and_said_in_words():
    packet = encode(0, 0.0, np.zeros(40, dtype=np.float32))
    assert decode(packet, len(packet), 52) is None
    assert "sends 40 sensors, its layout has 52" in str(refusal(packet, len(packet), 52))


def test_unknown_versions_and_flags_are_refused_though_their_checksum_is_right():
    for version, flags, word in ((2, 0, "version 2"), (1, 4, "flags 0x04")):
        body = struct.pack("<4sBBHIQf", b"SHRT", version, flags, 1, 0, 0, 1.0)
        packet = body + struct.pack("<I", zlib.crc32(body))
        assert decode(packet, len(packet), 1) is None
        assert word in str(refusal(packet, len(packet), 1))


@pytest.mark.parametrize("values", [np.zeros(0, np.float32), np.zeros(65, np.float32), np.zeros((2, 2), np.float32)])
def test_what_no_shirt_has_cannot_be_sent(values):
    with pytest.raises(ValueError, match="1 to 64 channels"):
        encode(0, 0.0, values)


def test_a_time_before_zero_cannot_be_sent():
    with pytest.raises(ValueError, match="counts from 0 up"):
        encode(0, -1.0, np.zeros(1, np.float32))
