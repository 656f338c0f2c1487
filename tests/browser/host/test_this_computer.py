"""The page "This computer" in a real browser: measured by its owner, with the pictures a second of two pages."""

import re

import pytest
from browser.eyes.opening import answers
from browser.served.clinic_app import go
from browser.sizes import ARE_KEPT, photograph
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

ALLOWED = "Failed to load resource"  # what the server refuses, the browser reports


@pytest.fixture
def opened(served, open_page):
    """Return what opens a page of the owner's in a browser of its own."""

    def open_owners():
        page = open_page(served.address, "1280x800", sign_in=served.sign_in_as("Ada"), allowed=ALLOWED)
        expect(page.get_by_role("heading", name="Who has come?")).to_be_visible()
        return page

    return open_owners


def photograph_both(page, name):
    """Keep a picture at each size, light and dark; what is touched is large enough, and that is alike in both."""
    for theme in ("light", "dark") if ARE_KEPT else ("light",):
        page.emulate_media(color_scheme=theme)
        photograph(page, f"computer-{name}-{theme}", touched="main")


def test_the_owner_measures_this_computer_and_the_open_screens(opened, served):
    opened()  # another screen of the clinic
    page = opened()
    go(page, "settings")
    page.get_by_role("link", name="Measure this computer").click()
    expect(page.get_by_role("heading", name="This computer", level=1)).to_be_visible()
    photograph_both(page, "before")
    page.get_by_role("button", name="Measure for 10 s").click()
    expect(page.get_by_role("progressbar")).to_be_visible()
    expect(page.get_by_text(re.compile(r"Measuring\. [1-9] s to go"))).to_be_visible()
    expect(page.get_by_role("button", name="Measure for 10 s")).to_be_disabled()
    photograph_both(page, "measuring")
    found = page.locator(".findings")
    expect(found.first.locator(".summary")).to_contain_text("This computer is", timeout=60_000)
    expect(found.first).to_contain_text("Of 1000 ticks of the control loop")
    expect(found.last.locator("li")).to_have_count(2)
    for screen in found.last.locator("li").all():
        assert re.search(r"The page of Ada draws [1-9]\d* pictures a second", screen.inner_text())
    expect(page.get_by_role("progressbar")).to_be_hidden()
    expect(page.get_by_role("button", name="Measure again")).to_be_enabled()
    photograph_both(page, "found")


def test_the_headline_counts_the_screens_that_will_not_do(opened, served):
    page = opened()
    go(page, "computer")
    machine = {"verdict": "good", "message": "This computer is good enough for driving.", "findings": []}
    slow = {"verdict": "bad", "message": "A screen draws 3 pictures a second."}
    fluent = {"verdict": "good", "message": "A screen draws 60 pictures a second."}
    headlines = {}
    for screens in ([fluent], [slow, fluent], [slow, slow]):
        page.unroute_all()
        answers(page, "**/computer/measurement", {"machine": machine, "screens": screens})
        page.get_by_role("button", name=re.compile("Measure")).click()
        expect(page.locator(".findings li")).to_have_count(len(screens))
        headlines[screens.count(slow)] = page.locator(".findings").first.locator(".summary").inner_text()
    assert "This computer is good enough for driving." in headlines[0]
    assert "screen" not in headlines[0]
    assert "This computer is good enough for driving. 1 screen that is open now is not good enough." in headlines[1]
    assert "2 screens that are open now are not good enough." in headlines[2]
