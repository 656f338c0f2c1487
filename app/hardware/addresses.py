"""Checked texts that say where a device is: host, file, serial line."""

import ipaddress
import re
from typing import Annotated

from pydantic import AfterValidator, Field

from app.quantities import Line
from app.texts import Text

LONGEST_QUOTE = 40
_LABEL = re.compile(r"[A-Za-z0-9_]([A-Za-z0-9_-]{0,61}[A-Za-z0-9_])?")
_NUMBER = re.compile(r"[0-9]+|0[xX][0-9A-Fa-f]*")  # a numeric last label belongs to an IPv4 address (RFC 3696)


def checked_host(text: str) -> str:
    """Return a valid host name, IPv4 or IPv6 address; ValueError for any other text."""
    if not _is_host(text):
        raise ValueError(Text("device-no-host", given=_quoted(text)))
    return text


def checked_line(text: str) -> str:
    """Return the valid name of a serial line; ValueError for any other file or device."""
    if not re.fullmatch(r"/dev/(tty|cu\.|pts/|rfcomm|serial/)[A-Za-z0-9._:+/-]*|COM[0-9]{1,3}", text) or ".." in text:
        raise ValueError(Text("device-no-line", given=_quoted(text)))
    return text


def checked_cable(line: str) -> str:
    """Return the valid name of a serial line that is a cable; ValueError for one over Bluetooth."""
    if is_radio(line):
        raise ValueError(Text("device-no-cable", given=_quoted(line)))
    return line


def is_radio(line: str) -> bool:
    """Return whether a serial line is one over Bluetooth by its name."""
    return line.startswith("/dev/rfcomm") or "bluetooth" in line.lower()


def _is_host(text: str) -> bool:
    try:
        if ":" in text:
            return "%" not in text and bool(ipaddress.IPv6Address(text))
        *_, last = labels = text.split(".")
        if _NUMBER.fullmatch(last):
            return bool(ipaddress.IPv4Address(text).packed)
    except ValueError:
        return False
    return all(map(_LABEL.fullmatch, labels))


def _quoted(text: str) -> str:
    """Return a text in printable ASCII, cut to LONGEST_QUOTE letters."""
    quoted = ascii(text[: LONGEST_QUOTE + 1])
    return quoted if len(quoted) <= LONGEST_QUOTE else quoted[:LONGEST_QUOTE] + "..."


Host = Annotated[str, Field(min_length=1, max_length=253), AfterValidator(checked_host)]
FilePlace = Annotated[Line, Field(min_length=1, max_length=4096)]
SerialLine = Annotated[str, Field(min_length=1, max_length=255), AfterValidator(checked_line)]
Cable = Annotated[SerialLine, AfterValidator(checked_cable)]
"""A serial line that is no radio link by its name; `app.hardware.cables` says whether it is a cable (safety S29)."""
