"""Which backups of a folder stay: the newest of each of the last days, weeks and months."""

from collections.abc import Callable, Iterable
from datetime import datetime, timedelta
from typing import Any, Final

DAILY: Final = 7
WEEKLY: Final = 4
MONTHLY: Final = 6
ALL_DAYS_FOR: Final = timedelta(days=DAILY)

KEPT: Final[tuple[tuple[int, Callable[[datetime], Any]], ...]] = (
    (DAILY, lambda moment: moment.date()),
    (WEEKLY, lambda moment: moment.isocalendar()[:2]),
    (MONTHLY, lambda moment: (moment.year, moment.month)),
)  # how many, and to which day, week or month a backup belongs


def kept_backups(moments: Iterable[datetime], passed: datetime) -> set[datetime]:
    """Return the newest backup of each of the last days, weeks and months that have one.

    `passed` is up to when time has really passed. Where the clock was set forward, days that have not passed push none
    out: the newest backup of each day is kept until ALL_DAYS_FOR has.
    """
    newest_first = sorted(moments, reverse=True)
    moments_to_keep: set[datetime] = set()
    for many, period_of in KEPT:
        newest: dict[Any, datetime] = {}
        for moment in newest_first:
            newest.setdefault(period_of(moment), moment)
        each = list(newest.values())
        moments_to_keep |= {*each[:many], *(moment for moment in each if moment + ALL_DAYS_FOR > passed)}
    return moments_to_keep
