"""The bytes of a board: both formats there and back, junk, losses, wraps, restarts and clocks that differ."""

import math
import random
from binascii import crc_hqx

import numpy as np
import pytest
from hardware.shirt.wired_board import cobs_encoded, frame_bytes, stream
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.shirt.serial_bytes import (
    CHECKSUM_START,
    FOREIGN,
    FrameDecoder,
    LineDecoder,
    cobs_decoded,
    decode_frame,
    is_text,
    numbers_in,
)
from app.layout import MAX_CHANNELS
from folders import ROOT

RATE = 100.0
PERIOD = 10_000  # microseconds
CHANNELS = 3
STEP = st.integers(-32767, 32767)
VALUES = st.lists(STEP, min_size=1, max_size=MAX_CHANNELS)
DECODERS = pytest.mark.parametrize("decoder", [FrameDecoder, LineDecoder])


def pieces_of(content, dice):
    """Cut bytes at random places, as a port hands them on."""
    at = 0
    while at < len(content):
        step = dice.randint(1, 60)
        yield content[at : at + step]
        at += step


def sent(count, seq=0, microseconds=0, period=PERIOD):
    return [(seq + i, microseconds + period * i, (i % 1000, -i % 1000, 7)) for i in range(count)]


# The bytes of a frame.


@pytest.mark.parametrize(
    ("plain", "encoded"),
    [("00", "0101"), ("0000", "010101"), ("11220033", "0311220233"), ("11000000", "0211010101"), ("01", "0201")],
)
def test_cobs_in_numbers_of_its_authors(plain, encoded):
    assert cobs_encoded(bytes.fromhex(plain)).hex() == encoded
    assert cobs_decoded(bytes.fromhex(encoded)).hex() == plain


@given(st.binary(max_size=600) | st.integers(1, 600).map(lambda count: count * b"\x07"))
def test_cobs_comes_back_and_holds_no_zero(plain):
    encoded = cobs_encoded(plain)
    assert 0 not in encoded
    assert cobs_decoded(encoded) == plain


@given(st.binary(max_size=300).map(lambda piece: piece.replace(b"\0", b"\x01")))
def test_what_is_no_cobs_is_none_and_never_an_error(piece):
    decoded = cobs_decoded(piece)
    assert decoded is None or len(decoded) <= len(piece)


def test_the_checksum_is_that_of_the_protocol():
    assert crc_hqx(b"123456789", CHECKSUM_START) == 0x29B1


def test_the_page_of_protocols_shows_the_bytes_of_a_frame():
    shown = frame_bytes(1, 10_000, (512, -1, -32768)).hex(" ")
    assert f"`{shown}`" in (ROOT / "docs" / "protocols.md").read_text(encoding="utf-8")


@given(st.integers(0, 2**16 - 1), st.integers(0, 2**32 - 1), VALUES)
def test_a_frame_comes_back(seq, microseconds, steps):
    encoded = frame_bytes(seq, microseconds, steps)
    assert encoded.count(0) == 1
    decoded = decode_frame(encoded[:-1])
    assert decoded[:2] == (seq, microseconds)
    assert decoded[2].dtype == np.float32
    assert decoded[2].tolist() == steps


def test_the_smallest_number_is_a_missing_value():
    values = decode_frame(frame_bytes(1, 2, (-32768, -32767, 0))[:-1])[2]
    assert math.isnan(values[0])
    assert values[1:].tolist() == [-32767, 0]


def test_no_frame_survives_a_changed_bit():
    whole = frame_bytes(513, 70_000, (512, 0, -3))
    for bit in range(8 * (len(whole) - 1)):
        changed = bytearray(whole)
        changed[bit // 8] ^= 1 << bit % 8
        assert FrameDecoder(CHANNELS, RATE).feed(b"\0" + bytes(changed), 0.0) == [], bit


def test_a_frame_of_another_shirt_says_how_many_sensors_it_has():
    decoder = FrameDecoder(CHANNELS, RATE)
    assert decoder.feed(stream([(0, 0, (1, 2))]), 0.0) == []
    assert (decoder.junk, decoder.lost) == (1, 0)
    assert "the shirt sends 2 sensors, its layout has 3" in str(decoder.refusal)


# Streams.


@given(st.lists(st.tuples(STEP, STEP, STEP), min_size=1, max_size=30), st.randoms(use_true_random=False))
def test_frames_come_back_however_the_port_cuts_them(values, dice):
    decoder = FrameDecoder(CHANNELS, RATE)
    content = stream((seq, PERIOD * seq, steps) for seq, steps in enumerate(values))
    frames = [frame for piece in pieces_of(content, dice) for frame in decoder.feed(piece, 1.5)]
    assert [frame.seq for frame in frames] == list(range(len(values)))
    assert [tuple(frame.values.tolist()) for frame in frames] == values
    assert [frame.t_device for frame in frames] == pytest.approx([0.01 * i for i in range(len(values))])
    assert (decoder.lost, decoder.junk) == (0, 0)


NUMBER = st.floats(width=32, allow_nan=False, allow_infinity=False)
SEPARATOR = st.sampled_from([",", ";", "\t", " ", ", ", "; ", " \t", "   "])


@given(st.lists(st.tuples(NUMBER, NUMBER, NUMBER), min_size=1), SEPARATOR, st.sampled_from(["\n", "\r\n"]), st.data())
def test_lines_come_back_however_they_are_separated_and_cut(values, separator, end, data):
    decoder = LineDecoder(CHANNELS, RATE)
    words = data.draw(st.sampled_from(["", "a,b,c" + end, "Ready" + end, "left elbow; right elbow" + end + end]))
    lines = [separator.join(repr(number) for number in numbers) for numbers in values]
    content = ("98,3" + end + words + "".join(line + end for line in lines)).encode()
    dice = data.draw(st.randoms(use_true_random=False))
    frames = [frame for piece in pieces_of(content, dice) for frame in decoder.feed(piece, 1.5)]
    assert [tuple(frame.values.tolist()) for frame in frames] == values
    assert [frame.seq for frame in frames] == list(range(len(values)))
    assert [frame.t_device for frame in frames] == pytest.approx([0.01 * i for i in range(len(values))])
    assert (decoder.lost, decoder.junk) == (0, 0)


NAN = math.nan


@pytest.mark.parametrize(
    ("line", "numbers"),
    [
        (b"1,2,3", [1, 2, 3]),
        (b"1;2;3;", [1, 2, 3]),
        (b" 1  2 3 \r", [1, 2, 3]),
        (b"1\t\t3", [1, NAN, 3]),
        (b"\t2\t3", [NAN, 2, 3]),
        (b",2,", [NAN, 2, NAN]),
        (b",,", [NAN, NAN, NAN]),
        (b"1, nan, -NaN", [1, NAN, NAN]),
        (b"inf -inf ovf", [NAN, NAN, NAN]),
        (b"1e39 -1e999 .5", [NAN, NAN, 0.5]),
        (b"+1.5 -2. 3e-2", [1.5, -2.0, 0.03]),
        (b"1 2", [1, 2]),
        (b"1 2 3 4", [1, 2, 3, 4]),
        (b"1,2,x", None),
        (b"1_0,2,3", None),
        (b"0x10 2 3", None),
        (b"1,5;2;3", None),
        (b"a: 1, 2, 3", None),
        ("１,2,3".encode(), None),
        (b"1,-,3", None),
        (b"\xff\xfe", None),
    ],
)
def test_what_a_line_holds(line, numbers):
    found = numbers_in(line, CHANNELS)
    assert found == numbers if numbers is None else found == pytest.approx(numbers, nan_ok=True)


@pytest.mark.parametrize(
    ("line", "is_of_words"),
    [
        (b"", True),
        (b" \r", True),
        (b"right_elbow_1,right_elbow_2,t1", True),
        ("Dehnung Ärmel\tx,".encode(), True),
        (b"Sensor 5", False),
        (b"nan,nan,nan", False),
        (b",,", False),
        (b"\xc3\x28abc", False),
        (b"\x01\x02abc", False),
    ],
)
def test_a_header_is_told_from_numbers_and_from_junk(line, is_of_words):
    assert is_text(line) == is_of_words


def test_the_first_line_is_left_out_because_it_may_have_lost_a_digit():
    decoder = LineDecoder(CHANNELS, RATE)
    assert [frame.values.tolist() for frame in decoder.feed(b"12,498,731\n512,498,731\n", 0.0)] == [[512, 498, 731]]
    decoder.begin_anew()
    assert decoder.feed(b"2,498,731\n", 0.01) == []
    assert (decoder.lost, decoder.junk) == (0, 0)


def test_a_line_that_is_no_frame_is_lost_and_its_time_stays_empty():
    decoder = LineDecoder(CHANNELS, RATE)
    frames = decoder.feed(b"\n1,2,3\n1,2\n1,2,x\n4,5,6\n", 0.0)
    assert [(frame.seq, frame.t_device) for frame in frames] == [(0, 0.0), (3, pytest.approx(0.03))]
    assert (decoder.lost, decoder.junk, decoder.refusal) == (2, 2, FOREIGN)
    decoder.feed(b"1,2\n", 0.0)
    assert "the shirt sends 2 sensors, its layout has 3" in str(decoder.refusal)


def test_a_pause_moves_on_the_grid_of_lines_and_a_burst_does_not():
    decoder = LineDecoder(CHANNELS, RATE)
    t, times = 5.0, []
    for pause, lines in ((0.01, 1), (0.05, 5), (0.09, 9), (0.3, 1), (0.01, 1), (0.4, 40), (2.5, 3), (0.01, 1)):
        t += pause
        content = b"\n" * (not times) + lines * b"1,2,3\n"
        times += [frame.t_device for frame in decoder.feed(content, t)]
    steps = np.rint(np.diff(times) * RATE).astype(int)
    assert steps.tolist() == [1] * 14 + [30] + [1] * 41 + [248] + [1] * 3
    assert decoder.lost == 0


@DECODERS
@pytest.mark.parametrize("seed", range(3))
def test_100000_bytes_of_junk_give_no_frame_and_the_next_good_one_comes(decoder, seed):
    dice = random.Random(seed)
    made = decoder(CHANNELS, RATE)
    junk = dice.randbytes(100_000)
    assert [frame for piece in pieces_of(junk, dice) for frame in made.feed(piece, 0.0)] == []
    assert made.junk > 100
    assert made.refusal is not None
    good = stream([(9, 0, (1, 2, 3))]) if decoder is FrameDecoder else b"\n1,2,3\n"
    assert [frame.values.tolist() for frame in made.feed(good, 1.0)] == [[1, 2, 3]]


@DECODERS
def test_a_stream_without_an_end_fills_no_memory(decoder):
    made = decoder(CHANNELS, RATE)
    for _ in range(1000):
        assert made.feed(1000 * b"1", 0.0) == []
    assert len(made._pieces._rest) < 4000


# The board's counts.


@given(st.sets(st.integers(1, 298), max_size=60), st.integers(0, 2**16 - 1), st.integers(0, 2**32 - 1))
def test_lost_frames_are_counted_also_where_both_counts_wrap(gone, seq, microseconds):
    decoder = FrameDecoder(CHANNELS, RATE)
    kept = [frame for i, frame in enumerate(sent(300, seq, microseconds)) if i not in gone]
    frames = decoder.feed(stream(kept), 0.0)
    seen = [i for i in range(300) if i not in gone]
    assert [frame.seq - seq for frame in frames] == seen
    assert [frame.t_device - 1e-6 * microseconds for frame in frames] == pytest.approx([0.01 * i for i in seen])
    assert decoder.lost == len(gone)


def test_both_counts_wrap_in_an_hour_and_a_half_at_100_hz():
    decoder = FrameDecoder(CHANNELS, RATE)
    frames = decoder.feed(stream((i, PERIOD * i, (0, 0, 0)) for i in range(0, 540_000, 90)), 0.0)
    assert decoder.lost == 89 * (len(frames) - 1)
    assert frames[-1].seq == 539_910
    assert frames[-1].t_device == pytest.approx(5399.1)


@pytest.mark.parametrize("ran", [0.5, 60.0, 2400.0, 3600.0, 4294.0, 4294.9, 86_400.0])
@pytest.mark.parametrize("gap", [0.12, 1.7, 30.0])
def test_a_board_that_begins_anew_is_no_loss_and_its_time_goes_on(ran, gap):
    decoder = FrameDecoder(CHANNELS, RATE)
    count = round(ran * RATE)
    (before,) = decoder.feed(stream([(count, PERIOD * count, (1, 2, 3))]), 100.0)
    first, second = decoder.feed(stream([(0, 900, (1, 2, 3)), (1, 10_900, (1, 2, 3))]), 100.0 + gap)
    assert decoder.lost == 0
    assert first.seq - before.seq == round(gap * RATE)
    assert first.t_device - before.t_device == pytest.approx(gap)
    assert second.seq - first.seq == 1
    assert second.t_device - first.t_device == pytest.approx(0.01)


def test_a_board_that_never_counts_has_the_times_of_arrival():
    decoder = FrameDecoder(CHANNELS, RATE)
    frames = [frame for i in range(5) for frame in decoder.feed(stream([(7, 7, (1, 2, 3))]), 0.05 * i)]
    assert [frame.seq for frame in frames] == [7, 12, 17, 22, 27]
    assert np.diff([frame.t_device for frame in frames]) == pytest.approx(4 * [0.05])


@pytest.mark.parametrize("error", [-0.005, 0.005])
def test_a_clock_that_runs_wrong_is_not_late_and_a_delay_is(error):
    decoder = FrameDecoder(CHANNELS, RATE)
    dice = random.Random(1)
    decoder.feed(b"\0", 0.0)
    for i in range(20_000):
        t = 0.01 * i + dice.uniform(0.0, 0.02)
        assert decoder.feed(frame_bytes(i, round(PERIOD * i * (1 + error)), (1, 2, 3)), t)
        assert decoder.late_by == 0.0
    for i in range(20_000, 20_010):
        decoder.feed(frame_bytes(i, round(PERIOD * i * (1 + error)), (1, 2, 3)), 0.01 * i + 0.3)
        assert decoder.late_by == pytest.approx(0.3, abs=0.03)
