"""The page "This computer" in a real browser: measured by its owner, with the pictures a second of two pages."""

import re
from functools import partial

import pytest
from browser.served.clinic_app import assert_quiet, go
from playwright.sync_api import expect

from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser]

SIZES = {"768x1024": (768, 1024), "1280x800": (1280, 800), "390x844": (390, 844)}
THEMES = ("light", "dark")
SMALL = """[...document.querySelectorAll("main button, main a")]
  .filter((one) => one.getBoundingClientRect().height < 44).map((one) => one.outerHTML.slice(0, 80))"""


@pytest.fixture
def opened(browser, page_log, served):
    """Return what opens a page of the owner's in a browser of its own."""
    pages, log = [], page_log(served.address)

    def open_page():
        page = log.watch(browser.new_context(viewport={"width": 1280, "height": 800}).new_page())
        page.set_default_timeout(30_000)
        pages.append(page)
        served.sign_in(page)
        expect(page.get_by_role("heading", name="Who has come?")).to_be_visible()
        return page

    yield open_page
    for page in pages:
        page.context.close()
    assert_quiet(log)


def photograph(page, name):
    """Keep a screenshot at each size, light and dark; nothing may be too wide or too small."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    for size, (width, height) in SIZES.items():
        page.set_viewport_size({"width": width, "height": height})
        for theme in THEMES:
            page.emulate_media(color_scheme=theme)
            page.wait_for_timeout(250)
            page.screenshot(path=SCREENSHOTS / f"computer-{name}-{size}-{theme}.png")
        assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth"), f"{name} {size} scrolls"
        assert page.evaluate(f"() => {SMALL}") == []
    page.set_viewport_size({"width": 1280, "height": 800})


def test_the_owner_measures_this_computer_and_the_open_screens(opened, served):
    opened()  # another screen of the clinic
    page = opened()
    go(page, "settings")
    page.get_by_role("link", name="Measure this computer").click()
    expect(page.get_by_role("heading", name="This computer", level=1)).to_be_visible()
    photograph(page, "before")
    page.get_by_role("button", name="Measure for 10 s").click()
    expect(page.get_by_role("progressbar")).to_be_visible()
    expect(page.get_by_text(re.compile(r"Measuring\. [1-9] s to go"))).to_be_visible()
    expect(page.get_by_role("button", name="Measure for 10 s")).to_be_disabled()
    photograph(page, "measuring")
    found = page.locator(".findings")
    expect(found.first.locator(".summary")).to_contain_text("This computer is", timeout=60_000)
    expect(found.first).to_contain_text("Of 1000 ticks of the control loop")
    expect(found.last.locator("li")).to_have_count(2)
    for screen in found.last.locator("li").all():
        assert re.search(r"The page of Ada draws [1-9]\d* pictures a second", screen.inner_text())
    expect(page.get_by_role("progressbar")).to_be_hidden()
    expect(page.get_by_role("button", name="Measure again")).to_be_enabled()
    photograph(page, "found")


def fulfil(found, route):
    """Answer a request with what was found."""
    route.fulfill(json=found)


def test_the_headline_counts_the_screens_that_will_not_do(opened, served):
    page = opened()
    go(page, "computer")
    machine = {"verdict": "good", "message": "This computer is good enough for driving.", "findings": []}
    slow = {"verdict": "bad", "message": "A screen draws 3 pictures a second."}
    fluent = {"verdict": "good", "message": "A screen draws 60 pictures a second."}
    headlines = {}
    for screens in ([fluent], [slow, fluent], [slow, slow]):
        page.unroute_all()
        found = {"machine": machine, "screens": screens}
        page.route("**/computer/measurement", partial(fulfil, found))
        page.get_by_role("button", name=re.compile("Measure")).click()
        expect(page.locator(".findings li")).to_have_count(len(screens))
        headlines[screens.count(slow)] = page.locator(".findings").first.locator(".summary").inner_text()
    assert "This computer is good enough for driving." in headlines[0]
    assert "screen" not in headlines[0]
    assert "This computer is good enough for driving. 1 screen that is open now is not good enough." in headlines[1]
    assert "2 screens that are open now are not good enough." in headlines[2]
