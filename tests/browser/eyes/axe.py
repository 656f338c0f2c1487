"""What axe-core finds on a page: violations of any impact, and contrast that it could not decide."""

from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from typing import Any

from browser.eyes.contrast import too_faint

SIZES = {"768x1024": (768, 1024), "1280x800": (1280, 800), "390x844": (390, 844)}
THEMES = {
    "light": {"color_scheme": "light", "contrast": "no-preference", "forced_colors": "none"},
    "dark": {"color_scheme": "dark", "contrast": "no-preference", "forced_colors": "none"},
    "contrast": {"color_scheme": "light", "contrast": "more", "forced_colors": "none"},
    "forced": {"color_scheme": "dark", "contrast": "more", "forced_colors": "active"},
}
CELLS = [(size, theme) for theme in THEMES for size in SIZES]
# Nobody drives by, or draws a plan on, a screen as small as a telephone's.
NOT_ON_TELEPHONES = {"drive", "drive, runs", "drive, stopped", "plans, edit"}
# The 3D picture in a frame is another page. One character is text too, and a sign is text: their contrast is decided
# like any other's; the other options are axe's own.
RUN = """(context) => {
  const contrast = {
    ignoreUnicode: false, ignoreLength: true, ignorePseudo: false, boldValue: 700, boldTextPt: 14, largeTextPt: 18,
    contrastRatio: { normal: { expected: 4.5 }, large: { expected: 3 } },
    pseudoSizeThreshold: 0.25, shadowOutlineEmMax: 0.2, textStrokeEmMin: 0.03,
  };
  axe.configure({ checks: [{ id: "color-contrast", options: contrast }] });
  const only = context && { runOnly: ["color-contrast"] };
  // In forced colours the browser paints text and what is behind it in colours of the person's own choice.
  const isForced = matchMedia("(forced-colors: active)").matches;
  const element = context && document.querySelector(context);
  if (context && !element) return [];
  element?.scrollIntoView({ block: "center", inline: "center", behavior: "instant" });
  // The foot of a page sticks to its lower edge: at the very end, nothing of the page lies behind it.
  element?.closest(".foot")?.parentElement.scrollTo({ top: 1e6, behavior: "instant" });
  // Nothing shows through a dialog whose background is solid, but axe counts what lies behind it.
  const dialog = element?.closest("[role=dialog]");
  const isSolid = dialog && /^rgb\\(/.test(getComputedStyle(dialog).backgroundColor);
  const behind = isSolid ? [...document.querySelectorAll("main")].filter((one) => !one.contains(dialog)) : [];
  for (const one of behind) one.style.visibility = "hidden";
  return axe.run(element ?? document, {
    iframes: false,
    resultTypes: ["violations", "incomplete"],
    ...(only ?? { rules: {
      "target-size": { enabled: true },
      "label-content-name-mismatch": { enabled: true }, // who says "click All" by voice says what is written
      "color-contrast": { enabled: !isForced },
    } }),
  }).then(({ violations, incomplete }) => {
    const rows = (kind, rules) => rules.flatMap(({ id, impact, nodes }) => nodes.map((node) => ({
      kind, rule: id, impact, target: node.target.join(" "), html: node.html.slice(0, 140),
      why: [...node.any, ...node.all, ...node.none].map(({ message }) => message).join(" ").slice(0, 200),
    })));
    const undecided = rows("undecided", incomplete)
      .filter(({ rule, why }) => rule === "color-contrast" || why.includes("encountered an error"));
    return [...rows("violation", violations), ...undecided];
  }).finally(() => { for (const one of behind) one.style.visibility = ""; });
}"""
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


def look_as(page: Any, cell: tuple[str, str]) -> None:
    """Give the page a size and a theme."""
    width, height = SIZES[cell[0]]
    page.set_viewport_size({"width": width, "height": height})
    page.emulate_media(**THEMES[cell[1]])
    page.wait_for_timeout(SETTLE)
