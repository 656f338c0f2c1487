"""Which backups of a folder are kept: 7 daily, 4 weekly and 6 monthly ones."""

from collections.abc import Callable, Iterable
from datetime import datetime, timedelta
from typing import Any, Final

KEPT: Final[tuple[tuple[int, Callable[[datetime], Any]], ...]] = (
    (7, lambda moment: moment.date()),
    (4, lambda moment: moment.isocalendar()[:2]),
    (6, lambda moment: (moment.year, moment.month)),
)  # how many, and to which day, week or month a backup belongs
ALL_DAYS_FOR: Final = timedelta(days=7)


def kept_backups(moments: Iterable[datetime], passed: datetime) -> set[datetime]:
    """Return the newest backup of each of the last 7 days, 4 weeks and 6 months that have one.

    `passed` is up to when time has really passed. Where the clock was set forward, days that have not passed push none
    out: the newest backup of each day is kept until 7 days have.
    """
    newest_first = sorted(moments, reverse=True)
    kept: set[datetime] = set()
    for many, period_of in KEPT:
        newest: dict[Any, datetime] = {}
        for moment in newest_first:
            newest.setdefault(period_of(moment), moment)
        each = list(newest.values())
        kept |= {*each[:many], *(moment for moment in each if moment + ALL_DAYS_FOR > passed)}
    return kept
