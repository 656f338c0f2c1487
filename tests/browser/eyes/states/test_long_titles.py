"""A button that names what a person gave a title to stands whole in the window of a telephone."""

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back

pytestmark = [pytest.mark.browser]

BEYOND = """() => [...document.querySelectorAll("main .btn")]
  .filter((one) => one.getBoundingClientRect().right > innerWidth).map((one) => one.textContent)"""


def test_the_button_back_to_an_unsaved_plan_is_in_view(page, clinic):
    look_as(page, ("390x844", "light"))
    PLACES["plans, unsaved before"](page, clinic)
    assert page.evaluate(BEYOND) == []
    put_back(clinic)
