"""A map that loses something, on a tablet: suggested after trials, looked at, applied, taken back."""

import re

import pytest
from browser.driving import go_on_until
from playwright.sync_api import expect
from processes.served_demo import running_demo

from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser, pytest.mark.long]

TABLETS = {"768x1024": (768, 1024), "1280x800": (1280, 800)}
LONG_ENOUGH = re.compile(r"^(0:[45]\d|[1-9]:\d\d)$")  # a joint has moved for some seconds by then
TITLE = "What would change, and why"


@pytest.fixture
def demo():
    """Yield the link of a running demonstration."""
    with running_demo() as link:
        yield link


@pytest.fixture(params=list(TABLETS))
def tablet(request, browser, page_log, demo):
    """Yield a page of one tablet, signed in, and a function that keeps a screenshot."""
    width, height = TABLETS[request.param]
    page = browser.new_page(viewport={"width": width, "height": height}, has_touch=True)
    log = page_log(demo)
    log.watch(page)
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    page.goto(demo)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    yield page, lambda picture: page.screenshot(path=SCREENSHOTS / f"{request.param}-{picture}.png")
    log.assert_clean()
    page.close()


def go_to(page, step):
    page.goto(page.url.split("#")[0] + f"#/{step}")


def drive_for_a_while(page):
    go_to(page, "drive")
    page.get_by_role("button", name="Start trial").click()
    clock = page.locator(".place .big")
    expect(clock).to_be_visible()
    go_on_until(page, lambda: LONG_ENOUGH.match(clock.inner_text()), "40 seconds of the trial", seconds=150)
    page.get_by_role("button", name="End trial").first.click()
    expect(page.get_by_role("heading", name="Ended by hand")).to_be_visible()


def take_back_a_stop(page, wanted):
    """Take back the stop of a machine that was too busy at the end of the trial, until the wanted button is offered."""
    expect(wanted).to_be_visible()
    take_back = page.get_by_role("button", name="Take the stop back")
    if wanted.is_disabled() and take_back.is_visible():
        take_back.click()
    expect(wanted).to_be_enabled()


COUNT_FROM_LATER = """async () => {
    const api = `${location.origin}/api/v1`;
    const { session } = await (await fetch(`${api}/session`)).json();
    const { parameters: { profile, ...settings } } = await (await fetch(`${api}/controls`)).json();
    for (const gesture of settings.gestures) gesture.dead_zone = 0.4 * gesture.full;
    const headers = { "Content-Type": "application/json", "Patient-Session": String(session.id) };
    return (await fetch(`${api}/controls`, { method: "PUT", headers, body: JSON.stringify(settings) })).status;
}"""


def count_from_later(page):
    """Set all dead-zones so high that a part of every movement does not count."""
    assert page.evaluate(COUNT_FROM_LATER) == 200


def large_enough_to_touch(page):
    boxes = [one.bounding_box() for one in page.locator("main .btn, main .choice").all() if one.is_visible()]
    assert boxes
    assert all(box["height"] >= 44 and box["width"] >= 44 for box in boxes)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_a_suggestion_is_looked_at_applied_and_taken_back(tablet):
    page, keep = tablet
    go_to(page, "controls")
    page.get_by_role("link", name="What would change?").click()
    expect(page.get_by_role("heading", name=TITLE)).to_be_visible()
    expect(page).to_have_url(re.compile("#/adapt$"))  # it has begun to look by itself
    expect(page.get_by_text("Nothing was driven with this calibration yet")).to_be_visible()
    suggest = page.get_by_role("radio", name="Suggest")
    suggest.focus()
    page.keyboard.press("Space")
    expect(suggest).to_be_checked()
    expect(suggest).to_be_focused()
    keep("adapt-nothing-yet")

    drive_for_a_while(page)
    expect(page.get_by_role("link", name="A change of the calibration is suggested")).to_have_count(0)
    go_to(page, "adapt")
    expect(page.get_by_text("the calibration fits as well as before, and stays as it is")).to_be_visible()
    keep("adapt-nothing-lost")

    count_from_later(page)
    drive_for_a_while(page)
    drive_for_a_while(page)
    page.get_by_role("link", name="A change of the calibration is suggested").click()
    expect(page.get_by_text("Felt change")).to_be_visible()
    expect(page.locator(".adapt-joint").first).to_contain_text("of the time of its movements does not count")
    expect(page.locator(".adapt-head")).to_contain_text("a real chair arms only what was practised")
    large_enough_to_touch(page)
    keep("adapt-suggested")

    apply = page.get_by_role("button", name="Apply")
    take_back_a_stop(page, apply)
    apply.click()
    expect(page.locator(".adapt-head")).to_contain_text("Version 2 of the calibration is in use.")
    expect(page.locator(".adapt-head")).to_contain_text("A real chair does not arm this set yet")
    versions = page.locator(".map-versions tbody tr")
    expect(versions.first).to_contain_text("Adapted from 1")
    keep("adapt-applied")

    page.get_by_role("button", name="Back to version 1").click()
    expect(versions.first).to_contain_text("Back to 1, from 2")
    expect(versions).to_have_count(3)
    expect(page.get_by_role("button", name="Back to version")).to_have_count(0)
    keep("adapt-back")
