"""A trajectory from messages of robots: the place and the stamp in each, whatever its type calls them."""

from collections import defaultdict
from collections.abc import Iterable
from typing import Any, Final, NamedTuple

import numpy as np

from app.signals.file_table import listed
from app.signals.foreign.recording import OWN_TIME, ForeignRecording
from app.texts import Text

# Where a message has its place: odometry, a pose with its covariance, a pose with its stamp, a pose, a point.
PLACES: Final = (("pose", "pose", "position"), ("pose", "position"), ("position",), ("point",), ())
STAMPS: Final = (("header", "stamp"), ("stamp",), ("timestamp",))
NANOSECONDS: Final = 1e9


class TopicMessage(NamedTuple):
    """A message of a topic, decoded, and when it was recorded (ns since 1970)."""

    topic: str
    recorded: int
    content: Any


def trajectory_of(messages: Iterable[TopicMessage]) -> ForeignRecording:
    """Return t, x and y of the topic with the most places; further ones are left out and named."""
    rows: dict[str, list[tuple[float, float, float]]] = defaultdict(list)
    for message in messages:
        place = place_of(message.content)
        if place is not None:
            stamp = stamp_of(message.content)
            rows[message.topic].append((message.recorded / NANOSECONDS if stamp is None else stamp, *place))
    if not rows:
        return ForeignRecording({})
    topic = max(rows, key=lambda each: len(rows[each]))
    table = np.array(sorted(rows[topic]), dtype=np.float64)
    others = [each for each in rows if each != topic]
    note = Text("signals-topics-left-out", topic=topic, names=listed(others)) if others else None
    units = {OWN_TIME: "s", "x": "m", "y": "m"}
    return ForeignRecording({OWN_TIME: table[:, 0], "x": table[:, 1], "y": table[:, 2]}, units, note)


def place_of(message: Any) -> tuple[float, float] | None:
    """Return x and y (m) of a message; None when it has no place."""
    for names in PLACES:
        holder = _at(message, names)
        x, y = _at(holder, ("x",)), _at(holder, ("y",))
        if isinstance(x, int | float) and isinstance(y, int | float):
            return float(x), float(y)
    return None


def stamp_of(message: Any) -> float | None:
    """Return when a message was made, s since 1970; None when it does not say it."""
    for names in STAMPS:
        stamp = _at(message, names)
        for seconds, parts in (("sec", "nanosec"), ("secs", "nsecs"), ("sec", "nsec")):
            whole, part = _at(stamp, (seconds,)), _at(stamp, (parts,))
            if isinstance(whole, int) and isinstance(part, int) and whole + part > 0:
                return whole + part / NANOSECONDS
    return None


def _at(holder: Any, names: tuple[str, ...]) -> Any:
    """Return what stands at a path of attributes or keys; None where there is nothing."""
    for name in names:
        holder = holder.get(name) if isinstance(holder, dict) else getattr(holder, name, None)
    return holder
