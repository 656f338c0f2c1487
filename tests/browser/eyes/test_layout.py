"""What stands on a page is seen whole, apart from what stands beside it, and is large enough to touch.

Each place is opened once, and looked at in each size. `test_axe.py` measures on every page what else is touched.
"""

import math
import re

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back
from browser.eyes.states.live_places import estimated_lamps
from browser.eyes.sweep import small_targets
from browser.sizes import SIZES
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

TABLET, TELEPHONE = "768x1024", "390x844"
ENLARGED = ((320, 256), (640, 400))  # px: 1280 px enlarged by 4 and by 2
MOST_EMPTY = 24  # px below the last words of the header: less than a row
LEAST_LAMP, LEAST_HANDLE, BESIDE = 24, 44, 22  # px
LAMPS = """() => [...document.querySelectorAll(".bodies .sensor")].map((one) => {
  const { left, top, width, height } = one.firstElementChild.getBoundingClientRect();
  return { side: one.closest("figure").textContent, x: left + width / 2, y: top + height / 2, width, height };
})"""
HANDLES = """() => [...document.querySelectorAll(".handle")].map((one) => {
  one.scrollIntoView({ block: "center", behavior: "instant" });
  const { left, top, width, height } = one.getBoundingClientRect();
  const [x, y] = [left + width / 2, top + height / 2];
  const hits = [-22, 22].map((away) => document.elementFromPoint(x + away, y)?.closest(".handle, .handles"));
  return { width, height, isHit: hits.every(Boolean) };
})"""
# What of the header is cut, or lies outside of it.
CUT = """() => {
  const header = document.querySelector(".head").getBoundingClientRect();
  return [...document.querySelectorAll(".head :is(.lamp, .me, .who, .stop)")].filter((one) => one.checkVisibility())
    .filter((one) => {
      const { top, bottom, left, right } = one.getBoundingClientRect();
      const isOutside = top < header.top || bottom > header.bottom || left < 0 || right > innerWidth;
      return isOutside || one.scrollWidth > one.clientWidth || one.scrollHeight > one.clientHeight + 1;
    })
    .map((one) => one.textContent);
}"""
EMPTY = """() => {
  const words = [...document.querySelectorAll(".head :is(.lamp, .me, .who, .stop)")];
  const lowest = Math.max(...words.map((one) => one.getBoundingClientRect().bottom));
  return document.querySelector(".head").getBoundingClientRect().bottom - lowest;
}"""
# How far each element of a selector reaches beyond the right edge of what scrolls it sideways, px.
BEYOND = """(selector) => [...document.querySelectorAll(selector)].map((one) =>
  Math.round(one.getBoundingClientRect().right - one.closest(".scroll-x").getBoundingClientRect().right))"""
# The room between an element and the next one beside it, px.
ROOM = """([before, after]) => document.querySelector(after).getBoundingClientRect().top
  - document.querySelector(before).getBoundingClientRect().bottom"""
LINES = """(selector) => [...document.querySelectorAll(selector)].map((one) => one.getClientRects().length)"""
CUT_BUTTONS = """() => [...document.querySelectorAll("main .btn")]
  .filter((one) => one.getBoundingClientRect().right > innerWidth).map((one) => one.textContent)"""
LEGEND = """() => [...document.querySelectorAll(".lamp-legend dd")]
  .map((one) => one.offsetWidth / one.parentElement.offsetWidth)"""
# How much of what is seen of the list of trials the column has that says how each ended.
END = """() => {
  const table = document.querySelector("table.trials"), seen = table.closest(".scroll-x").clientWidth;
  return table.rows[1].cells[2].offsetWidth / seen;
}"""


@pytest.fixture
def in_sizes(page, clinic):
    """Return what opens a place and yields each size in which it is shown from then on."""

    def visit(name, *sizes):
        look_as(page, (sizes[0], "light"))
        PLACES[name](page, clinic)
        for size in sizes:
            look_as(page, (size, "light"))
            yield size

    return visit


def test_a_lamp_is_24_px_wide_and_has_a_place_of_its_own(page, in_sizes):
    for size in in_sizes("shirt", *SIZES):
        lamps = page.evaluate(LAMPS)
        assert len(lamps) == 52, size
        assert min(min(one["width"], one["height"]) for one in lamps) >= LEAST_LAMP, size
        for number, one in enumerate(lamps):
            for other in lamps[:number]:
                if other["side"] == one["side"]:
                    assert math.hypot(one["x"] - other["x"], one["y"] - other["y"]) >= LEAST_LAMP, size
        # Beside the outermost lamp, a finger of 44 px still picks it.
        outermost = min((one for one in lamps if one["side"] == lamps[0]["side"]), key=lambda one: one["x"])
        page.locator(".bodies").scroll_into_view_if_needed()
        moved = page.evaluate(LAMPS)[lamps.index(outermost)]
        page.mouse.click(moved["x"] - BESIDE, moved["y"])
        expect(page.locator(".bodies .sensor").nth(lamps.index(outermost))).to_have_attribute("aria-checked", "true")
        page.locator(".bodies .sensor").nth(20).click()  # in the next size, the outermost is picked again


def test_a_handle_is_24_px_wide_and_taken_from_22_px_beside_it(page, in_sizes):
    for size in in_sizes("controls", *SIZES):
        handles = page.evaluate(HANDLES)
        assert len(handles) >= 8, size
        assert min(one["width"] for one in handles) >= LEAST_LAMP, size
        assert min(one["height"] for one in handles) >= LEAST_HANDLE, size
        assert all(one["isHit"] for one in handles), size


def test_each_step_of_the_rail_is_wide_enough_on_a_telephone_and_covers_nothing_when_enlarged(page, in_sizes):
    for _ in in_sizes("patients", TELEPHONE):
        assert small_targets(page) == []
    for width, height in ENLARGED:
        page.set_viewport_size({"width": width, "height": height})
        foot, rail = (page.locator(one).bounding_box() for one in (".page > .body", ".rail"))
        beside = rail["x"] + rail["width"] <= foot["x"]
        assert beside or foot["y"] + foot["height"] <= rail["y"] + 1, width


def test_on_a_telephone_no_column_of_the_log_is_hidden(page, in_sizes):
    for _ in in_sizes("log", TELEPHONE):
        assert page.locator(".log-table tbody tr").count() > 0
        assert page.locator(".log-rows .scroll-x").evaluate("(one) => one.scrollWidth <= one.clientWidth")


def test_the_lamps_of_the_header_are_read_whole(page, clinic, in_sizes):
    for name in ("shirt", "shirt, estimated", "drive, screen out of reach", "chair, silent"):
        for size in in_sizes(name, TABLET, TELEPHONE):
            assert page.evaluate(CUT) == [], (name, size)
            assert page.evaluate(EMPTY) < MOST_EMPTY, (name, size)
            if name == "shirt, estimated" and size == TELEPHONE:  # what a lamp means has most of the width
                assert min(page.evaluate(LEGEND)) >= 0.6
        estimated_lamps(clinic)  # the longest words that the lamp of the shirt has
        expect(page.locator(".head .lamp").first).to_contain_text("estimated")
        for size in (TELEPHONE, TABLET):
            look_as(page, (size, "light"))
            assert page.evaluate(CUT) == [], (name, size, "estimated")
            assert page.evaluate(EMPTY) < MOST_EMPTY, (name, size, "estimated")
        put_back(clinic)


def test_on_a_telephone_the_lamp_of_a_real_chair_keeps_its_words(page, in_sizes):
    for _ in in_sizes("chair", TELEPHONE):
        lamps = page.locator(".lamps .lamp:visible")
        expect(lamps).to_have_text([re.compile("^Shirt"), "Real chair: disarmed"])
        assert lamps.evaluate_all("(all) => all.every((one) => one.scrollWidth <= one.clientWidth)")
        foot, head = page.locator(".head .lamps").bounding_box(), page.locator(".head").bounding_box()
        assert foot["y"] + foot["height"] <= head["y"] + head["height"]


def test_the_button_back_to_an_unsaved_plan_is_in_view(page, in_sizes):
    for _ in in_sizes("plans, unsaved before", TELEPHONE):
        assert page.evaluate(CUT_BUTTONS) == []


def test_the_interruptions_of_a_trial_leave_room_for_its_measures(page, in_sizes):
    for _ in in_sizes("review, interrupted", TABLET):
        assert page.evaluate(END) <= 0.4


def test_the_links_of_a_report_are_in_view(page, in_sizes, until):
    for size in in_sizes("review, warnings", TABLET, TELEPHONE):
        link = page.get_by_role("link", name="Make the web page")
        link.scroll_into_view_if_needed()
        until(page, "document.querySelector('main').scrollWidth <= innerWidth")  # once the charts have followed
        box = link.bounding_box()
        assert box["x"] + box["width"] <= page.viewport_size["width"], size


def test_a_figure_and_its_unit_stay_on_one_line_and_words_beside_it_have_room(page, in_sizes):
    for size in in_sizes("adapt, proposal", TABLET, TELEPHONE):
        lines = page.evaluate(LINES, ".adapt-figures b")
        assert len(lines) >= 12, size
        assert set(lines) == {1}, size
        assert max(page.evaluate(BEYOND, ".map-versions tr > *")) <= 0, size
        width = page.locator(".adapt-head").bounding_box()["width"]
        assert page.locator(".adapt-head .grow").bounding_box()["width"] >= 0.7 * width, size


def test_verdicts_on_sessions_are_in_view(page, in_sizes):
    for size in in_sizes("session compare, verdicts", TABLET, TELEPHONE):
        beyond = page.evaluate(BEYOND, ".measures tr > *")
        assert len(beyond) >= 40, size
        assert max(beyond) <= 0, size
    assert "From the sofa to the guest room" in page.locator("main h2").first.inner_text()
    counts = page.get_by_text("Trials of session").first.inner_text()
    assert re.fullmatch(r"(Trials of session \d: driven \d+, counting \d+, compared [1-9]\d*\. ?){2}", counts), counts


def verdicts_are_in_view(page, size):
    beyond = page.evaluate(BEYOND, ".measures .change")
    assert len(beyond) >= 6, size
    assert max(beyond) <= 0, size


def test_verdicts_of_two_trials_are_in_view(page, in_sizes):
    for size in in_sizes("review compare, verdicts", TABLET, TELEPHONE):
        verdicts_are_in_view(page, size)


def test_verdicts_of_a_trial_are_in_view_and_its_cards_stand_apart_without_a_recording(page, in_sizes):
    room = "(one) => one.getBoundingClientRect().top - one.previousElementSibling.getBoundingClientRect().bottom"
    for size in in_sizes("drive, over, verdicts", TABLET, TELEPHONE):
        verdicts_are_in_view(page, size)
        card = page.locator(".card").filter(has=page.get_by_role("heading", name="Quality of control"))
        assert card.evaluate(room) >= 10, size


def test_worse_verdicts_are_in_view_and_the_warning_and_the_way_on_stand_apart(page, in_sizes):
    card = ".session-verdicts "
    for size in in_sizes("review, worse", TABLET, TELEPHONE):
        assert page.evaluate(ROOM, [f"{card}.problem", f"{card}.session-verdict"]) >= 10, size
        assert page.evaluate(ROOM, [f"{card}.noise-note", f"{card}.noise-note ~ p .btn"]) >= 10, size
        openers = page.locator(".session-verdicts summary").all()
        for opener in openers:
            opener.click()
        verdicts_are_in_view(page, size)
        for opener in openers:
            opener.click()


def test_patients_who_need_attention_stand_apart(page, in_sizes):
    rows = ".attention .person"
    for size in in_sizes("attention, worse", TABLET, TELEPHONE):
        assert page.evaluate(ROOM, [f"{rows}:nth-child(1)", f"{rows}:nth-child(2)"]) >= 8, size
