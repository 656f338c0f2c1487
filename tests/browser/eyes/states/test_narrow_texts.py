"""Sentences beside short words get enough width to be read, and push nothing else out of view."""

import pytest
from browser.eyes.axe import SIZES
from browser.eyes.places import PLACES, put_back

pytestmark = [pytest.mark.browser]

LEGEND = """() => [...document.querySelectorAll(".lamp-legend dd")]
  .map((one) => one.offsetWidth / one.parentElement.offsetWidth)"""
# How much of what is seen of the list of trials the column has that says how each ended.
END = """() => {
  const table = document.querySelector("table.trials"), seen = table.closest(".scroll-x").clientWidth;
  return table.rows[1].cells[2].offsetWidth / seen;
}"""


def measured(page, clinic, name, size, expression):
    width, height = SIZES[size]
    page.set_viewport_size({"width": width, "height": height})
    PLACES[name](page, clinic)
    found = page.evaluate(expression)
    put_back(clinic)
    return found


def test_what_a_lamp_means_has_most_of_the_width_of_a_telephone(page, clinic):
    assert min(measured(page, clinic, "shirt, estimated", "390x844", LEGEND)) >= 0.6


def test_the_interruptions_of_a_trial_leave_room_for_its_measures(page, clinic):
    assert measured(page, clinic, "review, interrupted", "768x1024", END) <= 0.4
