"""The shirt on a cable: its port, what it says of itself, and a cable that is pulled and put in again."""

import errno
import sys
import termios
import threading
import time

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.shirts import FramesCase, LinesCase, small_layout
from hardware.shirt.wired_board import WiredBoard, stream

from app.clock import MonotonicClock
from app.hardware.base import HardwareError
from app.hardware.registry import make_shirt, parse_shirt
from app.hardware.shirt import kind, serial_line
from app.hardware.shirt.kind import NO_CABLE
from app.pipeline.loop import ControlLoop
from app.pipeline.opening import reason
from app.pipeline.setup import NO_SHIRT, Setup

WAIT = 5.0  # s
MOST_CUTS = 30
BOTH = pytest.mark.parametrize("source", [FramesCase, LinesCase], indirect=True)


@pytest.fixture
def source(request, tmp_path):
    made = getattr(request, "param", FramesCase)(tmp_path, FakeClock(7.0))
    made.shirt.open()
    yield made
    made.shirt.close()
    made.end()


@pytest.fixture
def plugs_anywhere(monkeypatch):
    """Return what gives a line its old name when it is put in again, and let it be tried at once."""
    before = serial_line.open_line

    def name_follows(board):
        def open_line(config):
            if not board.is_in:
                raise FileNotFoundError(errno.ENOENT, "no such line")
            return before(config.model_copy(update={"device": board.device}))

        monkeypatch.setattr(serial_line, "open_line", open_line)
        monkeypatch.setattr(serial_line, "REOPEN_AFTER", 0.01)

    return name_follows


def wait_until_it_is_back(shirt):
    """Wait until a shirt has opened the line again that it lost; nothing is sent meanwhile."""
    for _ in range(1000):
        if "is gone" not in str(shirt.description()):
            return
        time.sleep(0.005)
        assert shirt.read(0.005) is None
    raise AssertionError(str(shirt.description()))


@BOTH
def test_every_frame_of_ten_seconds_comes_through_the_port(source):
    numbers = []
    for _ in range(20):
        source.let_come(50)
        numbers += [source.shirt.read(WAIT).values[0] for _ in range(50)]
    assert numbers == list(range(1000))
    assert source.shirt.lost == 0
    assert str(source.shirt.description()) == f"Shirt on {source.board.device}, 3 sensors."


def test_the_port_has_the_baud_rate_of_the_configuration():
    board = WiredBoard()
    layout = small_layout().model_dump(mode="json")
    for baud, speed in ((115_200, termios.B115200), (1_000_000, termios.B1000000), (2_000_000, termios.B2000000)):
        config = {"kind": "serial", "device": board.device, "baud": baud, "layout": layout}
        shirt = make_shirt(parse_shirt(config), MonotonicClock())
        shirt.open()
        assert termios.tcgetattr(board.line)[4] == speed
        shirt.close()
    board.pull()


def test_losses_and_what_is_no_frame_are_counted_and_said(source):
    content = stream((seq, 10_000 * seq, (seq, 1, 2)) for seq in (0, 1, 5))
    source.board.send_bytes(content + b"junk\0" + stream([(6, 60_000, (6, 1))]))
    assert [source.shirt.read(WAIT).seq for _ in range(3)] == [0, 1, 5]
    assert source.shirt.read(0.01) is None
    assert source.shirt.lost == 3
    assert str(source.shirt.description()) == (
        f"Shirt on {source.board.device}, 3 sensors, 3 frames lost, "
        "2 times something else arrived (the shirt sends 2 sensors, its layout has 3: use the layout of this shirt)."
    )


@pytest.mark.parametrize(("source", "other"), [(FramesCase, True), (LinesCase, False)], indirect=["source"])
def test_another_format_is_no_frame_and_the_sentence_says_what_to_choose(source, other):
    source.board.sends_lines = other
    assert "Nothing arrives from the shirt" in str(source.shirt.description())
    source.let_come(100)
    assert source.shirt.read(0.05) is None
    description = str(source.shirt.description())
    assert description.startswith(f"What arrives on {source.board.device} is no frame of this shirt (choose the format")


def test_frames_that_come_late_say_so(source):
    source.let_come(1)
    assert source.shirt.read(WAIT).t == 7.0
    source.clock.time += 0.51
    source.let_come(1)
    assert source.shirt.read(WAIT).t == 7.51
    assert str(source.shirt.description()).endswith(", 3 sensors, 0.5 s late.")


# What cannot be opened.


def test_a_line_that_is_not_there_is_one_sentence():
    shirt = make_shirt(parse_shirt({"kind": "serial", "device": "/dev/ttyNONE99"}), FakeClock())
    with pytest.raises(HardwareError, match=r"the shirt on /dev/ttyNONE99 cannot be opened .*: put its cable in"):
        shirt.open()
    assert "No serial line is open" in str(shirt.description())


def test_a_line_that_another_program_uses_is_one_sentence(source):
    config = {"kind": "serial", "device": source.board.device, "layout": small_layout().model_dump(mode="json")}
    with pytest.raises(HardwareError, match="end the other program that uses it"):
        make_shirt(parse_shirt(config), FakeClock()).open()


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (PermissionError(errno.EACCES, "?"), "Permission denied.*the group dialout"),
        (ValueError("Failed to set custom baud rate"), "custom baud rate.*check its cable and its baud rate"),
    ],
)
def test_each_reason_has_its_remedy(monkeypatch, error, words):
    def refuse(_config):
        raise error

    monkeypatch.setattr(serial_line, "open_line", refuse)
    with pytest.raises(HardwareError, match=words):
        make_shirt(parse_shirt({"kind": "serial"}), FakeClock()).open()


def test_a_missing_library_is_a_sentence(monkeypatch):
    monkeypatch.setitem(sys.modules, "serial", None)
    with pytest.raises(ModuleNotFoundError) as missing:
        make_shirt(parse_shirt({"kind": "serial"}), FakeClock()).open()
    assert "needs the library 'serial'" in str(reason(missing.value, "shirt"))


def test_a_radio_is_no_cable():
    """Safety S29."""
    with pytest.raises(HardwareError, match="is a radio link"):
        parse_shirt({"kind": "serial", "device": "/dev/rfcomm0"})


# The cable is pulled.


@BOTH
def test_a_cable_may_be_pulled_and_put_in_again_30_times(source, plugs_anywhere):
    plugs_anywhere(source.board)
    seq = -1
    for _ in range(MOST_CUTS):
        source.let_come(5)
        for number in range(5):
            frame = source.shirt.read(WAIT)
            assert frame.values[0] == number
            assert frame.seq > seq
            seq = frame.seq
        source.board.pull()
        before = source.clock.now()
        for _ in range(3):
            assert source.shirt.read(0.002) is None
        assert source.clock.now() - before > 0.003, "a loop around it must not spin"
        assert not source.shirt.pending()
        assert str(source.shirt.description()).startswith(f"The shirt on {source.first_device} is gone: put its cable")
        source.board.plug()
        wait_until_it_is_back(source.shirt)
    assert source.shirt.lost == 0


def test_what_was_put_in_again_comes_back_later_than_the_stop_of_a_silent_shirt():
    """Safety S4: at the slowest permitted rate a chair stops after 12 periods."""
    assert serial_line.REOPEN_AFTER > 12 / 10


def test_a_shirt_that_is_closed_while_its_cable_is_out_tries_no_more(source, plugs_anywhere):
    plugs_anywhere(source.board)
    source.let_come(1)
    assert source.shirt.read(WAIT) is not None
    source.board.pull()
    assert source.shirt.read(0.01) is None
    (thread,) = [one for one in threading.enumerate() if one.name == "reopens the serial line"]
    source.shirt.close()
    thread.join(WAIT)
    assert not thread.is_alive()
    source.board.plug()
    assert source.shirt.read(0.01) is None
    assert "No serial line is open" in str(source.shirt.description())
    source.shirt.open()
    source.let_come(1)
    assert source.shirt.read(WAIT) is not None


def test_a_line_that_opens_after_the_shirt_was_closed_is_closed_again(source, monkeypatch):
    opens, may_open, opened = threading.Event(), threading.Event(), []
    before = serial_line.open_line

    def slowly(config):
        opens.set()
        assert may_open.wait(WAIT)
        opened.append(before(config.model_copy(update={"device": source.board.device})))
        return opened[0]

    monkeypatch.setattr(serial_line, "open_line", slowly)
    monkeypatch.setattr(serial_line, "REOPEN_AFTER", 0.0)
    source.board.pull()
    assert source.shirt.read(0.01) is None
    source.board.plug()
    assert opens.wait(WAIT)
    (thread,) = [one for one in threading.enumerate() if one.name == "reopens the serial line"]
    source.shirt.close()
    may_open.set()
    thread.join(WAIT)
    assert not opened[0].is_open


def test_whether_a_line_is_a_cable_is_asked_anew_before_each_arming(monkeypatch):
    """Safety S29: what is put in again may be another device."""
    board, lines = WiredBoard(), set()
    monkeypatch.setattr(kind, "is_cable", lambda line: line in lines)
    setup = Setup(FakeClock())
    assert setup.mistrust == NO_SHIRT
    config = {"kind": "serial", "device": board.device, "layout": small_layout().model_dump(mode="json")}
    change = setup.change_shirt(parse_shirt(config))
    change.use(change.open())
    assert setup.mistrust == NO_CABLE
    lines.add(board.device)
    assert setup.mistrust is None
    setup.release_failed_shirt(OSError("gone"))
    assert setup.mistrust == NO_SHIRT
    board.pull()


def test_the_loop_goes_on_without_the_cable_and_keeps_the_shirt(ring, plugs_anywhere):
    """A pulled cable is silence, by which the gate stops; the shirt is not released as one whose driver failed."""
    board, clock = WiredBoard(), FakeClock()
    setup = Setup(clock)
    config = {"kind": "serial", "device": board.device, "layout": small_layout().model_dump(mode="json")}
    change = setup.change_shirt(parse_shirt(config))
    change.use(change.open())
    plugs_anywhere(board)
    assert (setup.source.shirt, setup.source.simulated, setup.mistrust) == ("serial", False, NO_CABLE)
    loop = ControlLoop(setup, ring, None, clock)

    def turn_until(is_right):
        for _ in range(2000):
            loop.turn()
            if is_right():
                return
        raise AssertionError(str(setup.shirt_description))

    board.send(20)
    turn_until(lambda: ring.since(0)[0]["has_frame"].sum() == 20)
    assert not loop.shirt_silent
    board.pull()
    turn_until(lambda: loop.shirt_silent)
    assert setup.shirt is not None
    assert "put its cable in again" in str(setup.shirt_description)
    board.plug()
    wait_until_it_is_back(setup.shirt)
    board.send(20)
    turn_until(lambda: ring.since(0)[0]["has_frame"].sum() == 40)
    assert (loop.shirt_silent, setup.shirt.lost) == (False, 0)
    ticks = ring.since(0)[0]
    assert (np.diff(ticks["t_device"][ticks["has_frame"] == 1]) > 0).all()
    setup.close()
    board.pull()
