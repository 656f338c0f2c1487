"""What a theme must not take away: bars and marks in forced colours, a whole page in the dark."""

import io

import numpy as np
import pytest
from browser.eyes.axe import look_as
from browser.eyes.contrast import contrast, luminance
from browser.eyes.places import PLACES, put_back
from PIL import Image

pytestmark = [pytest.mark.browser]

SEEN = 3.0  # contrast ratio of what is not text


def picture(page, selector):
    """Return the pixels of the first element, (height, width, 3)."""
    shot = page.locator(selector).first.screenshot(scale="css")
    return np.asarray(Image.open(io.BytesIO(shot)).convert("RGB"), float)


def test_forced_colours_leave_bars_and_the_current_step(page, clinic):
    look_as(page, ("1280x800", "forced"))
    PLACES["calibrate, result"](page, clinic)
    bar = picture(page, ".evr")
    row = bar[len(bar) // 2]
    filled, rest = row[len(row) // 4], row[len(row) - 6]
    assert contrast(filled, rest) >= SEEN
    put_back(clinic)
    PLACES["calibrate"](page, clinic)
    current, other = (picture(page, f".steps li:{where} span") for where in ("has([aria-current])", "last-child"))
    corner = (slice(6, 8), slice(14, 18))  # above the number
    assert contrast(current[corner].mean((0, 1)), other[corner].mean((0, 1))) >= SEEN
    put_back(clinic)


def test_forced_colours_leave_the_line_of_a_slider(page, clinic):
    look_as(page, ("1280x800", "forced"))
    PLACES["review trial"](page, clinic)
    slider = picture(page, ".play-bar input[type=range]")
    right = slider[:, slider.shape[1] // 2 :]  # the handle is at the left
    assert contrast(right, np.zeros(3)).max() >= SEEN
    put_back(clinic)


@pytest.mark.parametrize(("theme", "is_dark"), [("light", False), ("dark", True), ("contrast", True)])
def test_the_page_that_connects_a_device_follows_the_system(page, clinic, theme, is_dark):
    look_as(page, ("390x844", theme))
    for name in ("tablet, not yet", "tablet, trusted"):
        PLACES[name](page, clinic)
        whole = np.asarray(Image.open(io.BytesIO(page.screenshot(scale="css"))).convert("RGB"), float)
        for ground in (whole[2, 2], whole[-2, 2]):  # above the page's text and below it
            assert (luminance(ground) < 0.1) == is_dark, (name, ground)
        put_back(clinic)


@pytest.mark.parametrize("theme", ["light", "dark", "contrast"])
def test_the_tick_and_the_switch_of_a_device_stand_out(page, clinic, theme):
    look_as(page, ("768x1024", theme))
    PLACES["tablet, trusted"](page, clinic)
    tick = picture(page, ".check svg")
    assert contrast(tick[36:39, 24:27].mean((0, 1)), tick[14, 28]) >= SEEN  # its corner, and the disc above it
    put_back(clinic)
    PLACES["tablet, not yet"](page, clinic)
    switch = picture(page, ".steps li:last-child svg g g, .steps li:last-child svg > g:last-of-type")
    row = switch[len(switch) // 2]
    width = len(row)
    knob, track = row[round(width * 0.907)], row[round(width * 0.81)]
    assert contrast(knob, track) >= SEEN
    put_back(clinic)


@pytest.mark.parametrize("theme", ["light", "dark", "contrast"])
def test_the_shared_page_has_one_ground_and_a_button_to_touch(page, clinic, theme):
    look_as(page, ("390x844", theme))
    PLACES["share link, PIN"](page, clinic)
    whole = np.asarray(Image.open(io.BytesIO(page.screenshot(scale="css"))).convert("RGB"), float)
    top, foot = whole[2, 2], whole[-2, 2]
    assert contrast(top, foot) < 1.1
    assert page.get_by_role("button", name="Open").bounding_box()["height"] >= 44
    put_back(clinic)
