"""The dialect of a table in text: what stands between its columns, its decimal sign, its encoding."""

import codecs
import csv
import re
from typing import Final, NamedTuple

from app.texts import Text

BLANKS: Final = " "  # one or more blanks or tabs
SEPARATORS: Final = {",": "commas", ";": "semicolons", "\t": "tabs", "|": "bars", BLANKS: "blanks"}
UTF_8: Final = "utf-8"
QUOTE: Final = '"'
COMMENTS: Final = ("#", "%", "//")
MARKS: Final = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)  # those of UTF-32 before those of UTF-16, which they begin with
WINDOWS: Final = "cp1252"  # what programs for Windows write where the text is not UTF-8
MOSTLY: Final = 0.7  # share of bytes that are 0, every second one, in UTF-16 without a mark
CONTROLS: Final = frozenset(range(32)) - {9, 10, 11, 12, 13, 26}  # bytes that stand in no text


class Dialect(NamedTuple):
    """The separator between the cells of a line, the decimal sign of its numbers, the encoding of the file."""

    separator: str = ","
    decimal: str = "."
    encoding: str = UTF_8

    @property
    def sentence(self) -> Text | None:
        """Return the signs in a sentence; None for the usual ones, commas and decimal points."""
        if self[:2] == Dialect()[:2]:
            return None
        decimal = "point" if self.decimal == "." else "comma"
        return Text("signals-dialect", separator=SEPARATORS[self.separator], decimal=decimal)


def cells_of(line: str, separator: str) -> list[str]:
    """Return the trimmed cells of one line; raise csv.Error when it cannot be parsed."""
    if separator == BLANKS:
        return [cell.strip(QUOTE) for cell in line.split()]
    if QUOTE not in line:
        return [cell.strip() for cell in line.split(separator)]
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True), [""])]


def names_of(line: str, separator: str, width: int) -> list[str]:
    """Return the cells of a header; names between blanks may have single blanks in them when that gives `width`."""
    cells = cells_of(line, separator)
    if separator == BLANKS and len(cells) != width:
        wide = re.split(r"\s{2,}|\t", line.strip())
        return wide if len(wide) == width else cells
    return cells


def without_mark(line: str) -> str:
    """Return a line without the sign of a comment at its beginning."""
    return line.strip().lstrip("#%/").strip()


def is_comment(line: str) -> bool:
    """Return whether a line begins with the sign of a comment."""
    return line.lstrip().startswith(COMMENTS)


def encoding_of(head: bytes) -> str | None:
    """Return the encoding of a file that begins with `head`; None when it is no text."""
    for mark, encoding in MARKS:
        if head.startswith(mark):
            return encoding
    text = head.rstrip(b"\0")
    if not text or b"\0" not in text:
        return _of_single_bytes(text)
    for first, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):
        high = head[first::2]
        if high.count(0) >= MOSTLY * len(high) and not head[1 - first :: 2].rstrip(b"\0").count(0):
            return encoding
    return None


def _of_single_bytes(text: bytes) -> str | None:
    if _is_in(text, UTF_8):
        return UTF_8
    return WINDOWS if _is_in(text, WINDOWS) and not CONTROLS.intersection(text) else None


def _is_in(text: bytes, encoding: str) -> bool:
    """Return whether a text is in an encoding; its last letter may be cut."""
    try:
        codecs.getincrementaldecoder(encoding)().decode(text)
    except UnicodeDecodeError:
        return False
    return True
