"""The picture of a ring that is turned shows the way that puts it right."""

import math

import pytest
from browser.eyes.places import PLACES, put_back

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
    put_back(clinic)
