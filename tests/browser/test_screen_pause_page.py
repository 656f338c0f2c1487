"""A screen that is late pauses the virtual chair: nobody has to go on, and the trial says so for ever."""

import re

import pytest
from browser.driving import HIDE, SHOW, choose_task, clock_of, drives_until, go_on_until
from browser.sizes import photograph
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

LEFT_FOR = 1500  # ms
SMALL = "640x800"  # software draws few pixels of a 3D view faster


@pytest.fixture
def page(own_demo, open_page):
    return open_page(own_demo, SMALL, in_3d=True)


def photographed(page, name):
    photograph(page, f"pause-{name}", ("390x844", "768x1024"))


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
    expect(page.locator(".pause-card")).to_contain_text("The chair stands, and the clock is paused")
    expect(page.locator(".bar .speed .big")).to_contain_text("0.00")


def test_a_hidden_page_pauses_the_trial_and_the_third_pause_offers_the_drawn_plan(page):
    choose_task(page, "corridors", "straight")
    page.get_by_role("button", name="Start trial").click()
    drives_until(page, 1)
    offer = page.locator(".plan-offer").get_by_role("button", name="Show the drawn plan")
    for time in range(3):
        if time == 0 and not paused_by_machine(page):
            expect(offer).to_be_hidden()
        is_paused(page)
        if time == 2:
            photographed(page, "card")
        before = clock_of(page)
        page.evaluate(SHOW)
        drives_until(page, before + 1)
    photographed(page, "offer")
    offer.click()
    expect(page.locator(".drawn-plan")).to_be_visible()
    expect(offer).to_be_hidden()
    page.get_by_role("button", name="End trial").first.click()

    note = page.locator(".interruptions")
    expect(note).to_contain_text(re.compile(r"Paused \d+ times for the screen, \d+ s"))
    expect(note).to_contain_text("This trial counts only after you tap")
    photographed(page, "over")
    page.get_by_role("button", name="Count it").click()
    expect(page.get_by_role("button", name="Discard…")).to_be_visible()
    expect(note).not_to_contain_text("only after you tap")
    page.get_by_role("button", name="Undo").click()
    expect(page.get_by_role("button", name="Count it")).to_be_visible()
    for address, words in (("#/review/1", "Paused"), ("#/session", "Paused")):
        page.goto(f"{page.url.split('#')[0]}{address}")
        expect(page.get_by_text(re.compile(f"{words} .* for the screen")).first).to_be_visible()
        photographed(page, address.split("/")[1])
