"""A learning curve as a drawing: each trial, the fitted curve with its band, and where sessions begin."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from app.features.reports.document import Drawing
from app.features.reports.svg import area, dot, label, line, nice_step, picture
from app.number_words import with_minus
from app.scoring.measures import Measure

WIDTH, HEIGHT = 250.0, 128.0  # points
LEFT, RIGHT, TOP, BOTTOM = 30.0, 6.0, 8.0, 20.0
MOST_SESSION_MARKS = 12


class CurvePoint(NamedTuple):
    """One trial in a learning curve."""

    number: int
    session: int
    value: float
    reported: bool  # whether it belongs to what is reported
    familiarisation: bool


def curve_drawing(
    points: Sequence[CurvePoint], fit: dict[str, Any] | None, measure: Measure, words: str
) -> Drawing | None:
    """Draw a learning curve; None without points. `fit` as of `app.scoring.learning.learning_curves`."""
    if not points:
        return None
    values = [point.value for point in points]
    values += [value for name in ("low", "high") for value in (fit or {}).get(name, ()) if _near(value, values)]
    low, high = min(0.0, *values), max(*values, min(values) + 1e-9)
    step = nice_step(high - low or 1.0, 4)
    high = low + step * max(1, -(-(high - low) // step))
    first, last = points[0].number, max(points[-1].number, points[0].number + 1)

    def place(number: float, value: float) -> tuple[float, float]:
        x = LEFT + 4 + (WIDTH - LEFT - RIGHT - 8) * (number - first) / (last - first)
        share = (min(max(value, low), high) - low) / (high - low)
        return x, TOP + (HEIGHT - TOP - BOTTOM) * (1 - share)

    parts = [*_axes(low, high, step, measure), *_sessions(points, place)]
    if fit is not None:
        upper = [place(n, value) for n, value in zip(fit["n"], fit["high"], strict=True)]
        lower = [place(n, value) for n, value in zip(fit["n"], fit["low"], strict=True)]
        parts += [area([*upper, *lower[::-1]], "band")]
        parts += [line([place(n, value) for n, value in zip(fit["n"], fit["value"], strict=True)], "path", 1.2)]
    radius = 2.0 if len(points) <= 60 else 1.2
    parts += [
        dot(*place(one.number, one.value), radius, "now" if one.reported else "before", hollow=one.familiarisation)
        for one in points
    ]
    y = HEIGHT - BOTTOM + 9
    parts.append(label(place(first, low)[0], y, f"{first}", anchor="middle"))
    if len(points) > 1:
        parts.append(label(place(points[-1].number, low)[0], y, f"{points[-1].number}", anchor="middle"))
    parts.append(label((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 3, "trial", anchor="middle"))
    return Drawing(picture(WIDTH, HEIGHT, parts), words)


def _near(value: float, values: Sequence[float]) -> bool:
    """Whether a bound of the band is near the trials: a wide band at the edge must not flatten them."""
    span = max(values) - min(values) or 1.0
    return min(values) - span <= value <= max(values) + span


def _axes(low: float, high: float, step: float, measure: Measure) -> list[str]:
    parts = []
    for number in range(round((high - low) / step) + 1):
        value = low + number * step
        y = TOP + (HEIGHT - TOP - BOTTOM) * (1 - (value - low) / (high - low))
        words = with_minus(f"{value * measure.factor:.6g}")
        parts += [line([(LEFT, y), (WIDTH - RIGHT, y)], "line", 0.5), label(LEFT - 3, y + 2.4, words, anchor="end")]
    return [*parts, label(2, 6, measure.unit)]


def _sessions(points: Sequence[CurvePoint], place: Any) -> list[str]:
    """Return a mark where each session begins; with many sessions only of some."""
    starts = {point.session: point.number for point in reversed(points)}
    every = sorted(starts)
    kept = every[:: -(-len(every) // MOST_SESSION_MARKS)]
    parts = []
    for session in kept:
        x, _ = place(starts[session] - (0.5 if starts[session] > points[0].number else 0), 0.0)
        parts.append(line([(x, TOP), (x, HEIGHT - BOTTOM)], "line", 0.5, dash="1.5 1.5"))
        parts.append(label(x + 1.5, TOP - 2, f"S{session}"))
    return parts
