"""The band of a measure as a drawing: where a level is within noise, the earlier level and the one that is reported."""

from app.features.reports.document import Drawing, Tone
from app.features.reports.svg import area, dot, line, picture
from app.scoring.verdict.measure_verdict import Verdict

WIDTH, HEIGHT, EDGE = 96.0, 11.0, 4.0  # points


def band_drawing(verdict: Verdict, tone: Tone, words: str) -> Drawing | None:
    """Draw a verdict; None without a band."""
    low, high, earlier, later = verdict.low, verdict.high, verdict.earlier, verdict.later
    if low is None or high is None or earlier is None or later is None:
        return None
    least, most = min(low, later), max(high, later)
    if not most > least:
        return None

    def x_of(value: float) -> float:
        return EDGE + (WIDTH - 2 * EDGE) * (value - least) / (most - least)

    middle = HEIGHT / 2
    corners = [(x_of(low), 2.0), (x_of(high), 2.0), (x_of(high), HEIGHT - 2), (x_of(low), HEIGHT - 2)]
    parts = [
        line([(EDGE, middle), (WIDTH - EDGE, middle)], "line", 0.6),
        area(corners, "band"),
        line([(x_of(earlier), 2.0), (x_of(earlier), HEIGHT - 2)], "before", 1.2),
        dot(x_of(later), middle, 2.8, tone or "ink"),
    ]
    return Drawing(picture(WIDTH, HEIGHT, parts), words)
