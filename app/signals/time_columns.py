"""Which column of a file is the time, and in which unit: by its name, its stated unit, and its numbers.

A column `t` is in seconds unless the file states another unit, or its numbers are those of a clock that counts from
1970. The unit of another column is that of the file, or the only one in which its numbers can be a sample rate. What
could be two units is asked about, unless the file states the sample rate beside its rows. Of several columns of times,
one with even steps counts: it is the device's own clock, and others are those of arrival.
"""

from collections.abc import Collection
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.signals.file_table import FileTable, listed
from app.signals.time_names import (
    OWN,
    SECONDS,
    is_name_of_counter,
    stated_unit,
    time_names,
    time_rank,
    unit_of_word,
)
from app.texts import Text, in_sequence

GUESSED: Final = ("s", "ms", "us", "ns")  # units that numbers alone can tell
FIRST: Final = 946_684_800.0  # s since 1970: the year 2000
LAST: Final = 4_102_444_800.0  # the year 2100
SHORTEST_STEP: Final = 1 / 5000.0  # s
LONGEST_STEP: Final = 1.0  # s; a unit that gives another mean step is impossible
LONGEST_SPAN: Final = 1e10  # s; times that are no clock's from 1970 are smaller
OF_RATE: Final = 0.02  # share by which the mean step may differ from the period of a stated sample rate
EVEN: Final = 1 / 3  # of the median step: what the steps of a device's own clock may differ from it
WRAP: Final = 2.0**32  # a clock of 32 bits begins again here


class TimeColumn(NamedTuple):
    """The time of a table."""

    column: str
    unit: str  # a key of SECONDS
    is_stated: bool  # whether the file, or a person, says the unit
    t: NDArray[np.float64]  # (n,) s
    wraps: int = 0  # how often a clock of 32 bits began again


def time_of_table(
    table: FileTable, column: str | None = None, unit: str | None = None, channels: Collection[str] = ()
) -> TimeColumn:
    """Return the time of a table: its column `column`, else the surest one; in `unit`, else in the one that is found.

    The columns of `channels` are not the time.

    Raises
    ------
    ValueError
        One sentence when there is no column of times, or when its unit is a question.
    """
    if column is not None:
        return in_seconds(table, column, unit)
    columns = {name: values for name, values in table.columns.items() if name not in channels}
    candidates = time_names(columns)
    if OWN in candidates:
        return in_seconds(table, OWN, unit)
    rising = [name for name in candidates if _rises(table.columns[name])]
    certain = [
        name
        for name in rising
        if unit is not None or stated_unit(name, table.units) or _unit_of(table.columns[name], table.rate) is not None
    ]
    if certain:
        even = [name for name in certain if _is_even(table.columns[name])]  # a device's own, not that of arrival
        return in_seconds(table, (even or certain)[0], unit)
    if candidates:
        return in_seconds(table, (rising or candidates)[0], unit)
    of_unit = [name for name in columns if name in table.units and unit_of_word(table.units[name])]
    timed = [name for name in of_unit if _rises(table.columns[name])]
    clocks = [name for name, values in columns.items() if _rises(values) and _unit_since_1970(_known(values))]
    even = [name for name, values in columns.items() if _rises_evenly(values) and len(possible_units(values)) == 1]
    for unnamed in (timed, clocks, even):
        if len(unnamed) == 1:
            return in_seconds(table, unnamed[0], unit)
    raise ValueError(Text("signals-time-missing", file=table.places.file, names=listed(list(table.columns))))


def in_seconds(table: FileTable, column: str, unit: str | None) -> TimeColumn:
    """Return a column as the time; raise ValueError when it holds no numbers, or when its unit is a question."""
    values, wraps = _unwrapped(table.numbers(column))
    stated = unit or stated_unit(column, table.units) or _unit_of_rate(values, table.rate)
    if stated is not None:
        return TimeColumn(column, stated, True, values * SECONDS[stated], wraps)
    if (since_1970 := _unit_since_1970(values)) is not None:
        return TimeColumn(column, since_1970, False, values * SECONDS[since_1970], wraps)
    possible = ["s"] if column == OWN or len(values) < 2 else possible_units(values)
    if len(possible) > 1:
        step = float(f"{_mean_step(values):.4g}")
        like: list[Text] = [
            Text("signals-time-unit", unit=each, rate=float(f"{1.0 / (step * SECONDS[each]):.4g}")) for each in possible
        ]
        raise ValueError(
            Text("signals-time-units", file=table.places.file, column=column, step=step, units=like, unit=possible[0])
        )
    found = possible[0] if possible else "s"
    return TimeColumn(column, found, False, values * SECONDS[found], wraps)


def _unit_of(values: NDArray[np.generic], rate: float | None) -> str | None:
    """Return the only unit in which times (n,) can be those of samples, at `rate` (Hz) where the file states it."""
    possible = possible_units(values)
    return possible[0] if len(possible) == 1 else _unit_of_rate(_known(values), rate)


def _unit_of_rate(values: NDArray[np.float64], rate: float | None) -> str | None:
    """Return the only unit in which times (n,) have a sample rate (Hz); None where there is none, or without a rate."""
    if rate is None:
        return None
    periods = _mean_step(values) * rate  # that one step is, in each unit
    found = [unit for unit, seconds in SECONDS.items() if abs(periods * seconds - 1.0) <= OF_RATE]
    return found[0] if len(found) == 1 else None


def _unwrapped(values: NDArray[np.float64]) -> tuple[NDArray[np.float64], int]:
    """Return the times (n,) of a clock of 32 bits that go on where it began again, and how often it did."""
    falls = np.diff(values) < -WRAP / 2
    if not falls.any() or values.max() >= WRAP or values.min() < 0:
        return values, 0
    return values + WRAP * np.concatenate(([0.0], np.cumsum(falls))), int(falls.sum())


def possible_units(values: NDArray[np.generic]) -> list[str]:
    """Return the units in which times (n,) can be those of samples."""
    numbers = _known(values)
    if (since_1970 := _unit_since_1970(numbers)) is not None:
        return [since_1970]
    step, largest = _mean_step(numbers), float(np.abs(numbers).max(initial=0.0))
    return [
        unit
        for unit in GUESSED
        if SHORTEST_STEP <= step * SECONDS[unit] <= LONGEST_STEP and largest * SECONDS[unit] < LONGEST_SPAN
    ]


def is_counter(name: str, values: NDArray[np.generic]) -> bool:
    """Return whether a column (n,) counts samples: a name that says so, and steps of one, or none backwards."""
    if not is_name_of_counter(name):
        return False
    steps = np.diff(_known(values))
    return len(steps) > 0 and bool((steps == 1.0).mean() > 0.8 or (steps >= 0.0).all())


def is_channel(name: str, values: NDArray[np.generic]) -> bool:
    """Return whether a column of numbers (n,) can be a channel: neither a further time nor a counter of samples."""
    falls = np.diff(_known(values)) < 0.0
    is_time = time_rank(name) is not None and (not len(falls) or bool(falls.mean() <= 0.01))
    return not is_counter(name, values) and not is_time


def sentence_of_time(time: TimeColumn) -> Text | None:
    """Return which column was read as the time, and how; None for our own `t` in seconds."""
    read = Text("signals-time-read", column=time.column, unit=time.unit)
    if time.wraps:
        return in_sequence([read, Text("signals-time-wraps", column=time.column, count=time.wraps)])
    return None if time.column == OWN and time.unit == "s" else read


def _known(values: NDArray[np.generic]) -> NDArray[np.float64]:
    numbers = values.astype(np.float64, copy=False)
    return numbers[np.isfinite(numbers)]


def _unit_since_1970(values: NDArray[np.float64]) -> str | None:
    """Return the unit in which times count from 1970, None when they do not."""
    if len(values) < 2:
        return None
    ends, step = values[[0, -1]], _mean_step(values)
    for unit in GUESSED:
        first, last = ends * SECONDS[unit]
        if FIRST <= first <= last < LAST and SHORTEST_STEP <= step * SECONDS[unit] <= LONGEST_STEP:
            return unit
    return None


def _mean_step(values: NDArray[np.float64]) -> float:
    return float(values[-1] - values[0]) / (len(values) - 1) if len(values) > 1 else 0.0


def _rises(values: NDArray[np.generic]) -> bool:
    """Return whether numbers (n,) rise, and hardly ever fall."""
    numbers = _known(values)
    return len(numbers) > 1 and bool(numbers[-1] > numbers[0]) and bool((np.diff(numbers) >= 0).mean() > 0.99)


def _is_even(values: NDArray[np.generic]) -> bool:
    """Return whether times (n,) are complete, and most of their steps equal."""
    steps = np.diff(values.astype(np.float64, copy=False))
    if not np.isfinite(steps).all():
        return False
    median = float(np.median(steps))
    return median > 0.0 and bool((np.abs(steps - median) <= EVEN * median).mean() > 0.9)


def _rises_evenly(values: NDArray[np.generic]) -> bool:
    """Return whether numbers (n,) rise as nothing but a time or a counter does."""
    numbers = _known(values)
    steps = np.diff(numbers)
    return len(steps) > 1 and len(numbers) == len(values) and bool((steps > 0).all() and np.ptp(steps) < steps.mean())
