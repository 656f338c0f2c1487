"""The contrast of letters in a drawing, measured in pictures: axe-core cannot say what lies behind them."""

import io
from typing import Any

import numpy as np
from browser.script import script
from PIL import Image

# Where the letters of these texts are, and what colour they have; the first one is scrolled into the middle.
PLACES = script("letters_in_drawings")
HIDE = """() => {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync("svg text, svg text * { fill: transparent !important; stroke: transparent !important; }");
  document.adoptedStyleSheets.push(sheet);
}"""
SHOW = "() => { document.adoptedStyleSheets.pop(); }"
LARGE, LARGE_BOLD = 24.0, 18.66  # px
LEAST, LEAST_LARGE = 4.5, 3.0


def luminance(colour: Any) -> Any:
    """Return the relative luminance of colours (..., 3) from 0 to 255, as WCAG defines it."""
    share = np.asarray(colour, float) / 255
    linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    return linear @ np.array([0.2126, 0.7152, 0.0722])


def contrast(colour: Any, behind: Any) -> Any:
    """Return the contrast ratio of colours (..., 3), 1 to 21."""
    first, second = luminance(colour), luminance(behind)
    return (np.maximum(first, second) + 0.05) / (np.minimum(first, second) + 0.05)


def too_faint(page: Any, targets: list[str]) -> dict[str, str]:
    """Return why letters are too faint, for those that are; every target is an SVG text."""
    words: dict[str, str] = {}
    left = list(targets)
    while left:
        places = page.evaluate(PLACES, left)
        page.evaluate(HIDE)
        behind = np.asarray(Image.open(io.BytesIO(page.screenshot(scale="css"))).convert("RGB"))
        page.evaluate(SHOW)
        later = []
        for target, place in zip(left, places, strict=True):
            if place is None:
                continue
            if not place["isSeen"] and target != left[0]:
                later.append(target)
                continue
            why = _why(place, behind)
            if why:
                words[target] = why
        left = later
    return words


def _why(place: dict[str, Any], picture: Any) -> str:
    left, top, right, bottom = (max(0, round(edge)) for edge in place["box"])
    behind = picture[top:bottom, left:right].reshape(-1, 3)
    if not len(behind):
        return "it cannot be brought into view"
    parts = [float(part) for part in place["colour"].split("(")[1].rstrip(")").split(",")]
    opacity = place["opacity"] * (parts[3] if len(parts) > 3 else 1)
    # Lines that cross a few pixels are no background: what at least a fifth of the box has is one.
    colours, counts = np.unique(behind, axis=0, return_counts=True)
    grounds = colours[counts >= 0.2 * counts.sum()]
    if not len(grounds):
        grounds = colours[[counts.argmax()]]
    least = float(contrast(opacity * np.array(parts[:3]) + (1 - opacity) * grounds, grounds).min())
    is_large = place["size"] >= LARGE or (place["size"] >= LARGE_BOLD and place["weight"] >= 700)
    needed = LEAST_LARGE if is_large else LEAST
    return "" if least >= needed else f"contrast {least:.2f} of {needed}, {place['size']:.0f} px"
