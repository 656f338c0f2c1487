"""A halted trial: its end ends its stop, and Continue waits for a patient's screen that the trial uses."""

import pytest
from browser.driving import WITHOUT_WEBGL, choose_task, drives_until, end_trial
from browser.sizes import photograph
from browser.tablets import pairing_link
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

SEEN = 1500  # ms: what is tapped sooner was meant for what stood there before


@pytest.fixture
def pages(demo, open_page):
    """Yield the clinician's page, and what opens the patient's screen, which draws the plan."""
    page = open_page(demo)
    yield page, lambda: open_page(pairing_link(page, demo), script=WITHOUT_WEBGL)
    end_trial(page, demo)


def photographed(page, name):
    photograph(page, f"halted-{name}", ("390x844", "768x1024"))


def stops(page):
    page.locator("#stop").dispatch_event("pointerdown")
    expect(page.locator(".fault-card")).to_contain_text("Stop was pressed on the screen")
    page.wait_for_timeout(SEEN)


def test_the_end_of_a_halted_trial_ends_its_stop_and_the_next_one_starts_with_one_tap(pages):
    page, _ = pages
    choose_task(page, "corridors", "straight")
    page.get_by_role("button", name="Start trial").click()
    drives_until(page, 1)
    stops(page)
    page.get_by_role("button", name="End trial").first.click()
    expect(page.get_by_role("button", name="Next trial")).to_be_visible()
    expect(page.get_by_role("button", name="Take the stop back")).to_be_hidden()
    expect(page.locator(".interruptions")).to_contain_text("Stopped once by a person")
    photographed(page, "over")
    page.get_by_role("button", name="Next trial").click()
    drives_until(page, 1)


def test_continue_waits_for_the_patients_screen_and_the_header_says_where_it_is(pages):
    page, open_patient = pages
    choose_task(page, "corridors", "straight")
    patient = open_patient()
    lamp = page.locator(".head .screen-lamp")
    expect(lamp).to_have_text("Patient’s screen")
    expect(patient.locator(".speed, .view, .drawn-plan").first).to_be_attached()
    page.get_by_role("button", name="Start trial").click()
    drives_until(page, 1)
    stops(page)
    patient.goto("about:blank")
    expect(lamp).to_have_text("Patient’s screen: out of reach")
    page.get_by_role("button", name="Continue").click()
    expect(page.get_by_text("which this trial uses, is out of reach")).to_be_visible()
    expect(page.locator(".fault-card")).to_be_visible()
    photographed(page, "away")
