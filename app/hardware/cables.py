"""Whether a serial line is a cable: the kernel says which device it belongs to (safety S29)."""

import os
import stat
from pathlib import Path
from typing import Final

DEVICES: Final = Path("/sys/dev/char")
"""Where Linux says of each character device, by its numbers, which device of the machine it belongs to."""
RADIO: Final = "bluetooth"  # part of the path of a device behind a radio


def is_cable(line: str, devices: Path = DEVICES) -> bool:
    """Return whether the serial line of this name belongs to a device of the machine, such as one on USB.

    A pseudo terminal belongs to none: any program can make one and send on it. Where the kernel does not say it, as
    outside of Linux, no line is a cable.
    """
    try:
        status = os.stat(line)
        numbers = f"{os.major(status.st_rdev)}:{os.minor(status.st_rdev)}"
        device = (devices / numbers / "device").resolve(strict=True)
    except OSError:
        return False
    return stat.S_ISCHR(status.st_mode) and RADIO not in device.parts
