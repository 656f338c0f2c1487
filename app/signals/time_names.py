"""What the name of a column says of the time: whether the column is one, and its unit."""

import re
from collections.abc import Iterable, Mapping
from typing import Final

from app.signals.column_names import bare_name

OWN: Final = "t"  # the name of the time in this program's own files
SECONDS: Final = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "min": 60.0, "h": 3600.0, "d": 86400.0}  # s
SPELT: Final = {
    "s": ("s", "sec", "secs", "second", "seconds", "sekunde", "sekunden", "segundo", "segundos", "seg"),
    "ms": ("ms", "msec", "msecs", "millis", "millisecond", "milliseconds", "millisekunden", "milisegundos"),
    "us": ("us", "µs", "usec", "usecs", "micros", "microsecond", "microseconds", "mikrosekunden", "microsegundos"),
    "ns": ("ns", "nsec", "nsecs", "nano", "nanos", "nanosecond", "nanoseconds", "nanosekunden", "nanosegundos"),
    "min": ("min", "mins", "minute", "minutes", "minuten", "minutos"),
    "h": ("h", "hr", "hour", "hours", "stunden", "horas"),
    "d": ("d", "day", "days", "tage", "dias", "días"),
}
UNIT_OF: Final = {word: unit for unit, words in SPELT.items() for word in words}
LONG: Final = frozenset(word for words in SPELT.values() for word in words if len(word) > 2)  # that alone name a time

# Words in the name of a time, the surest first.
TIME_WORDS: Final = (
    ("t",),
    ("time", "times", "zeit", "tiempo", "timestamp", "timestamps", "zeitstempel", "stamp", "sampletimefine"),
    ("latency", "elapsed", "clock", "uhrzeit", "hora", "datetime", "unix", "epoch", "utc", "lsl", "secs", "nsecs"),
)
COUNTER_WORDS: Final = frozenset(
    (
        *("index", "sample", "samples", "frame", "packet", "counter", "count", "seq", "sequence", "row", "number"),
        *("nr", "item", "id", "zeile", "bild", "fila", "cuadro"),
    )
)
NO_UNITS: Final = frozenset(("", "1", "-", "none", "n/a", "raw", "count", "counts", "unit", "units", "a.u.", "au"))
NOT_TIME: Final = frozenset(("of", "rate", "index", "delta", "diff", "duration", "zone", "sync", "constant"))


def unit_of_word(word: str) -> str | None:
    """Return the unit, a key of SECONDS, that a word means."""
    return UNIT_OF.get(word.strip().strip("()[].").lower().replace("μ", "µ"))


def stated_unit(name: str, units: Mapping[str, str]) -> str | None:
    """Return the unit that a file states for a column of times: beside its name, or in it (`time_ms`, `millis`)."""
    if name in units and (unit := unit_of_word(units[name])):
        return unit
    bare, in_brackets = bare_name(name)
    if in_brackets and (unit := unit_of_word(in_brackets)):
        return unit
    words = _words(bare)
    if len(words) > 1 and (unit := unit_of_word(words[-1])):
        return unit
    return next((UNIT_OF[word] for word in words if word in LONG), None)


def time_rank(name: str) -> int | None:
    """Return how surely a name is that of a time, 0 the surest; None when it is none."""
    bare, unit = bare_name(name)
    words = _words(bare)
    is_of_another_unit = unit.lower() not in NO_UNITS and unit_of_word(unit) is None  # T [°C]
    if not words or is_of_another_unit or NOT_TIME.intersection(words):
        return None
    for rank, known in enumerate(TIME_WORDS):
        if words[0] in known and len(words) == 1:
            return 2 * rank
        if rank and set(words).intersection(known):
            return 2 * rank + 1
    if words[0] == OWN and len(words) == 2 and words[1] in UNIT_OF:
        return 1
    return 2 * len(TIME_WORDS) if LONG.intersection(words) else None


def time_names(names: Iterable[str]) -> list[str]:
    """Return the names that can be those of the time, the surest first; a column `t` alone where there is one."""
    ranked = [(rank, name) for name in names if (rank := time_rank(name)) is not None]
    if any(name == OWN for _, name in ranked):
        return [OWN]
    return [name for _, name in sorted(ranked, key=lambda each: each[0])]


def is_name_of_counter(name: str) -> bool:
    """Return whether a name is that of a counter of samples."""
    return bool(COUNTER_WORDS.intersection(_words(bare_name(name)[0])))


def _words(name: str) -> list[str]:
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)  # sampleTime
    return re.findall(r"[^\W\d_]+", spaced.casefold().replace("μ", "µ"))
