"""What many trials make of a page is seen without scrolling sideways, whole and apart from what stands beside it."""

import re

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back

pytestmark = [pytest.mark.browser]

# How far each element of a selector reaches beyond the right edge of what scrolls it sideways, px.
BEYOND = """(selector) => [...document.querySelectorAll(selector)].map((one) =>
  Math.round(one.getBoundingClientRect().right - one.closest(".scroll-x").getBoundingClientRect().right))"""
# The room between an element and the next one beside it, px.
ROOM = """([before, after]) => document.querySelector(after).getBoundingClientRect().top
  - document.querySelector(before).getBoundingClientRect().bottom"""
LINES = """(selector) => [...document.querySelectorAll(selector)].map((one) => one.getClientRects().length)"""


@pytest.fixture(params=["768x1024", "390x844"])
def visited(request, page, clinic):
    """Yield what opens a place at a size, and gives the page."""

    def visit(name):
        look_as(page, (request.param, "light"))
        PLACES[name](page, clinic)
        return page

    yield visit
    put_back(clinic)


def test_verdicts_on_sessions_are_in_view(visited):
    page = visited("session compare, verdicts")
    beyond = page.evaluate(BEYOND, ".measures tr > *")
    assert len(beyond) >= 40
    assert max(beyond) <= 0
    assert "From the sofa to the guest room" in page.locator("main h2").first.inner_text()
    counts = page.get_by_text("Trials of session").first.inner_text()
    assert re.fullmatch(r"(Trials of session \d: driven \d+, counting \d+, compared [1-9]\d*\. ?){2}", counts), counts


@pytest.mark.parametrize("name", ["drive, over, verdicts", "review compare, verdicts", "review, worse"])
def test_verdicts_of_trials_are_in_view(visited, name):
    page = visited(name)
    for opener in page.locator(".session-verdicts summary").all():
        opener.click()
    beyond = page.evaluate(BEYOND, ".measures .change")
    assert len(beyond) >= 6
    assert max(beyond) <= 0


def test_the_links_of_a_report_are_in_view(visited):
    page = visited("review, warnings")
    link = page.get_by_role("link", name="Make the web page")
    link.scroll_into_view_if_needed()
    assert page.evaluate("() => document.querySelector('main').scrollWidth <= innerWidth")
    box = link.bounding_box()
    assert box["x"] + box["width"] <= page.viewport_size["width"]


def test_the_warning_and_the_way_on_stand_apart(visited):
    page = visited("review, worse")
    card = ".session-verdicts "
    assert page.evaluate(ROOM, [f"{card}.problem", f"{card}.session-verdict"]) >= 10
    assert page.evaluate(ROOM, [f"{card}.noise-note", f"{card}.noise-note ~ p .btn"]) >= 10


def test_patients_who_need_attention_stand_apart(visited):
    page = visited("attention, worse")
    rows = ".attention .person"
    assert page.evaluate(ROOM, [f"{rows}:nth-child(1)", f"{rows}:nth-child(2)"]) >= 8


def test_a_trial_without_a_recording_keeps_its_cards_apart(visited):
    page = visited("drive, over, verdicts")
    card = page.locator(".card").filter(has=page.get_by_role("heading", name="Quality of control"))
    room = "(one) => one.getBoundingClientRect().top - one.previousElementSibling.getBoundingClientRect().bottom"
    assert card.evaluate(room) >= 10


def test_a_figure_and_its_unit_stay_on_one_line(visited):
    page = visited("adapt, proposal")
    lines = page.evaluate(LINES, ".adapt-figures b")
    assert len(lines) >= 12
    assert set(lines) == {1}
    assert max(page.evaluate(BEYOND, ".map-versions tr > *")) <= 0


def test_words_beside_a_large_figure_have_room(visited):
    page = visited("adapt, proposal")
    width = page.locator(".adapt-head").bounding_box()["width"]
    assert page.locator(".adapt-head .grow").bounding_box()["width"] >= 0.7 * width
