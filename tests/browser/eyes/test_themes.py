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


def test_forced_colours_leave_the_line_of_a_slider(page, clinic):
    look_as(page, ("1280x800", "forced"))
    PLACES["review trial"](page, clinic)
    slider = picture(page, ".play-bar input[type=range]")
    right = slider[:, slider.shape[1] // 2 :]  # the handle is at the left
    assert contrast(right, np.zeros(3)).max() >= SEEN


def test_the_page_that_connects_a_device_follows_the_system_and_its_tick_and_switch_stand_out(page, clinic):
    """The ground is looked at on a telephone; the tick of a device and the switch of its settings on a tablet."""
    look_as(page, ("390x844", "light"))
    for name, stands_out in (("tablet, not yet", the_switch_stands_out), ("tablet, trusted", the_tick_stands_out)):
        PLACES[name](page, clinic)
        for theme, is_dark in (("light", False), ("dark", True), ("contrast", True)):
            look_as(page, ("390x844", theme))
            whole = whole_window(page)
            for ground in (whole[2, 2], whole[-2, 2]):  # above the page's text and below it
                assert (luminance(ground) < 0.1) == is_dark, (name, theme, ground)
            look_as(page, ("768x1024", theme))
            assert stands_out(page), (name, theme)


def whole_window(page):
    """Return the pixels of the window, (height, width, 3)."""
    return np.asarray(Image.open(io.BytesIO(page.screenshot(scale="css"))).convert("RGB"), float)


def the_tick_stands_out(page):
    tick = picture(page, ".check svg")
    return contrast(tick[36:39, 24:27].mean((0, 1)), tick[14, 28]) >= SEEN  # its corner, and the disc above it


def the_switch_stands_out(page):
    switch = picture(page, ".steps li:last-child svg g g, .steps li:last-child svg > g:last-of-type")
    row = switch[len(switch) // 2]
    knob, track = row[round(len(row) * 0.907)], row[round(len(row) * 0.81)]
    return contrast(knob, track) >= SEEN


def test_the_shared_page_has_one_ground_and_a_button_to_touch(page, clinic):
    look_as(page, ("390x844", "light"))
    PLACES["share link, PIN"](page, clinic)
    for theme in ("light", "dark", "contrast"):
        look_as(page, ("390x844", theme))
        whole = whole_window(page)
        assert contrast(whole[2, 2], whole[-2, 2]) < 1.1, theme
        assert page.get_by_role("button", name="Open").bounding_box()["height"] >= 44, theme
