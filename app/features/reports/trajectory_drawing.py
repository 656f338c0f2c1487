"""All trajectories over the prescribed path as a drawing, to scale."""

from collections.abc import Sequence

from app.features.reports.document import Drawing
from app.features.reports.svg import dot, label, line, nice_step, picture

WIDTH, HEIGHT, EDGE = 250.0, 128.0, 8.0  # points; a narrow path is drawn lower
LEAST_HEIGHT = 60.0
SCALE_BAR = 12.0  # points below the drawing

Points = Sequence[tuple[float, float]]  # m


def trajectory_drawing(path: Points, before: Sequence[Points], now: Sequence[Points], words: str) -> Drawing:
    """Draw the path, the earlier trajectories below, and those that are reported above.

    `path` has at least one point. A trajectory that goes far from the path makes everything smaller, so that all of it
    is seen.
    """
    every = [point for points in (path, *before, *now) for point in points]
    left, right = min(x for x, _ in every), max(x for x, _ in every)
    low, high = min(y for _, y in every), max(y for _, y in every)
    wide, tall = max(right - left, 1.0), max(high - low, 1.0)
    scale = min((WIDTH - 2 * EDGE) / wide, (HEIGHT - 2 * EDGE - SCALE_BAR) / tall)
    height = max(LEAST_HEIGHT, tall * scale + 2 * EDGE + SCALE_BAR)
    x_0 = (WIDTH - wide * scale) / 2
    y_0 = (height - SCALE_BAR + (high - low) * scale) / 2

    def on_paper(points: Points) -> list[tuple[float, float]]:
        return [(x_0 + (x - left) * scale, y_0 - (y - low) * scale) for x, y in points]

    target = on_paper(path)
    parts = [line(target, "path", 4.0, opacity=0.25)]
    parts += [line(on_paper(points), "before", 0.6, opacity=0.7) for points in before]
    parts += [line(on_paper(points), "now", 0.8, opacity=0.85) for points in now]
    parts += [line(target, "path", 0.9, dash="3 2"), dot(*target[0], 3.0, "path", hollow=True)]
    parts += [dot(*target[-1], 3.0, "path")]
    return Drawing(picture(WIDTH, height, [*parts, *_scale_bar(scale, wide, height)]), words)


def _scale_bar(scale: float, wide: float, height: float) -> list[str]:
    metres = nice_step(wide, 5)
    end, y = WIDTH - EDGE, height - 4.0
    return [
        line([(end - metres * scale, y), (end, y)], "quiet", 1.0),
        label(end - metres * scale - 3, y + 2, f"{metres:g} m", anchor="end"),
    ]
