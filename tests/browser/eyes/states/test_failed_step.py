"""A step of the calibration that failed: the sentence on the page names the button that repeats it."""

import pytest
from browser.eyes.places import PLACES, put_back
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]


def test_the_sentence_names_the_button_that_is_there(page, clinic):
    PLACES["calibrate, failed"](page, clinic)
    expect(page.get_by_role("button", name="Repeat this step")).to_be_visible()
    expect(page.locator("main")).to_contain_text("tap Repeat this step.")
    expect(page.locator("main")).not_to_contain_text("tap Start")
    put_back(clinic)
