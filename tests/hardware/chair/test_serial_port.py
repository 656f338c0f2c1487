"""The serial line of outputs, on a pseudo-terminal: it never waits, and delivers no old frames."""

import os
import pty
import select
import struct
import termios
from contextlib import suppress

import pytest

from app.clock import monotonic
from app.hardware.chair import serial_port
from app.hardware.chair.outputs import OutputRefused
from app.hardware.chair.serial_port import HUNG, REOPEN_EVERY, SerialPort

PATIENCE = 20.0  # s


@pytest.fixture
def line():
    """Return both ends of a line; the far one does not wait."""
    ends = pty.openpty()
    os.set_blocking(ends[0], False)
    yield ends
    for end in ends:
        with suppress(OSError):  # a test has closed it
            os.close(end)


@pytest.fixture
def port(line):
    made = SerialPort(os.ttyname(line[1]), 38_400)
    yield made
    made.close()


def come(end, size):
    """Return `size` bytes that have come to an end."""
    content = b""
    while len(content) < size:
        assert select.select([end], [], [], PATIENCE)[0]
        content += os.read(end, size - len(content))
    return content


def read_within_patience(port, t=0.0):
    assert select.select([port._handle], [], [], PATIENCE)[0]
    return port.read(t)


def written_until_refused(port):
    """Write every 10 ms, and return when the line took the last frame and when it was an error (s)."""
    t = last = 0.0
    with suppress(TimeoutError):
        while True:
            t += 0.01
            if port.write(bytes(12), t):
                last = t
    return last, t


def written_within_patience(port, frame, t):
    until = monotonic() + PATIENCE
    while monotonic() < until:
        with suppress(TimeoutError):
            if port.write(frame, t):
                return True
    return False


def test_bytes_of_all_values_pass_both_ways_unchanged(line, port):
    content = bytes(range(256))
    assert port.read(0.0) == b""
    os.write(line[0], content)
    received = b""
    while len(received) < len(content):
        received += read_within_patience(port)
    assert received == content
    assert port.write(content, 0.0)
    assert come(line[0], len(content)) == content


def test_the_line_is_raw_with_8_bits_and_one_stop_bit(line, port):
    input_flags, output_flags, control, local, in_speed, out_speed, _ = termios.tcgetattr(line[1])
    assert (input_flags, output_flags, local) == (0, 0, 0)
    assert control & termios.CSIZE == termios.CS8
    assert not control & (termios.CSTOPB | termios.PARENB | termios.CRTSCTS)
    assert (in_speed, out_speed) == (termios.B38400, termios.B38400)


def test_a_line_that_takes_nothing_ends_in_an_error_within_the_limit_of_a_stop(line, port):
    last, t = written_until_refused(port)
    assert t - last <= HUNG + 0.011
    for _ in range(3):
        t += 0.01
        with pytest.raises(TimeoutError):
            port.write(bytes(12), t)
    while select.select([line[0]], [], [], 0.3)[0]:  # the far end reads again
        os.read(line[0], 4096)
    assert written_within_patience(port, b"a newer one!", t)
    received = b""
    while not received.endswith(b"a newer one!"):
        received += come(line[0], 1)
    assert len(received) < 24, "only the rest of one frame stands before the newer one"


def test_no_second_frame_waits_behind_one_that_is_not_sent_yet(line, port, monkeypatch):
    queued = [7]
    monkeypatch.setattr(serial_port.fcntl, "ioctl", lambda *_: struct.pack("i", queued[0]))
    assert not port.write(b"first", 0.0)
    assert not port.write(b"second", HUNG)
    with pytest.raises(TimeoutError):
        port.write(b"third", HUNG + 0.01)
    queued[0] = 0
    assert port.write(b"fourth", HUNG + 0.02)
    assert come(line[0], 6) == b"fourth"


def test_a_line_that_was_pulled_out_is_an_error_and_comes_back(line, tmp_path):
    name = tmp_path / "line"
    name.symlink_to(os.ttyname(line[1]))
    port = SerialPort(str(name), 115_200)
    os.close(line[0])
    with pytest.raises(OSError, match=r"gone|Input/output error"):
        port.read(10.0)
    for t in (10.01, 10.5):
        with pytest.raises(OSError, match="gone"):
            port.read(t)
        with pytest.raises(OSError, match="gone"):
            port.write(b"x", t)
    leader, follower = pty.openpty()
    try:
        name.unlink()
        with pytest.raises(FileNotFoundError):
            port.read(10.0 + REOPEN_EVERY)
        name.symlink_to(os.ttyname(follower))
        with pytest.raises(OSError, match="gone"):
            port.read(10.5 + REOPEN_EVERY)
        assert port.read(10.0 + 2 * REOPEN_EVERY) == b""
        assert port.write(b"back", 12.0)
        assert come(leader, 4) == b"back"
    finally:
        port.close()
        os.close(leader)
        os.close(follower)


def test_closing_twice_is_no_trouble(port):
    port.close()
    port.close()
    with pytest.raises(OSError, match="gone"):
        port.write(b"x", 0.0)


def test_a_line_that_another_program_has_is_refused(line, port):
    with pytest.raises(OutputRefused, match=r"another program uses it, end that$"):
        SerialPort(os.ttyname(line[1]), 38_400)


@pytest.mark.parametrize("name", ["none", "file", "."])
def test_what_is_no_line_is_refused_in_one_sentence(tmp_path, name):
    (tmp_path / "file").touch()
    with pytest.raises(OutputRefused, match=r"^the serial line .* cannot be opened \(.*\): plug it in"):
        SerialPort(str(tmp_path / name), 38_400)


def test_a_line_that_is_not_permitted_says_who_permits_it(monkeypatch):
    def refuse(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("app.hardware.chair.serial_port.os.open", refuse)
    with pytest.raises(OutputRefused, match="by the group dialout"):
        SerialPort("/dev/ttyUSB0", 38_400)
