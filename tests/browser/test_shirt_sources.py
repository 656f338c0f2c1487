"""Where the movements come from: a card for each source, one tap to choose, and what is wrong when nothing arrives."""

import pytest
from browser.served.clinic_app import go
from browser.sizes import each_size, fits, keep, window
from playwright.sync_api import expect

from app.arrivals import Arrivals
from app.hardware.configs import KINDS
from app.texts import Text, to_document

pytestmark = [pytest.mark.browser]

LEAST = 47.5  # px: 48 and the rounding of a browser
SMALL = """(least) => [...document.querySelectorAll(
  "[data-card=source] :is(label.choice, button, summary, select, input[type=text], input[type=number])"
)]
  .filter((one) => one.checkVisibility() && one.getBoundingClientRect().height < least)
  .map((one) => one.outerHTML.slice(0, 80))"""


@pytest.fixture
def page(browser, page_log, served):
    log = page_log(served.address)
    yield served.sign_in(log.watch(browser.new_page(viewport=window("768x1024"))), "A-03")
    log.assert_quiet()


def say(process, is_sending, arrivals):
    """Let the shirt say what arrives."""
    process.sends = is_sending
    process.arrivals = {**arrivals._asdict(), "message": to_document(arrivals.message)}


def looked_at(page, name):
    """Look at the card in each size: nothing is too wide, and what is touched is large enough."""
    for size in each_size(page, settle=50):
        keep(page, f"{size}-{name}")
        fits(page, "[data-card=source]", f"{name} {size}")
        assert page.evaluate(SMALL, LEAST) == [], (name, size)


def test_one_tap_chooses_a_source_and_when_nothing_arrives_the_page_says_why(page, served):
    go(page, "shirt")
    card = page.locator("[data-card=source]")
    expect(card.get_by_role("heading", name="Where do the movements come from?")).to_be_visible()
    sources = card.locator(".source-card")
    expect(sources).to_have_count(len(KINDS))
    expect(sources.locator("svg.source-picture path").first).to_be_visible()
    camera = sources.filter(has=page.get_by_text("A camera", exact=True))
    for words in ("Needs a device with a camera", "Costs nothing", "Takes a minute", "Never drives a real chair"):
        expect(camera).to_contain_text(words)
    looked_at(page, "sources")

    camera.get_by_text("A camera", exact=True).click()
    looked_at(page, "source-chosen")
    card.get_by_role("button", name="Use this").click()
    expect(card).to_contain_text("Camera, 30 frames a second")
    expect(card).to_contain_text("Never drives a real chair, for nothing proves whose movements it shows.")
    say(served.process, False, Arrivals("nothing", Text("arrivals-camera-nothing")))
    expect(card.get_by_role("heading", name="Nothing arrives?")).to_be_visible()
    expect(card).to_contain_text("No page sends as the camera: start it here")
    looked_at(page, "source-silent")

    card.locator("summary").click()
    card.get_by_text("A shirt over the network", exact=True).click()
    card.get_by_role("button", name="Use this").click()
    expect(card).to_contain_text("Network shirt on port 5252")
    why = Text("shirtdev-frame-sensors", sent=40, expected=52)
    foreign = Text("arrivals-foreign", count=12, size=184, sender="10.0.0.2:4000", why=why)
    say(served.process, False, Arrivals("foreign", foreign, 0, 12))
    expect(card.get_by_role("heading", name="Nothing arrives?")).to_be_visible()
    expect(card).to_contain_text("The newest has 184 bytes and comes from 10.0.0.2:4000")
    rate = Text("arrivals-rate", measured=50, expected=100)
    say(served.process, True, Arrivals("rate", rate, 500, 12))
    expect(card.get_by_role("heading", name="Something is not right")).to_be_visible()
    expect(card).to_contain_text("50 frames a second arrive, but 100 are set.")
    say(served.process, True, Arrivals("arrives", Text("arrivals-good"), 900, 12))
    expect(card).to_contain_text("Move one joint: its lamps light up.")
    expect(card.get_by_role("heading", name="Something is not right")).to_have_count(0)
