"""Lines that a monitor of a serial line has written: the time of arrival before an arrow, a label before each number.

`15:21:10.020 -> 512,300` is of the Arduino IDE, `ax:0.1,ay:0.2` of programs for its plotter. Without the arrow and the
labels, such lines are those of a table.
"""

import re
from typing import Final, NamedTuple

BEGINNING: Final = 20_000  # letters in which the form of the lines is looked for
MOSTLY: Final = 0.8  # share of lines that have the form
ARROW: Final = re.compile(r"^(\d{1,2}:\d\d:\d\d[.,]\d{1,6}) -> ?", re.MULTILINE)
SEPARATORS: Final = ("\t", ";", ",")  # that are looked for behind the arrow
LABEL: Final = re.compile(r"(?<![^\s,;|])([^\W\d]\w*(?: \w+)?)[ \t]*[:=][ \t]*(?=[-+.\d])")
REST: Final = re.compile(r"[\d\s.,;|eE+-]*")  # of a line, without labels


class LogForm(NamedTuple):
    """How the lines are to be changed."""

    arrow: str  # what stands in place of the arrow; empty where there is none
    labels: tuple[str, ...]  # names of the columns, the time's included; empty where there are none


def log_form(text: str) -> LogForm | None:
    """Return the form of lines of a monitor; None for any other text."""
    lines = [line for line in text[:BEGINNING].split("\n")[:-1] if line.strip()]
    if not lines:
        return None
    behind = [ARROW.sub("", line) for line in lines]
    has_arrow = sum(map(str.__ne__, lines, behind)) >= MOSTLY * len(lines)
    found = [tuple(LABEL.findall(line)) for line in behind if REST.fullmatch(LABEL.sub("", line))]
    labels = max(set(found), key=found.count, default=())
    has_labels = bool(labels) and found.count(labels) >= MOSTLY * len(lines)
    if not has_arrow and not has_labels:
        return None
    mark = next((each for each in SEPARATORS if sum(each in line for line in behind) >= MOSTLY * len(lines)), ",")
    names = labels if has_labels else ()
    return LogForm(mark if has_arrow else "", ("Time", *names) if has_arrow and names else names)


def plain_text(text: str, log: LogForm) -> str:
    """Return lines of a monitor as those of a table."""
    if log.arrow:
        text = ARROW.sub(rf"\1{log.arrow}", text)
    return LABEL.sub("", text) if log.labels else text
