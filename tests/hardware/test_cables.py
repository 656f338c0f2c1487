"""Which serial lines are cables: the tree in which Linux lists its devices, built by hand."""

import os
import pty
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.hardware.cables import is_cable


@pytest.fixture
def line() -> Iterator[str]:
    """A pseudo terminal."""
    ours, theirs = pty.openpty()
    yield os.ttyname(theirs)
    os.close(ours)
    os.close(theirs)


def listed(folder: Path, line: str, *device: str) -> Path:
    """Make the folder of devices in which a line belongs to the device at this path, and return it."""
    status = os.stat(line)
    number = f"{os.major(status.st_rdev)}:{os.minor(status.st_rdev)}"
    place, entry = folder.joinpath("devices", *device), folder / "char" / number
    place.mkdir(parents=True)
    entry.mkdir(parents=True)
    (entry / "device").symlink_to(place)
    return folder / "char"


@pytest.mark.parametrize(
    ("device", "is_one"),
    [
        (("pci0000:00", "usb1", "1-2", "1-2:1.0", "ttyUSB0"), True),
        (("pci0000:00", "usb1", "1-2", "1-2:1.0"), True),  # a board with USB of its own
        (("platform", "serial8250"), True),
        (("pci0000:00", "usb1", "1-4", "bluetooth", "hci0", "hci0:256"), False),
    ],
)
def test_a_line_is_a_cable_when_it_belongs_to_a_device_that_is_no_radio(
    tmp_path: Path, line: str, device: tuple[str, ...], is_one: bool
) -> None:
    """Safety S29."""
    assert is_cable(line, listed(tmp_path, line, *device)) == is_one
    link = tmp_path / "ttyBOARD"
    link.symlink_to(line)
    assert is_cable(str(link), tmp_path / "char") == is_one


def test_a_pseudo_terminal_is_no_cable_whatever_it_is_called(tmp_path: Path, line: str) -> None:
    """Safety S29: any program can make one and send on it."""
    link = tmp_path / "ttyUSB0"
    link.symlink_to(line)
    assert not is_cable(line)
    assert not is_cable(str(link))


@pytest.mark.parametrize("other", ["/dev/null", "/dev/ttyNONE99", "/", "/etc/hostname", ""])
def test_what_is_no_serial_line_of_a_device_is_no_cable(other: str) -> None:
    assert not is_cable(other)


def test_where_the_kernel_lists_no_devices_nothing_is_a_cable(tmp_path: Path, line: str) -> None:
    assert not is_cable(line, tmp_path / "char")
