"""What comes late, be it news of a change made elsewhere or a picture, moves nothing that a person is about to use."""

from typing import get_args

import pytest
from browser.eyes.axe import look_as
from browser.eyes.opening import leave
from browser.eyes.places import PLACES
from browser.sizes import SIZES
from playwright.sync_api import expect

from app.api.live.live_picture import ClinicLive
from app.news import News, What

pytestmark = [pytest.mark.browser]

# All that may change on the server, of everybody; "graphics" asks the pages to count their pictures.
NEWS = [News(what=what) for what in get_args(What) if what != "graphics"]
DRAWN_WITHIN = 600  # ms; a page that is slower is looked at before it could go wrong
OFTEN = ("patients", "calibrate", "calibrate, begin anew", "controls", "drive")  # what two tablets show at once
FEW, MOST = 3, 5  # controls of a page that are looked at, from its first to its last
OPEN = "() => { for (const one of document.querySelectorAll('main details')) one.open = true; }"
COUNT_OPEN = "() => document.querySelectorAll('main details[open]').length"
NAME = """(one) => `${one.localName} "${
  (one.getAttribute("aria-label") ?? (one.closest("label") ?? one).textContent).trim().slice(0, 60)}"`"""
# Of radio buttons, only the chosen one can have the focus.
CONTROLS = """() => [...document.querySelectorAll("main :is(a[href], button, input, select, textarea, summary)")]
  .filter((one) => one.checkVisibility({ visibilityProperty: true }) && !one.closest("[inert]"))
  .filter((one) => !one.disabled && one.tabIndex >= 0 && (one.type !== "radio" || one.checked))"""
FOCUS = f"""(number) => {{
  const one = ({CONTROLS})()[number];
  one?.focus();
  return one && document.activeElement === one ? ({NAME})(one) : null;
}}"""


def spread(count, most):
    """Return the numbers of at most `most` of so many controls, from the first to the last."""
    return sorted({round(number * (count - 1) / (most - 1)) for number in range(most)}) if count else []


@pytest.mark.parametrize(
    ("name", "most"),
    [(name, FEW) for name in OFTEN] + [pytest.param(name, MOST, marks=pytest.mark.long) for name in PLACES],
)
def test_focus_and_what_is_open_stay(page, clinic, until, name, most):
    PLACES[name](page, clinic)
    page.evaluate(OPEN)
    moved = {}
    for number in spread(page.evaluate(f"({CONTROLS})().length"), most):
        before, opened = page.evaluate(FOCUS, number), page.evaluate(COUNT_OPEN)
        if before is None:  # it is covered by a dialog, or has just gone
            continue
        for news in NEWS:
            clinic.app.state.parts[ClinicLive].notify(news)
        page.wait_for_timeout(DRAWN_WITHIN)
        until(page, "document.activeElement !== document.body")  # a page may still be on its way
        now = page.evaluate(f"() => ({NAME})(document.activeElement)")
        if now != before:
            moved[before] = now
        if page.evaluate(COUNT_OPEN) < opened:
            moved["what was open"] = "closed"
    assert moved == {}


@pytest.mark.parametrize(
    ("name", "below"), [("drive", ".drive-places a >> nth=0"), ("drive tasks", ".paths a >> nth=-1")]
)
def test_a_plan_that_comes_late_moves_nothing(page, clinic, name, below):
    leave(page, clinic)
    held, is_late = [], True

    def hold(route):
        if is_late:
            held.append(route)
        else:
            route.continue_()

    def tops():
        """Return where the target begins in each size, px."""
        found = {}
        for size in SIZES:
            look_as(page, (size, "light"))
            found[size] = target.evaluate("(one) => one.getBoundingClientRect().top")
        return found

    page.route("**/api/v1/floorplans/*", hold)
    page.goto(f"{clinic.address}/#/{name.replace(' ', '/')}")
    target = page.locator(below)
    expect(target).to_be_attached()
    before = tops()
    assert page.locator(".plan-place .plan").count() == 0
    is_late = False
    for route in held:
        route.continue_()
    expect(page.locator(".plan-place .plan")).to_have_count(page.locator(".plan-place").count())
    assert tops() == before
    page.unroute_all()
