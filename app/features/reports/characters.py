"""Which characters of a report its fonts have; the others, and invisible ones, are written as their number.

`data/fonts/coverage.json` lists the characters of the fonts beside it as ranges.
"""

import json
import unicodedata
from bisect import bisect_right
from collections.abc import Iterable, Sequence
from functools import cache
from typing import Final

from app.settings import data_folder
from app.texts import Text
from app.visible_text import INVISIBLE, LINE_BREAKS

FONT: Final = "Noto Sans"  # of Latin text, in drawings too; data/reports/report.typ names those for other characters
COVERAGE: Final = "coverage.json"
MOST_NAMED: Final = 12  # characters that are named


class Coverage:
    """The characters that the fonts have."""

    def __init__(self, ranges: Sequence[tuple[int, int]]) -> None:
        self._first = [first for first, _ in ranges]
        self._last = [last for _, last in ranges]

    def __contains__(self, character: str) -> bool:
        place = bisect_right(self._first, ord(character)) - 1
        return place >= 0 and ord(character) <= self._last[place]


@cache
def coverage_of_fonts() -> Coverage:
    """Return which characters the fonts of reports have."""
    ranges = json.loads((data_folder() / "fonts" / COVERAGE).read_text())
    return Coverage(ranges)


def without_invisible(text: str) -> str:
    """Return a text with each invisible character as its number: it could turn the order of what stands beside it."""
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    return "".join(_number(character) if _is_invisible(character) else character for character in text)


def printable(text: str, coverage: Coverage) -> str:
    """Return a visible text with each character that no font has as its number."""
    return "".join(
        character if character in LINE_BREAKS or character in coverage else _number(character) for character in text
    )


def missing_text(texts: Iterable[str], coverage: Coverage) -> Text | None:
    """Return in a sentence which characters of the texts no font has; None when there are none."""
    missing = dict.fromkeys(
        character for text in texts for character in text if character not in LINE_BREAKS and character not in coverage
    )
    if not missing:
        return None
    named = ", ".join(
        f"{_number(character)} ({unicodedata.name(character, '').lower() or Text('report-character-nameless')})"
        for character in list(missing)[:MOST_NAMED]
    )
    if len(missing) <= MOST_NAMED:
        return Text("report-missing-characters", characters=named)
    return Text("report-missing-characters-more", characters=named, more=len(missing) - MOST_NAMED)


def _is_invisible(character: str) -> bool:
    return unicodedata.category(character) in INVISIBLE | {"Co", "Cn"} and character not in LINE_BREAKS


def _number(character: str) -> str:
    return f"[U+{ord(character):04X}]"
