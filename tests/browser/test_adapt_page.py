"""A map that loses something, on a tablet: suggested after trials, looked at, applied, taken back."""

import re

import pytest
from browser.driving import drives_until, ends_by_hand
from browser.sizes import fits
from browser.tablets import go_to, signed_in
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.long]

LONG_ENOUGH = 40  # s of a trial: a joint has moved for some seconds by then
TITLE = "What would change, and why"


@pytest.fixture(params=["768x1024", "1280x800"])
def tablet(request, browser, page_log, own_demo):
    """Yield a page of one tablet, signed in, and a function that keeps a screenshot."""
    with signed_in(request.param, browser, page_log, own_demo) as page_and_keep:
        yield page_and_keep


def drive_for_a_while(page):
    go_to(page, "drive")
    page.get_by_role("button", name="Start trial").click()
    drives_until(page, LONG_ENOUGH, within=150)
    ends_by_hand(page)


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
    expect(page.get_by_text("Felt change", exact=True)).to_be_visible()
    expect(page.locator(".adapt-joint").first).to_contain_text("of the time of its movements does not count")
    expect(page.locator(".adapt-head")).to_contain_text("A real chair can be armed only with a set that was practised")
    fits(page, "main .btn, main .choice")
    keep("adapt-suggested")

    apply = page.get_by_role("button", name="Apply")
    take_back_a_stop(page, apply)
    apply.click()
    expect(page.locator(".adapt-head")).to_contain_text("Version 2 of the calibration is in use.")
    expect(page.locator(".adapt-head")).to_contain_text("A real chair cannot be armed with this set yet")
    versions = page.locator(".map-versions tbody tr")
    expect(versions.first).to_contain_text("Adapted from 1")
    keep("adapt-applied")

    page.get_by_role("button", name="Back to version 1").click()
    expect(versions.first).to_contain_text("Back to 1, from 2")
    expect(versions).to_have_count(3)
    expect(page.get_by_role("button", name="Back to version")).to_have_count(0)
    keep("adapt-back")
