"""What axe-core finds on a page: violations of any impact, and contrast that it could not decide."""

from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from typing import Any

from browser.eyes.contrast import too_faint
from browser.script import script
from browser.sizes import SIZES, window

THEMES = {
    "light": {"color_scheme": "light", "contrast": "no-preference", "forced_colors": "none"},
    "dark": {"color_scheme": "dark", "contrast": "no-preference", "forced_colors": "none"},
    "contrast": {"color_scheme": "light", "contrast": "more", "forced_colors": "none"},
    "forced": {"color_scheme": "dark", "contrast": "more", "forced_colors": "active"},
}
CELLS = [(size, theme) for theme in THEMES for size in SIZES]
# Nobody drives by, or draws a plan on, a screen as small as a telephone's; a halted trial is one that is driven.
NOT_ON_TELEPHONES = {"drive", "drive, runs", "drive, stopped", "drive, screen out of reach", "plans, edit"}
# The 3D picture in a frame is another page. One character is text too, and a sign is text: their contrast is decided
# like any other's; the other options are axe's own.
RUN = script("axe_findings")
IN_DRAWING = """(targets) => targets.filter((target) => document.querySelector(target)?.closest("svg"))"""
# After a change of size or theme: styles are computed and transitions have ended.
SETTLE = 150  # ms


@dataclass(frozen=True)
class Finding:
    """One element that breaks one rule."""

    kind: str
    rule: str
    impact: str
    target: str
    html: str
    why: str

    def __str__(self) -> str:
        return f"{self.kind} {self.rule} ({self.impact}) {self.target}: {self.why} [{self.html}]"


@cache
def _script() -> str:
    return files("axe_playwright_python").joinpath("axe.min.js").read_text(encoding="utf-8")


def findings(page: Any) -> list[Finding]:
    """Return what axe finds on the page as it is now.

    What lies half behind something else is scrolled into the middle and looked at once more; letters in a drawing are
    measured in pictures.
    """
    if not page.evaluate("() => 'axe' in window"):
        page.evaluate(_script())  # by the debugging protocol: the content policy allows no other script
    found = [Finding(**one) for one in page.evaluate(RUN, None)]
    open_ones = {one.target: one for one in found if one.rule == "color-contrast" and one.kind == "undecided"}
    drawn = page.evaluate(IN_DRAWING, list(open_ones))
    left = [one for one in found if one not in open_ones.values()]
    for target in sorted(open_ones.keys() - set(drawn)):
        again = [Finding(**one) for one in page.evaluate(RUN, target)]
        left += [one for one in again if one.target == target]
    faint = too_faint(page, drawn)
    return left + [replace(open_ones[target], kind="violation", why=why) for target, why in faint.items()]


def cells_of(name: str) -> list[tuple[str, str]]:
    """Return the sizes and themes in which a place is looked at."""
    return [cell for cell in CELLS if cell[0] != "390x844" or name not in NOT_ON_TELEPHONES]


def look_as(page: Any, cell: tuple[str, str], settle: float = SETTLE) -> None:
    """Give the page a size and a theme, and wait for `settle` ms."""
    page.set_viewport_size(window(cell[0]))
    page.emulate_media(**THEMES[cell[1]])
    page.wait_for_timeout(settle)
