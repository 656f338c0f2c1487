"""A screen that is late pauses the virtual chair: nobody has to go on, and the trial says so for ever."""

import re

import pytest
from browser.driving import HIDE, SHOW, choose_task, go_on_until
from playwright.sync_api import expect
from processes.served_demo import running_demo

from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser]

LEFT_FOR = 1500  # ms
SMALL = {"width": 640, "height": 800}  # software draws few pixels of a 3D view faster
OUTSIDE = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


@pytest.fixture
def page(browser, page_log):
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    with running_demo() as link:
        log = page_log(link)
        context = browser.new_context(in_3d=True, viewport=SMALL)
        page = log.watch(context.new_page())
        page.goto(link)
        yield page
        log.assert_clean()
        context.close()


def keep(page, name):
    """Photograph the page on a tablet and on a telephone; nothing may lie outside of it."""
    for width, height in ((390, 844), (768, 1024)):
        page.set_viewport_size({"width": width, "height": height})
        page.wait_for_timeout(200)
        assert page.evaluate(OUTSIDE) <= 0
        page.screenshot(path=SCREENSHOTS / f"pause-{name}-{width}.png")
    page.set_viewport_size(SMALL)


def clock_of(page):
    minutes, seconds = page.locator(".place .big").inner_text().split(":")
    return 60 * int(minutes) + int(seconds)


def paused_by_machine(page):
    """Return whether a machine that draws too slowly has paused the trial by itself."""
    answer = page.context.request.get(f"{page.url.split('#')[0]}api/v1/log")
    return any(entry["what"] == "pause" for entry in answer.json()["entries"])


def is_paused(page):
    """Hide the page until the trial is paused, and show it again: it goes on by itself."""
    go_on_until(page, page.get_by_role("heading", name="Paused").is_hidden, "the end of a pause")
    paused = page.get_by_role("heading", name="Paused")
    page.evaluate(HIDE)
    expect(paused).to_be_visible()
    expect(page.get_by_role("button", name="Continue")).to_be_hidden()
    before = clock_of(page)
    page.wait_for_timeout(LEFT_FOR)
    assert clock_of(page) == before
    expect(page.locator(".pause-card")).to_contain_text("The chair and the clock stand")
    expect(page.locator(".bar .speed .big")).to_contain_text("0.00")


def test_a_hidden_page_pauses_the_trial_and_the_third_pause_offers_the_drawn_plan(page):
    choose_task(page, "corridors", "straight")
    page.get_by_role("button", name="Start trial").click()
    go_on_until(page, lambda: clock_of(page) >= 1, "the trial's clock")
    offer = page.locator(".plan-offer").get_by_role("button", name="Show the drawn plan")
    for time in range(3):
        if time == 0 and not paused_by_machine(page):
            expect(offer).to_be_hidden()
        is_paused(page)
        if time == 2:
            keep(page, "card")
        before = clock_of(page)
        page.evaluate(SHOW)
        go_on_until(page, lambda least=before + 1: clock_of(page) >= least, "the clock after a pause")
    keep(page, "offer")
    offer.click()
    expect(page.locator(".drawn-plan")).to_be_visible()
    expect(offer).to_be_hidden()
    page.get_by_role("button", name="End trial").first.click()

    note = page.locator(".interruptions")
    expect(note).to_contain_text(re.compile(r"Paused \d+ times for the screen, \d+ s"))
    expect(note).to_contain_text("This trial counts when you say so.")
    keep(page, "over")
    page.get_by_role("button", name="Count it").click()
    expect(page.get_by_role("button", name="Discard…")).to_be_visible()
    expect(note).not_to_contain_text("when you say so")
    page.get_by_role("button", name="Undo").click()
    expect(page.get_by_role("button", name="Count it")).to_be_visible()
    for address, words in (("#/review/1", "Paused"), ("#/session", "Paused")):
        page.goto(f"{page.url.split('#')[0]}{address}")
        expect(page.get_by_text(re.compile(f"{words} .* for the screen")).first).to_be_visible()
        keep(page, address.split("/")[1])
