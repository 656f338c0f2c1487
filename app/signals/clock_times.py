"""Times that are written as times of day or as dates, in seconds."""

import re
from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.signals.cells import MOMENT

DAY: Final = 86_400.0  # s
MONTHS: Final = {
    name: month
    for month, names in enumerate(
        (
            *("jan ene", "feb", "mar mär mrz", "apr abr", "may mai", "jun", "jul", "aug ago", "sep", "oct okt"),
            *("nov", "dec dez dic"),
        ),
        start=1,
    )
    for name in names.split()
}  # by three letters, in English, German and Spanish
OF_DATE: Final = (("y", "m", "d"), ("y2", "m2", "d2"))
LATEST: Final = 0.5 * DAY  # a time of day that is so much earlier than the one before is one of the next day


def seconds_of_moments(cells: Sequence[str]) -> NDArray[np.float64]:
    """Return moments (n,) in s: since 1970 with a date, else since the midnight before the first; NaN for others.

    A date a/b/year has the month first, unless some first number is greater than 12. A date without a zone is UTC.
    """
    matches = [MOMENT.fullmatch(cell.strip()) for cell in cells]
    day_first = any(match is not None and match["a"] is not None and int(match["a"]) > 12 for match in matches)
    t = np.array([np.nan if match is None else _seconds(match, day_first) for match in matches], np.float64)
    dated = any(match is not None and _date(match, day_first) is not None for match in matches)
    return t if dated else _over_midnight(t)


def _seconds(match: re.Match[str], day_first: bool) -> float:
    date = _date(match, day_first)
    hour, minute, second = (int(match[name] or 0) for name in ("hour", "minute", "second"))
    if minute > 59 or second > 60:
        return np.nan
    if match["noon"]:
        hour = hour % 12 + (12 if match["noon"].lower() == "pm" else 0)
    part: float = int(match["part"] or 0) / 10 ** len(match["part"] or "")
    in_day = 3600.0 * hour + 60.0 * minute + second - _zone(match["zone"])
    try:
        day = 0.0 if date is None else datetime(*date, tzinfo=UTC).timestamp()
    except ValueError:
        return np.nan
    return day + in_day + part


def _date(match: re.Match[str], day_first: bool) -> tuple[int, int, int] | None:
    for year, month, day in OF_DATE:
        if match[year] is not None:
            return int(match[year]), int(match[month]), int(match[day])
    if match["y4"] is not None and match["month"].lower() in MONTHS:
        return int(match["y4"]), MONTHS[match["month"].lower()], int(match["d4"])
    if match["y3"] is None:
        return None
    a, b = int(match["a"]), int(match["b"])
    return (int(match["y3"]), b, a) if day_first else (int(match["y3"]), a, b)


def _zone(zone: str | None) -> float:
    """Return how much a zone is ahead of UTC, s."""
    if zone is None or zone[0] not in "+-":
        return 0.0
    digits = zone[1:].replace(":", "")
    ahead = 3600.0 * int(digits[:2]) + 60.0 * int(digits[2:])
    return -ahead if zone[0] == "-" else ahead


def _over_midnight(t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return times of day (n,) that go on after midnight."""
    known = np.flatnonzero(np.isfinite(t))
    days = np.concatenate(([0.0], np.cumsum(np.diff(t[known]) < -LATEST))) if len(known) else np.zeros(0)
    later = t.copy()
    later[known] += DAY * days
    return later
