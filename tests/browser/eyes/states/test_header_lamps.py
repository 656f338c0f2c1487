"""What the header's lamps say is read whole on a tablet and on a telephone, and so is who is signed in."""

import pytest
from browser.eyes.axe import SIZES
from browser.eyes.places import PLACES, put_back
from browser.eyes.states.live_places import estimated_lamps
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

MOST_EMPTY = 24  # px below the last words of the header: less than a row
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


@pytest.mark.parametrize("size", ["768x1024", "390x844"])
@pytest.mark.parametrize("name", ["shirt", "shirt, estimated", "drive, screen out of reach", "chair, silent"])
def test_the_lamps_are_read_whole(page, clinic, size, name):
    width, height = SIZES[size]
    page.set_viewport_size({"width": width, "height": height})
    PLACES[name](page, clinic)
    found = [page.evaluate(CUT)]
    empty = [page.evaluate(EMPTY)]
    estimated_lamps(clinic)  # the longest words that the lamp of the shirt has
    expect(page.locator(".head .lamp").first).to_contain_text("estimated")
    found.append(page.evaluate(CUT))
    empty.append(page.evaluate(EMPTY))
    put_back(clinic)
    assert found == [[], []]
    assert max(empty) < MOST_EMPTY
