"""Names of columns: the unit that stands in a name, and the column that a channel's name means."""

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Final

UNITS: Final = frozenset(
    (
        *("s", "sec", "secs", "second", "seconds", "sekunden", "segundos", "seg", "ms", "msec", "msecs", "millis"),
        *("millisecond", "milliseconds", "us", "µs", "μs", "usec", "micros", "microsecond", "microseconds"),
        *("ns", "nsec", "nanos", "nanosecond", "nanoseconds", "min", "mins", "minute", "minutes", "minuten", "minutos"),
        *("h", "hour", "hours", "v", "mv", "uv", "µv", "μv", "a", "ma", "ua", "µa", "ohm", "kohm", "ω", "kω", "mω"),
        *("g", "mg", "gs", "dps", "m", "mm", "cm", "um", "µm", "in", "inch", "deg", "degree", "degrees", "°", "rad"),
        *("radian", "radians", "hz", "khz", "n", "mn", "kn", "nm", "nmm", "n·m", "n*m", "n.m", "n.mm", "n-m", "n-mm"),
        *("kg", "lb", "lbf", "w"),
        *("pa", "kpa", "hpa", "mbar", "bar", "mmhg", "psi", "%", "c", "°c", "degc", "k", "°f"),
        *("ut", "µt", "μt", "mt", "gauss", "bpm", "rpm"),
        *("adc", "count", "counts", "lsb", "raw", "a.u.", "au", "a.u", "bool", "bit", "bits", "1", "none", "n/a", "-"),
        *("unit", "units", "no_units", "quaternion", "strain", "mstrain", "µstrain", "local_flux", "flux"),
        *("volt", "volts", "millivolt", "millivolts", "microvolt", "microvolts", "ampere", "amperes", "newton"),
        *("newtons", "ohms", "kohms", "siemens", "microsiemens", "meter", "meters", "metre", "metres", "millimeters"),
        *("metros", "grad", "grados", "radianes", "kelvin", "celsius", "percent", "prozent", "pascal", "tesla"),
    )
)  # in lower case
MOSTLY: Final = 0.8  # share of units in a line of units: some have a name that nobody knows
POWER: Final = re.compile(r"[\^²³0-9·*() -]+")
NO_NAME: Final = frozenset('{}":')  # signs of other formats than tables
IN_BRACKETS: Final = re.compile(r"(?P<bare>.*?)[\s_.]*[\[({<](?P<unit>[^\[\](){}<>]*)[\])}>]\s*")
BEHIND: Final = re.compile(r"(?P<bare>.+?)(?:\s*/\s*|\s+in\s+|,\s*)(?P<unit>[^\s/,]+)", re.IGNORECASE)


def is_unit(text: str) -> bool:
    """Return whether a text is a unit, alone or made of others (m/s^2, deg/s)."""
    word = text.strip().strip("()[]").strip().lower()
    if word in UNITS:
        return True
    parts = [POWER.sub("", part) for part in word.split("/")]
    return len(parts) > 1 and all(part in UNITS for part in parts)


def is_units(cells: Sequence[str]) -> bool:
    """Return whether the cells of a line are units: at least half are filled, the first of these and most are known."""
    filled = [cell for cell in cells if cell.strip("()[] ")]
    if 2 * len(filled) < len(cells) or not filled or not is_unit(filled[0]):
        return False
    return sum(map(is_unit, filled)) >= MOSTLY * len(filled)


def bare_name(name: str) -> tuple[str, str]:
    """Return a name without its unit, and the unit, empty for none: `Strain A [mV]`, `Time/s`, `Force in N`."""
    for form in (IN_BRACKETS, BEHIND):
        match = form.fullmatch(name)
        if match is not None and match["bare"] and is_unit(match["unit"]):
            return match["bare"].strip(), match["unit"].strip()
    return name, ""


def bare_names(names: Iterable[str]) -> list[tuple[str, str]]:
    """Return all names without their units, and the units."""
    return [bare_name(name) for name in names]


def unique_names(names: Iterable[str]) -> list[str]:
    """Return names of which no two are equal: those that were there before have a number behind, `EMG (2)`."""
    found: dict[str, None] = {}
    count: Counter[str] = Counter()
    for name in names:
        own = name
        while own in found:
            count[name] += 1
            own = f"{name} ({count[name] + 1})"
        found[own] = None
    return list(found)


def words_of(name: str) -> tuple[str, ...]:
    """Return the words of a name in lower case, without its unit: of letters and of digits."""
    return tuple(re.findall(r"[^\W\d_]+|\d+", bare_name(name)[0].casefold()))


def columns_of_channels(channels: Sequence[str], columns: Sequence[str]) -> dict[str, str]:
    """Return the column of each channel that has one.

    A column has the channel's name; else its words, apart from a unit; else it ends with these words, as
    `Strain A [mV]` for A. Where several columns do, or one column does for several channels, the channel has none.
    """
    found = {channel: channel for channel in channels if channel in columns}
    words = {name: words_of(name) for name in columns if name not in found and not NO_NAME.intersection(name)}
    for fits in (_has, _ends_with):
        missing = [channel for channel in channels if channel not in found and words_of(channel)]
        fitting = {
            channel: [column for column, of_column in words.items() if fits(of_column, words_of(channel))]
            for channel in missing
        }
        for channel, candidates in fitting.items():
            if len(candidates) == 1 and sum(candidates == others for others in fitting.values()) == 1:
                found[channel] = candidates[0]
                del words[candidates[0]]
    return found


def _has(words: tuple[str, ...], wanted: tuple[str, ...]) -> bool:
    return words == wanted


def _ends_with(words: tuple[str, ...], wanted: tuple[str, ...]) -> bool:
    return words[-len(wanted) :] == wanted
