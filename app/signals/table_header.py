"""What stands above the rows of a table in text: the names of its columns, their units, the sample rate.

Usually one line has the names. Others write them in several lines (a marker over its X, Y and Z), behind a key
(`ChannelTitle=` of LabChart, `MARKER_NAMES` of Qualisys), or in an object of JSON (OpenSignals).
"""

import json
import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Final, NamedTuple

from app.signals.cells import is_like_a_number, is_moment, number_of
from app.signals.column_names import is_units, unique_names
from app.signals.csv_dialect import BLANKS, cells_of, is_comment, names_of, without_mark
from app.signals.sampling_times import FASTEST, SLOWEST
from app.signals.time_names import SECONDS, time_names, unit_of_word

MOST_ABOVE: Final = 8  # lines above the rows that can belong to the header
NO_NAME: Final = re.compile(r"Unnamed: \d+")  # pandas calls a column so
TIME: Final = "Time"  # the name of a first column that has none, and holds times
FRAME: Final = "Frame"
AXES: Final = "XYZ"
KIND_OF_KEY: Final = r"(?:channel|marker|column|signal)[ _]?"
KEY: Final = re.compile(rf".*=|{KIND_OF_KEY}(?:title|name|label)s?:?", re.IGNORECASE)
NAMES_KEY: Final = re.compile(rf"(?:{KIND_OF_KEY})?(?:title|name|label)s?[=:]?", re.IGNORECASE)
UNITS_KEY: Final = re.compile(r"(?:(?:channel|y)[ _]?)?units?(?:[ _]?(?:name|label)s?)?[=:]?", re.IGNORECASE)
IDENTIFIER: Final = re.compile(r"(?=.*\d)[0-9a-f:-]{6,}", re.IGNORECASE)  # of a device: it says nothing to people

NUMBER: Final = r"(?P<number>\d+(?:[.,]\d+)?(?:e[+-]?\d+)?)\s*"
PERIOD_UNIT: Final = r"(?P<unit>ms|msec|us|µs|s|sec|seconds?)?"
OF_RATE: Final = r"sampling|sample|samples|frame|data|update|output|acquisition|capture|export|recording|scan"
BY_RATE: Final = re.compile(
    rf"(?<![a-z])(?:(?:{OF_RATE})?[ _-]?(?:rate|freq(?:uency)?)(?:[ _]?hz)?|sampling|fs|fps|abtast(?:rate|frequenz)"
    rf"|frecuencia(?: de muestreo)?)(?![a-z])[^0-9a-z]*(?:hz)?[^0-9a-z]*{NUMBER}(?P<kilo>khz)?"
)
IN_HERTZ: Final = re.compile(rf"(?<![\d.,]){NUMBER}(?P<kilo>k)?hz(?![a-z])")
BY_PERIOD: Final = re.compile(
    r"(?<![a-z])(?:(?:sampling|sample)[ _-]?(?:interval|period|time)|interval|delta_x|isi|dt)(?![a-z])"
    rf"[^0-9a-z]*{NUMBER}{PERIOD_UNIT}(?![a-z])"
)
PER_SAMPLE: Final = re.compile(rf"{NUMBER}{PERIOD_UNIT}/sample")
OTHER_RATES: Final = re.compile(
    r"heart|puls|resp|baud|bit|filter|cut|pass|band|notch|mains|power|line|refresh|display|analog"
)
NEAR: Final = 16  # letters in front of a rate that say which one it is
BLOCKS: Final = frozenset(("trajectories", "devices", "model outputs", "joints", "segments"))  # of Vicon Nexus
OF_COLUMNS: Final = frozenset(
    (
        *("min", "max", "minimum", "maximum", "mean", "average", "std", "sd", "offset", "gain", "scale", "slope"),
        *("mittelwert", "media", "promedio"),
    )
)
AROUND: Final = ",;\t \"'"  # signs around what stands alone in a line


class Line(NamedTuple):
    """A line of a text and its number, from 0."""

    number: int
    text: str


class Header(NamedTuple):
    """The names of the columns and their units, empty where there are none; the number of the line of names."""

    names: list[str]
    units: list[str]
    top: int | None = None


def header_of(above: Sequence[Line], separator: str, width: int, filled: int) -> Header:
    """Return the header among the lines above rows of `width` cells; its names are empty where no line fits.

    `filled` is the number of cells without an empty last one.
    """
    lines = [line for line in reversed(above) if re.search(r"\w", line.text) and not _sums_up(line.text, separator)]
    plain = _plain_header(lines[:MOST_ABOVE], separator, width)
    return plain if plain.names else _keyed_header(lines, separator, filled)


def _sums_up(text: str, separator: str) -> bool:
    """Return whether a line has a number for each column below the names: the least one, a gain."""
    first, *others = [cell for cell in cells_of(text, separator) if cell] or [""]
    return first.casefold().rstrip(":") in OF_COLUMNS and bool(others) and all(map(is_like_a_number, others))


def stated_rate(above: Iterable[str]) -> float | None:
    """Return the sample rate (Hz) that lines above a table state; None where none does, or where several differ."""
    lines = [text.casefold() for text in above]
    for rates in (_by_words(lines, BY_RATE), _of_blocks(lines), _by_periods(lines)):
        possible = [rate for rate in rates if SLOWEST <= rate <= FASTEST]
        if possible:
            return possible[-1]
    alone = {rate for rate in _by_words(lines, IN_HERTZ) if SLOWEST <= rate <= FASTEST}
    return alone.pop() if len(alone) == 1 else None


def _by_words(lines: Iterable[str], form: re.Pattern[str]) -> Iterator[float]:
    for text in lines:
        for match in form.finditer(text):
            if not OTHER_RATES.search(text[max(0, match.start() - NEAR) : match.start()]):
                yield _number(match) * (1000.0 if match["kilo"] else 1.0)


def _by_periods(lines: Iterable[str]) -> Iterator[float]:
    for text in lines:
        match = BY_PERIOD.search(text) or PER_SAMPLE.search(text)
        if match is not None and _number(match) > 0:
            yield 1.0 / (_number(match) * SECONDS[unit_of_word(match["unit"] or "s") or "s"])


def _of_blocks(lines: Sequence[str]) -> Iterator[float]:
    """Yield numbers that stand alone in the line below the name of a block of Vicon Nexus."""
    bare = [text.strip(AROUND) for text in lines]
    for before, text in pairwise(bare):
        rate = number_of(text, ".") if before in BLOCKS else None
        if rate is not None:
            yield rate


def _number(match: re.Match[str]) -> float:
    return float(match["number"].replace(",", "."))


def _plain_header(lines: Sequence[Line], separator: str, width: int) -> Header:
    """Return the header in lines of names and of units; `lines` begins with the one nearest to the rows."""
    nearest = [_header_cells(line, separator, width) for line in lines]
    has_units = len(nearest) > 1 and bool(nearest[1]) and (is_units(nearest[0]) or _stand_below(*nearest[:2]))
    units, at = (nearest[0], 1) if has_units else ([], 0)
    if len(nearest) <= at or not nearest[at]:
        return Header([], [])
    names = nearest[at]
    for line in lines[at + 1 :] if separator != BLANKS else ():
        if is_comment(line.text) or (all(names) and len(set(names)) == len(names)):
            break
        groups = names_of(line.text, separator, width)[:width]
        named = names if all(map(_is_of_a_device, groups)) else _with_groups(groups, names)
        names = named if len(set(named)) > len(set(names)) else names
    units = (units + [""] * len(names))[: len(names)]
    return Header(names, [unit.strip("()[] ") for unit in units], lines[at].number)


def _is_of_a_device(cell: str) -> bool:
    return not cell or IDENTIFIER.fullmatch(cell) is not None


def _stand_below(cells: Sequence[str], names: Sequence[str]) -> bool:
    """Return whether cells are units that nobody knows: they stand below different names, one of them the time."""
    times = time_names(names)
    if len(set(names)) < len(names) or not all(names[1:]) or not times:
        return False
    below = dict(zip(names, cells, strict=False)).get(times[0], "")
    return unit_of_word(below) is not None or not time_names(cells)


def _header_cells(line: Line, separator: str, width: int) -> list[str]:
    """Return the cells of a line that can be a header of rows of `width` cells, else none."""
    text = without_mark(line.text) if is_comment(line.text) else line.text
    cells = names_of(text, separator, width)
    if len(cells) == width + 1 and (not cells[-1] or cells[-1].casefold().rstrip("s") in {"comment", "remark"}):
        cells.pop()  # LabVIEW writes no separator behind rows without a comment
    if len(cells) not in {width, width - 1} or not any(cells) or KEY.fullmatch(cells[0]):
        return []
    filled = [cell for cell in cells if cell]
    return [] if all(map(is_like_a_number, filled)) else ["" if _is_no_name(cell) else cell for cell in cells]


def _is_no_name(cell: str) -> bool:
    """Return whether a cell of a header names nothing: what pandas writes, or when the header was written."""
    return NO_NAME.fullmatch(cell) is not None or is_moment(cell)


def _with_groups(groups: Sequence[str], names: Sequence[str]) -> list[str]:
    """Return names with those in the line above them: a marker over its X, Y and Z, the time over nothing.

    The line above counts only where names stand twice, or are missing, and when it is no title of few cells.
    """
    filled = [name for name in names if name]
    if 2 * len(groups) < len(names):
        return list(names)
    groups = [*groups, *[""] * (len(names) - len(groups))]
    has_twins = len(set(filled)) < len(filled)
    has_gaps = any(over and not name for over, name in zip(groups, names, strict=True))
    if not has_twins and not (has_gaps and sum(map(bool, groups)) > 1):
        return list(names)
    named, group = [], ""
    for over, name in zip(groups, names, strict=True):
        group = over or group
        stands_under = name and group and (names.count(name) > 1 or has_gaps)
        named.append(f"{group} {name}" if stands_under else name or over)
    return named


def _keyed_header(lines: Sequence[Line], separator: str, width: int) -> Header:
    """Return the header whose names stand in an object of JSON, or behind a key; `lines` as of `_plain_header`."""
    names: list[str] = []
    units: list[str] = []
    for line in lines:
        text = without_mark(line.text) if is_comment(line.text) else line.text
        in_object = unique_names(_columns_in(text))
        if in_object and len(in_object) == width:
            return Header(in_object, [""] * len(in_object))
        key, *values = cells_of(text, separator) or [""]
        while values and not values[-1]:
            values.pop()
        if NAMES_KEY.fullmatch(key) and not names:
            names = values
        elif UNITS_KEY.fullmatch(key) and not units:
            units = values
    found = _spread(names, width)
    if len(units) != len(names):
        units = []
    return Header(found, ["", *units] if len(found) == len(units) + 1 else (units + [""] * len(found))[: len(found)])


def _columns_in(text: str) -> list[str]:
    """Return the names of columns in an object of JSON, those of several devices one after the other."""
    if not text.startswith("{"):
        return []
    try:
        return _columns_of(json.loads(text))
    except (ValueError, RecursionError):
        return []


def _columns_of(document: object) -> list[str]:
    if not isinstance(document, dict):
        return []
    own = document.get("column", document.get("columns"))
    if isinstance(own, list):
        return [str(name) for name in own]
    return [name for part in document.values() for name in _columns_of(part)]


def _spread(names: Sequence[str], width: int) -> list[str]:
    """Return a name for each of `width` columns: those given, behind the time, or three for each; else none."""
    if not names:
        return []
    in_space = [f"{name} {axis}" for name in names for axis in AXES]
    for columns in ([*names], [TIME, *names], in_space, [FRAME, TIME, *in_space]):
        if len(columns) == width:
            return columns
    return []
