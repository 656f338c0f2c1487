"""What is touched is large enough: 24 px and a place of its own for each lamp and each handle, 44 px in the rail.

`test_axe.py` measures everything else that is touched, on each page that it visits.
"""

import math
import re

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES
from browser.eyes.sweep import small_targets
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

SIZES = ["768x1024", pytest.param("1280x800", marks=pytest.mark.long), pytest.param("390x844", marks=pytest.mark.long)]
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


@pytest.mark.parametrize("size", SIZES)
def test_a_lamp_is_24_px_wide_and_has_a_place_of_its_own(page, clinic, size):
    look_as(page, (size, "light"))
    PLACES["shirt"](page, clinic)
    lamps = page.evaluate(LAMPS)
    assert len(lamps) == 52
    assert min(min(one["width"], one["height"]) for one in lamps) >= 24
    for number, one in enumerate(lamps):
        for other in lamps[:number]:
            if other["side"] == one["side"]:
                assert math.hypot(one["x"] - other["x"], one["y"] - other["y"]) >= 24
    # 22 px beside the outermost lamp: a finger of 44 px still picks it.
    outermost = min((one for one in lamps if one["side"] == lamps[0]["side"]), key=lambda one: one["x"])
    page.locator(".bodies").scroll_into_view_if_needed()
    moved = page.evaluate(LAMPS)[lamps.index(outermost)]
    page.mouse.click(moved["x"] - 22, moved["y"])
    expect(page.locator(".bodies .sensor").nth(lamps.index(outermost))).to_have_attribute("aria-checked", "true")


@pytest.mark.parametrize("size", SIZES)
def test_a_handle_is_24_px_wide_and_taken_from_22_px_beside_it(page, clinic, size):
    look_as(page, (size, "light"))
    PLACES["controls"](page, clinic)
    handles = page.evaluate(HANDLES)
    assert len(handles) >= 8
    assert min(one["width"] for one in handles) >= 24
    assert min(one["height"] for one in handles) >= 44
    assert all(one["isHit"] for one in handles)


def test_on_a_telephone_each_step_of_the_rail_is_wide_enough(page, clinic):
    look_as(page, ("390x844", "light"))
    PLACES["patients"](page, clinic)
    assert small_targets(page) == []


@pytest.mark.parametrize("size", [(320, 256), (640, 400)])  # 1280 px enlarged by 4 and by 2
def test_enlarged_the_rail_covers_nothing_of_the_page(page, clinic, size):
    page.set_viewport_size({"width": size[0], "height": size[1]})
    PLACES["patients"](page, clinic)
    foot, rail = (page.locator(one).bounding_box() for one in (".page > .body", ".rail"))
    beside = rail["x"] + rail["width"] <= foot["x"]
    assert beside or foot["y"] + foot["height"] <= rail["y"] + 1


def test_on_a_telephone_no_column_of_the_log_is_hidden(page, clinic):
    look_as(page, ("390x844", "light"))
    PLACES["log"](page, clinic)
    assert page.locator(".log-table tbody tr").count() > 0
    table = page.locator(".log-rows .scroll-x")
    assert table.evaluate("(one) => one.scrollWidth <= one.clientWidth")


def test_on_a_telephone_the_lamps_of_the_header_keep_their_words(page, clinic):
    look_as(page, ("390x844", "light"))
    PLACES["chair"](page, clinic)
    lamps = page.locator(".lamps .lamp:visible")
    expect(lamps).to_have_text([re.compile("^Shirt"), "Real chair: disarmed"])
    assert lamps.evaluate_all("(all) => all.every((one) => one.scrollWidth <= one.clientWidth)")
    foot, head = page.locator(".head .lamps").bounding_box(), page.locator(".head").bounding_box()
    assert foot["y"] + foot["height"] <= head["y"] + head["height"]
