"""The shirt over UDP, and which sender it listens to."""

import socket

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.shirts import RATE, UdpCase, small_layout

from app.clock import MonotonicClock
from app.hardware.base import HardwareError
from app.hardware.shirt.packet import encode
from app.hardware.shirt.sender_choice import MOST, SenderChoice, address_text
from app.hardware.shirt.udp import UdpConfig, UdpShirt

WAIT = 2.0  # s


@pytest.fixture
def source(tmp_path):
    made = UdpCase(tmp_path)
    made.shirt.open()
    yield made
    made.shirt.close()
    made.end()


@pytest.fixture
def stranger():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        yield other


def test_junk_is_passed_over_and_counted(source):
    for junk in (b"", b"hello", b"x" * 2000, encode(0, 0.0, np.zeros(52, dtype=np.float32))):
        source.send_bytes(junk)
    source.send(0)
    assert source.shirt.read(WAIT).seq == 0
    assert source.shirt.junk == 4
    assert "4 datagrams refused (the shirt sends 52 sensors, its layout has 3" in str(source.shirt.description())


def test_before_any_frame_the_words_say_what_is_wrong_with_what_comes(source):
    source.send_bytes(encode(0, 0.0, np.zeros(52, dtype=np.float32)))
    assert source.shirt.read(0.05) is None
    assert str(source.shirt.description()).startswith("No frames from a shirt on 127.0.0.1:")
    assert "sends 52 sensors" in str(source.shirt.description())


@pytest.mark.parametrize(
    ("sent", "read", "lost", "words"),
    [
        ((10, 11, 15, 13, 15, 16), [10, 11, 15, 16], 3, ", 3 frames lost"),
        ((2**32 - 2, 2**32 - 1, 0, 1), [2**32 - 2, 2**32 - 1, 0, 1], 0, ""),
    ],
)
def test_gaps_are_counted_late_frames_dropped_and_the_counter_may_wrap(source, sent, read, lost, words):
    for seq in sent:
        source.send(seq)
    assert [source.shirt.read(WAIT).seq for _ in read] == read
    assert source.shirt.read(0.0) is None
    assert source.shirt.lost == lost
    assert words in str(source.shirt.description())


def test_a_second_sender_is_not_mixed_in(source, stranger):
    source.send(0)
    assert source.shirt.read(WAIT).seq == 0
    source.send(500, stranger)
    source.send(1)
    assert source.shirt.read(WAIT).seq == 1
    assert source.shirt.lost == 0


def test_after_any_silence_only_a_person_makes_another_sender_the_shirt(tmp_path, stranger):
    """Safety S23: forged frames after two seconds of silence were armed and drove."""
    clock = FakeClock(10.0)
    source = UdpCase(tmp_path)
    shirt = source.shirt = UdpShirt(UdpConfig(kind="udp", port=0, layout=small_layout(), sample_rate=RATE), clock)
    shirt.open()
    source.send(0)
    assert shirt.read(WAIT).seq == 0
    clock.time += 3600.0
    stranger.bind(("127.0.0.1", 0))
    other = f"127.0.0.1:{stranger.getsockname()[1]}"
    for seq in range(77, 80):
        source.send(seq, stranger)
        assert shirt.read(0.1) is None
    assert str(shirt.description()).endswith(f", 3 frames of another sender ({other}) left out.")
    assert not shirt.use_sender("127.0.0.1:1")
    assert shirt.use_sender(other)
    source.send(80, stranger)
    assert shirt.read(WAIT).seq == 80
    assert shirt.lost == 0
    source.send(1)
    assert shirt.read(0.1) is None
    shirt.close()
    source.end()


def test_a_port_that_is_taken_is_one_sentence(source):
    config = UdpConfig(kind="udp", port=source.shirt.address[1], layout=small_layout())
    with pytest.raises(HardwareError, match=r"cannot be received on 127.0.0.1:\d+ .*: end the other program"):
        UdpShirt(config, FakeClock()).open()


def test_an_address_that_is_not_ours_is_one_sentence():
    config = UdpConfig(kind="udp", host="192.0.2.1", port=0, layout=small_layout())
    with pytest.raises(HardwareError, match="use an address of this machine"):
        UdpShirt(config, FakeClock()).open()


def test_it_reaches_no_further_than_the_configured_host(source):
    assert source.shirt.address[0] == "127.0.0.1"
    assert UdpConfig(kind="udp", layout=small_layout()).host == "127.0.0.1"


def test_waits_that_differ_each_time_are_kept_and_cut_short_by_a_frame(source):
    clock = MonotonicClock()
    for wait in (0.02, 0.013, 0.013, 0.013, 0.007, 0.02):
        begun = clock.now()
        assert source.shirt.read(wait) is None
        assert clock.now() - begun >= wait - 1e-3
    for seq, wait in enumerate((WAIT, WAIT, WAIT, WAIT / 2, WAIT / 3)):
        source.send(seq)
        assert source.shirt.read(wait).seq == seq


SHIRT, FORGER = ("10.0.0.2", 4000), ("10.0.0.3", 4000)


def test_the_first_sender_is_the_shirt_however_long_it_is_silent():
    choice = SenderChoice()
    assert choice.name == choice.other == ""
    assert choice.accept(SHIRT, 0, silent=True)
    assert not choice.accept(FORGER, 0, silent=True)
    assert not choice.accept((SHIRT[0], 4001), 0, silent=True)
    assert choice.accept(SHIRT, 0, silent=True)
    assert (choice.name, choice.other_frames) == ("10.0.0.2:4000", 2)


def test_another_sender_is_named_and_a_person_may_take_it():
    choice = SenderChoice()
    choice.accept(SHIRT, 0, silent=False)
    for _ in range(3):
        choice.accept(FORGER, 0, silent=False)
    assert choice.other == "10.0.0.3:4000"
    assert not choice.use("10.0.0.9:4000")
    assert choice.accept(SHIRT, 0, silent=False)
    assert choice.use("10.0.0.3:4000")
    assert (choice.name, choice.other, choice.other_frames) == ("10.0.0.3:4000", "", 0)
    assert not choice.accept(SHIRT, 0, silent=False)


def test_a_device_that_was_started_again_may_come_from_elsewhere_only_after_silence():
    choice = SenderChoice()
    assert choice.accept(SHIRT, 7, silent=True)
    assert not choice.accept(FORGER, 8, silent=False)
    assert not choice.accept(FORGER, 7, silent=True)
    assert choice.accept(FORGER, 8, silent=True)
    assert not choice.accept(SHIRT, 7, silent=True)


def test_a_thousand_senders_fill_no_memory():
    choice = SenderChoice()
    choice.accept(SHIRT, 0, silent=False)
    for port in range(1, 1001):
        choice.accept(("10.0.0.9", port), 0, silent=False)
    assert choice.other_frames == 1000
    assert len(choice._frames) == MOST


def test_addresses_are_written_as_people_write_them():
    assert address_text(("::1", 5252, 0, 0)) == "[::1]:5252"
