"""What failed, what is refused and what sits otherwise than it should: the page says so, and shows the way on."""

import math

import pytest
from browser.eyes.opening import leave
from browser.eyes.places import PLACES
from browser.eyes.states.role_places import refused
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

MIDDLE = 110  # px of the picture
FRONT = 1.5  # the place at the top: that of the front of the limb
SENSORS = 8
ARROW = """() => {
  const turn = document.querySelector(".sits .turn").getAttribute("d").match(/^M (\\S+) (\\S+) A .* (\\S+) (\\S+) L/);
  return turn.slice(1).map(Number);
}"""

SIDES = """() => Array.from(document.querySelectorAll(".sits .side"),
  (words) => [words.textContent, words.getBoundingClientRect().top])"""


def place(x: float, y: float) -> int:
    """Return the place of the ring, counted round the limb."""
    return round((math.atan2(y - MIDDLE, x - MIDDLE) + math.pi / 2) * SENSORS / (2 * math.pi) + FRONT) % SENSORS


def test_the_arrow_goes_from_where_a_sensor_lies_to_where_it_belongs(page, clinic):
    """With a shift of 3, the sensor of place 3 lies at place 0 (`sensors_at`)."""
    PLACES["calibrate, turned"](page, clinic)
    x0, y0, x1, y1 = page.evaluate(ARROW)
    assert (place(x0, y0), place(x1, y1)) == (0, 3)
    heights = dict(page.evaluate(SIDES))
    assert heights["front"] == min(heights.values())
    assert heights["back"] == max(heights.values())
    assert heights.keys() == {"front", "back", "outer side", "inner side"}


def test_the_sentence_on_a_failed_step_names_the_button_that_is_there(page, clinic):
    PLACES["calibrate, failed"](page, clinic)
    expect(page.get_by_role("button", name="Repeat this step")).to_be_visible()
    expect(page.locator("main")).to_contain_text("tap Repeat this step.")
    expect(page.locator("main")).not_to_contain_text("tap Start")


def test_every_page_of_an_owner_leads_a_clinician_to_another(page, clinic):
    leave(page, clinic)
    clinic.visit(page, "clinician")
    for name in ("people", "log", "computer", "backup"):
        refused(name)(page, clinic)  # waits for the link
        assert page.get_by_role("button", name="Try again").count() == 0, name
        assert page.get_by_text("Only an owner").count() == 1, name
