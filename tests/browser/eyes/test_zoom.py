"""At 200 % and 400 % nothing is lost: no page scrolls sideways, Stop stays in view, every button can be reached.

A browser of 1280 x 800 pixels that enlarges by 2 lays out 640 x 400; one of 1280 x 1024 that enlarges by 4, 320 x 256.
"""

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back
from browser.eyes.sweep import lost

pytestmark = [pytest.mark.browser, pytest.mark.long]

ZOOMS = {"200 %": (640, 400, 2), "400 %": (320, 256, 4)}
SHORT = (  # one place of each kind of page
    "sign_in", "patients, new", "shirt, lamp", "calibrate", "controls", "drive", "drive, stopped", "drive, over",
    "review", "review trial", "settings, paired", "plans", "people, invite", "log", "chair", "patient's screen",
    "review, warnings", "session compare, verdicts",
)  # fmt: skip
WITHOUT_STOP = ("stereo", "tablet", "phone", "patient's screen", "share link", "docs")  # no clinician drives by them


@pytest.fixture(params=ZOOMS)
def enlarged(request, browser, clinic):
    """Yield the owner's page, enlarged."""
    width, height, factor = ZOOMS[request.param]
    context = browser.new_context(
        storage_state=clinic.storage(), viewport={"width": width, "height": height}, device_scale_factor=factor
    )
    page = context.new_page()
    page.set_default_timeout(60_000)
    yield page
    context.close()


def losses(page, clinic, names):
    """Return what is lost, by place."""
    by_place = {}
    for name in names:
        PLACES[name](page, clinic)
        page.wait_for_timeout(200)
        found = lost(page)
        if not name.startswith(WITHOUT_STOP) and page.locator("#stop").count() == 0:
            found.append("there is no Stop")
        if found:
            by_place[name] = found
        put_back(clinic)
    return by_place


def test_nothing_is_lost_in_any_state(enlarged, clinic):
    assert losses(enlarged, clinic, PLACES) == {}


@pytest.mark.parametrize("cell", [("768x1024", "light"), ("1280x800", "light"), ("390x844", "light")])
def test_no_state_scrolls_sideways(page, clinic, cell):
    look_as(page, cell)
    assert losses(page, clinic, SHORT) == {}
