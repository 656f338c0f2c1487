"""Who asks for reduced motion sees none: nothing is animated, and nothing glides from one state to the next."""

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back

pytestmark = [pytest.mark.browser]

NAMES = ("shirt", "calibrate, runs", "controls", "drive, over", "review trial", "stereo", "tablet", "patient's screen")
# What moves after everything that opens was turned over, and every switch was pressed.
MOVES = """() => {
  document.querySelectorAll("details").forEach((one) => (one.open = !one.open));
  document.querySelectorAll(".switch input").forEach((one) => (one.checked = !one.checked));
  document.querySelectorAll(".tune").forEach((one) => one.setAttribute("aria-expanded", "true"));
  getComputedStyle(document.body).opacity;
  return document.getAnimations({ subtree: true }).map(({ effect, animationName, transitionProperty }) =>
    `${animationName ?? transitionProperty} of ${effect.target.className} ${effect.pseudoElement ?? ""}`);
}"""


@pytest.mark.parametrize("motion", ["reduce", "no-preference"])
def test_nothing_moves_for_who_asks_for_that(page, clinic, motion):
    look_as(page, ("1280x800", "light"))
    page.emulate_media(reduced_motion=motion)
    moves = {}
    for name in NAMES if motion == "reduce" else NAMES[:1]:
        PLACES[name](page, clinic)
        found = page.evaluate(MOVES)
        if found:
            moves[name] = found
        put_back(clinic)
    page.emulate_media(reduced_motion="no-preference")
    assert (moves == {}) == (motion == "reduce"), moves
