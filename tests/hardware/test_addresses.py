import re
import socket

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import TypeAdapter

from app.hardware.addresses import FilePlace, checked_cable, checked_host, checked_line

HOSTS = [
    *("localhost", "chair.local", "a_b", "xn--mnchen-3ya.de", "a" * 63, "10.0.0.7"),
    *("::1", "fe80::1", "::ffff:10.0.0.7"),
]
NO_HOSTS = [
    *("", ".", "a..b", "a" * 64, "a.", "-a", "a-", "a b", "127.1", "1", "0x7f000001"),
    *("300.0.0.1", "[::1]", "1::2::3"),
]


@pytest.mark.parametrize("text", HOSTS)
def test_addresses_are_taken_as_they_are(text):
    assert checked_host(text) == text


@pytest.mark.parametrize("text", [*NO_HOSTS, "fe80::1%lo", "münchen.de", "\u202ea", "a\0b"])
def test_what_is_no_address_is_refused_with_an_example(text):
    with pytest.raises(ValueError, match=re.escape("write a name such as chair.local")) as refused:
        checked_host(text)
    assert str(refused.value).isprintable()
    assert len(str(refused.value)) < 150


@given(st.text(st.sampled_from("aZ09_-.:%é\0"), max_size=80) | st.text(max_size=80))
def test_what_is_taken_never_breaks_the_resolver_s_own_encoding(text):
    try:
        checked_host(text)
    except ValueError:
        return
    assert all(len(label) <= 63 for label in text.split("."))
    assert text.encode("idna") if ":" not in text else socket.inet_pton(socket.AF_INET6, text)


def test_serial_lines_and_files():
    for line in ("/dev/ttyUSB0", "/dev/pts/3", "/dev/cu.usbserial-1", "/dev/serial/by-id/usb-a_b-if00", "COM12"):
        assert checked_line(line) == line
    for other in ("/dev/zero", "/dev/watchdog", "/dev/ttyS0/../zero", "/dev/tty\n", "ttyUSB0", "loop://", "COM1000"):
        with pytest.raises(ValueError, match="is no serial line"):
            checked_line(other)
    assert checked_cable("/dev/ttyACM0") == "/dev/ttyACM0"
    for radio in ("/dev/rfcomm0", "/dev/cu.Bluetooth-Incoming-Port"):
        with pytest.raises(ValueError, match="is a radio link"):
            checked_cable(checked_line(radio))
    file = TypeAdapter(FilePlace)
    assert file.validate_python("var/runs/größe 1.csv") == "var/runs/größe 1.csv"
    for other in ("a\0b", "a\nb", "a\u202eb", "\ud800"):
        with pytest.raises(ValueError, match="which nobody sees"):
            file.validate_python(other)
