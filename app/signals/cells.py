"""What stands in a cell of a table in text: a number, a word for a missing one, a moment, or other words."""

import re
from typing import Final

MISSING: Final = frozenset(
    (
        *("", "nan", "-nan", "na", "n/a", "n.a.", "nd", "n.d.", "nil", "nat", "null", "none", "missing", "undefined"),
        *("<na>", "(null)", r"\n", "?", ".", "-", "--", "---"),
        *("n/d", "s/d", "n.v.", "k.a."),  # Spanish, German
        *("nan(ind)", "-nan(ind)", "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind"),  # what programs in C write
        *("1.#inf", "-1.#inf"),
        *("#n/a", "#na", "#div/0!", "#value!", "#num!", "#ref!", "#name?", "#null!"),  # spreadsheets, English
        *("#error!", "#spill!", "#calc!"),
        *("#nv", "#wert!", "#zahl!", "#bezug!"),  # German
        *("#n/d", "#¡div/0!", "#¡valor!", "#¡num!", "#¡ref!", "#¿nombre?", "#¡nulo!"),  # Spanish
    )
)  # in lower case
ERROR: Final = "err:"  # of LibreOffice, with a number
TOO_NARROW: Final = "#"  # a spreadsheet fills a column with it that is too narrow for a number
SPELLINGS: Final = sorted(
    {"NaN", "NaT"} | {spelt for each in MISSING for spelt in (each, each.upper(), each.capitalize())}
)
LIKE_A_NUMBER: Final = re.compile(r"[+-]?[\d.,' ]*\d[\d.,' ]*(e[+-]?\d+)?", re.IGNORECASE)
A_DATE: Final = re.compile(r"\d{1,2}\.\d{1,2}\.\d{2,4}|\d{4}\.\d{1,2}\.\d{1,2}")
INFINITE: Final = frozenset(("inf", "+inf", "-inf", "infinity", "+infinity", "-infinity"))

YEAR_FIRST: Final = r"(?P<y>\d{4})[-/.](?P<m>\d{1,2})[-/.](?P<d>\d{1,2})"
DAY_FIRST: Final = r"(?P<d2>\d{1,2})\.(?P<m2>\d{1,2})\.(?P<y2>\d{4})"
SLASHES: Final = r"(?P<a>\d{1,2})[-/](?P<b>\d{1,2})[-/](?P<y3>\d{4})"
NAMED_MONTH: Final = r"(?P<d4>\d{1,2})[- ](?P<month>[^\W\d_]{3})[^\W\d_]*\.?[- ](?P<y4>\d{4})"
CLOCK: Final = r"(?:(?P<hour>\d{1,3}):)?(?P<minute>\d{1,2}):(?P<second>\d{1,2})(?:[.,:](?P<part>\d{1,9}))?"
ZONE: Final = r"\s*(?P<noon>[ap]m)?\s*(?P<zone>z|utc|gmt|[+-]\d{2}:?\d{2})?"
DATE: Final = f"(?:{YEAR_FIRST}|{DAY_FIRST}|{SLASHES}|{NAMED_MONTH})"
MOMENT: Final = re.compile(rf"(?:{DATE}(?:[tT_]|,?\s+))?{CLOCK}{ZONE}", re.IGNORECASE)


def is_missing(cell: str) -> bool:
    """Return whether a cell is empty, or holds a word that stands for a missing number."""
    text = cell.strip().lower()
    return text in MISSING or text.startswith(ERROR) or not text.strip(TOO_NARROW)


def is_number(cell: str, decimal: str) -> bool:
    """Return whether a cell holds a number with this decimal sign; a point is none where it is the comma."""
    return number_of(cell, decimal) is not None


def number_of(cell: str, decimal: str) -> float | None:
    """Return the number in a cell, None when it holds none."""
    text = cell.strip()
    if not text.isascii() or "_" in text or (decimal == "," and "." in text):
        return None
    try:
        return float(text.replace(decimal, "."))
    except ValueError:
        return None


def is_like_a_number(cell: str) -> bool:
    """Return whether a cell is a number in any notation, also in one that is not read."""
    text = cell.strip()
    if A_DATE.fullmatch(text):
        return False
    return LIKE_A_NUMBER.fullmatch(text) is not None or text.lower() in INFINITE


def is_moment(cell: str) -> bool:
    """Return whether a cell holds a time of day, or a date with one (ISO 8601 and others)."""
    return MOMENT.fullmatch(cell.strip()) is not None
