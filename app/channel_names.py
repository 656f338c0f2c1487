"""Names of channels and joints, made of the texts by which devices and files call their channels."""

import re
import unicodedata
from collections.abc import Iterable, Iterator
from typing import Final

from app.layout import MAX_CHANNELS

LONGEST_NAME: Final = 50  # characters of a channel or joint; a number follows where two would be equal
_OF_JOINT: Final = re.compile(r"(?P<joint>.+?)(?:[_.-]?\d+|[_.-][xyzwXYZW])")
"""The name of one of several channels of a joint: elbow_1, elbow2, hand.x."""


def plain_channel_name(text: str) -> str:
    """Return a text as a name of letters and digits without accents; empty when nothing is left of it."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9_.-]+", "_", plain)[:LONGEST_NAME].strip("_.-")


def joint_in_name(name: str) -> str:
    """Return a channel's name without the number or axis at its end: right_elbow_3 is one of right_elbow."""
    match = _OF_JOINT.fullmatch(name)
    return match["joint"] if match else name


def different_names(names: Iterable[str]) -> Iterator[str]:
    """Yield names, with a number behind each that was there before."""
    taken = set[str]()
    for name in names:
        free = (free for free in _with_numbers(name) if free not in taken)
        taken.add(found := next(free))
        yield found


def _with_numbers(name: str) -> Iterator[str]:
    yield name
    for number in range(2, 2 * MAX_CHANNELS):
        yield f"{name}_{number}"
