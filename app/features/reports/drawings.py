"""The drawings of a report as SVG, with plain attributes that both renderers can draw.

They are the band of a measure, a learning curve, and all trajectories over the prescribed path. A class stands beside
each colour: the HTML report changes colours by it in a dark room.
"""

import math
from collections.abc import Sequence
from typing import Any, Final, NamedTuple

from app.features.reports.characters import FONT
from app.features.reports.document import Drawing, Tone
from app.number_format import with_minus
from app.scoring.measures import Measure
from app.scoring.verdict.measure_verdict import Verdict
from app.texts import Text, value_text

COLOURS: Final = {
    "ink": "#16202a",
    "quiet": "#53606c",
    "line": "#dfe3df",
    "path": "#1d5fa8",
    "now": "#c2410c",
    "before": "#848e97",
    "band": "#e4e8ec",
    "good": "#2b6a34",
    "bad": "#b91c1c",
}

Points = Sequence[tuple[float, float]]  # points on paper, y downwards


def picture(width: float, height: float, parts: Sequence[str]) -> str:
    """Return a picture of this size in points."""
    size = f'width="{width:g}pt" height="{height:g}pt" viewBox="0 0 {width:g} {height:g}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="{FONT}" font-size="7">{"".join(parts)}</svg>'


def line(points: Points, colour: str, width: float, *, opacity: float = 1.0, dash: str = "") -> str:
    """Return a line through points."""
    given = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    dashes = f' stroke-dasharray="{dash}"' if dash else ""
    look = f'stroke="{COLOURS[colour]}" stroke-width="{width:g}" stroke-opacity="{opacity:g}"{dashes}'
    ends = 'fill="none" stroke-linejoin="round" stroke-linecap="round"'
    return f'<polyline class="s-{colour}" points="{given}" {look} {ends}/>'


def area(points: Points, colour: str) -> str:
    """Return a filled area."""
    given = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polygon class="f-{colour}" points="{given}" fill="{COLOURS[colour]}"/>'


def dot(x: float, y: float, radius: float, colour: str, *, hollow: bool = False) -> str:
    """Return a dot, or a ring."""
    place = f'cx="{x:.1f}" cy="{y:.1f}" r="{radius:g}"'
    if hollow:
        return f'<circle class="s-{colour}" {place} fill="none" stroke="{COLOURS[colour]}" stroke-width="0.8"/>'
    return f'<circle class="f-{colour}" {place} fill="{COLOURS[colour]}"/>'


def label(x: float, y: float, text: str, *, anchor: str = "start", colour: str = "quiet") -> str:
    """Return a label; `text` is the program's own, and has no character that XML would have to escape."""
    place = f'x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"'
    return f'<text class="f-{colour}" {place} fill="{COLOURS[colour]}">{text}</text>'


def nice_step(span: float, steps: int) -> float:
    """Return a step of 1, 2 or 5 times a power of ten, so that about `steps` of them make the span (above 0)."""
    raw = span / steps
    power = 10.0 ** math.floor(math.log10(raw))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= raw * (1 - 1e-9))


BAND_WIDTH, BAND_HEIGHT, BAND_EDGE = 96.0, 11.0, 4.0  # points


def band_drawing(verdict: Verdict, tone: Tone, description: str) -> Drawing | None:
    """Draw a verdict; None without a band."""
    low, high, earlier, later = verdict.low, verdict.high, verdict.earlier, verdict.later
    if low is None or high is None or earlier is None or later is None:
        return None
    least, most = min(low, later), max(high, later)
    if not most > least:
        return None

    def x_of(value: float) -> float:
        return BAND_EDGE + (BAND_WIDTH - 2 * BAND_EDGE) * (value - least) / (most - least)

    middle = BAND_HEIGHT / 2
    corners = [(x_of(low), 2.0), (x_of(high), 2.0), (x_of(high), BAND_HEIGHT - 2), (x_of(low), BAND_HEIGHT - 2)]
    parts = [
        line([(BAND_EDGE, middle), (BAND_WIDTH - BAND_EDGE, middle)], "line", 0.6),
        area(corners, "band"),
        line([(x_of(earlier), 2.0), (x_of(earlier), BAND_HEIGHT - 2)], "before", 1.2),
        dot(x_of(later), middle, 2.8, tone or "ink"),
    ]
    return Drawing(picture(BAND_WIDTH, BAND_HEIGHT, parts), description)


WIDTH, HEIGHT = 250.0, 128.0  # points
CURVE_LEFT, CURVE_RIGHT, CURVE_TOP, CURVE_BOTTOM = 30.0, 6.0, 8.0, 20.0
MOST_SESSION_MARKS = 12


class CurvePoint(NamedTuple):
    """One trial in a learning curve."""

    number: int
    session: int
    value: float
    reported: bool  # whether it belongs to what is reported
    familiarisation: bool


def curve_drawing(
    points: Sequence[CurvePoint], fit: dict[str, Any] | None, measure: Measure, description: str
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
        x = CURVE_LEFT + 4 + (WIDTH - CURVE_LEFT - CURVE_RIGHT - 8) * (number - first) / (last - first)
        share = (min(max(value, low), high) - low) / (high - low)
        return x, CURVE_TOP + (HEIGHT - CURVE_TOP - CURVE_BOTTOM) * (1 - share)

    parts = [*_axes(low, high, step, measure), *_sessions(points, place)]
    if fit is not None:
        upper = [place(n, value) for n, value in zip(fit["n"], fit["high"], strict=True)]
        lower = [place(n, value) for n, value in zip(fit["n"], fit["low"], strict=True)]
        parts += [area([*upper, *lower[::-1]], "band")]
        parts += [line([place(n, value) for n, value in zip(fit["n"], fit["value"], strict=True)], "path", 1.2)]
    radius = 2.0 if len(points) <= 60 else 1.2
    parts += [
        dot(
            *place(curve_point.number, curve_point.value),
            radius,
            "now" if curve_point.reported else "before",
            hollow=curve_point.familiarisation,
        )
        for curve_point in points
    ]
    y = HEIGHT - CURVE_BOTTOM + 9
    parts.append(label(place(first, low)[0], y, f"{first}", anchor="middle"))
    if len(points) > 1:
        parts.append(label(place(points[-1].number, low)[0], y, f"{points[-1].number}", anchor="middle"))
    axis = str(Text("report-curve-axis"))
    parts.append(label((CURVE_LEFT + WIDTH - CURVE_RIGHT) / 2, HEIGHT - 3, axis, anchor="middle"))
    return Drawing(picture(WIDTH, HEIGHT, parts), description)


def _near(value: float, values: Sequence[float]) -> bool:
    """Whether a bound of the band is near the trials: a wide band at the edge must not flatten them."""
    span = max(values) - min(values) or 1.0
    return min(values) - span <= value <= max(values) + span


def _axes(low: float, high: float, step: float, measure: Measure) -> list[str]:
    parts = []
    for number in range(round((high - low) / step) + 1):
        value = low + number * step
        y = CURVE_TOP + (HEIGHT - CURVE_TOP - CURVE_BOTTOM) * (1 - (value - low) / (high - low))
        text = with_minus(value_text(float(f"{value * measure.factor:.6g}")))
        parts += [
            line([(CURVE_LEFT, y), (WIDTH - CURVE_RIGHT, y)], "line", 0.5),
            label(CURVE_LEFT - 3, y + 2.4, text, anchor="end"),
        ]
    return [*parts, label(2, 6, str(measure.unit))]


def _sessions(points: Sequence[CurvePoint], place: Any) -> list[str]:
    """Return a mark where each session begins; with many sessions only of some."""
    starts = {point.session: point.number for point in reversed(points)}
    every = sorted(starts)
    shown = every[:: -(-len(every) // MOST_SESSION_MARKS)]
    parts = []
    for session in shown:
        x, _ = place(starts[session] - (0.5 if starts[session] > points[0].number else 0), 0.0)
        parts.append(line([(x, CURVE_TOP), (x, HEIGHT - CURVE_BOTTOM)], "line", 0.5, dash="1.5 1.5"))
        parts.append(label(x + 1.5, CURVE_TOP - 2, f"S{session}"))
    return parts


PATH_EDGE = 8.0  # points; a narrow path is drawn lower
LEAST_HEIGHT = 60.0
SCALE_BAR = 12.0  # points below the drawing

Trajectory = Sequence[tuple[float, float]]  # m


def trajectory_drawing(
    path: Trajectory, before: Sequence[Trajectory], now: Sequence[Trajectory], description: str
) -> Drawing:
    """Draw the path, the earlier trajectories below, and those that are reported above.

    `path` has at least one point. A trajectory that goes far from the path makes everything smaller, so that all of it
    is seen.
    """
    every = [point for points in (path, *before, *now) for point in points]
    left, right = min(x for x, _ in every), max(x for x, _ in every)
    low, high = min(y for _, y in every), max(y for _, y in every)
    wide, tall = max(right - left, 1.0), max(high - low, 1.0)
    scale = min((WIDTH - 2 * PATH_EDGE) / wide, (HEIGHT - 2 * PATH_EDGE - SCALE_BAR) / tall)
    height = max(LEAST_HEIGHT, tall * scale + 2 * PATH_EDGE + SCALE_BAR)
    x_0 = (WIDTH - wide * scale) / 2
    y_0 = (height - SCALE_BAR + (high - low) * scale) / 2

    def on_paper(points: Trajectory) -> list[tuple[float, float]]:
        return [(x_0 + (x - left) * scale, y_0 - (y - low) * scale) for x, y in points]

    target = on_paper(path)
    parts = [line(target, "path", 4.0, opacity=0.25)]
    parts += [line(on_paper(points), "before", 0.6, opacity=0.7) for points in before]
    parts += [line(on_paper(points), "now", 0.8, opacity=0.85) for points in now]
    parts += [line(target, "path", 0.9, dash="3 2"), dot(*target[0], 3.0, "path", hollow=True)]
    parts += [dot(*target[-1], 3.0, "path")]
    return Drawing(picture(WIDTH, height, [*parts, *_scale_bar(scale, wide, height)]), description)


def _scale_bar(scale: float, wide: float, height: float) -> list[str]:
    metres = nice_step(wide, 5)
    end, y = WIDTH - PATH_EDGE, height - 4.0
    return [
        line([(end - metres * scale, y), (end, y)], "quiet", 1.0),
        label(end - metres * scale - 3, y + 2, str(Text("report-scale-bar", length=metres)), anchor="end"),
    ]
