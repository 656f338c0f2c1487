"""SVG for drawings of reports: elements with plain attributes, which both renderers can draw.

A class stands beside each colour: the HTML report changes colours by it in a dark room.
"""

import math
from collections.abc import Sequence
from typing import Final

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
FONT: Final = "Noto Sans"

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


def label(x: float, y: float, words: str, *, anchor: str = "start", colour: str = "quiet") -> str:
    """Return a label; `words` are the program's own, numbers and units."""
    place = f'x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"'
    return f'<text class="f-{colour}" {place} fill="{COLOURS[colour]}">{words}</text>'


def nice_step(span: float, steps: int) -> float:
    """Return a step of 1, 2 or 5 times a power of ten, so that about `steps` of them make the span (above 0)."""
    raw = span / steps
    power = 10.0 ** math.floor(math.log10(raw))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= raw * (1 - 1e-9))
