"""The notices of a stop: the way to the drive while something is halted, what takes it back, and each further stop."""

import re

import pytest
from browser.eyes.opening import go
from browser.eyes.places import PLACES, put_back
from browser.eyes.states.live_places import DRIVE
from playwright.sync_api import expect

from app.api.live.live_picture import ClinicLive
from app.faults import Fault

pytestmark = [pytest.mark.browser]

ONE_PRESS = 500  # ms after which a stop is another one than the first


def test_no_page_without_the_chair_in_view_lets_it_go_on(page, clinic):
    PLACES["drive, stopped"](page, clinic)
    page.evaluate("() => (location.hash = '#/controls')")
    strip = page.locator(".note")
    expect(strip).to_contain_text("Stop was pressed on the screen.")
    expect(strip).not_to_contain_text("tap Continue")
    expect(strip.get_by_role("button")).to_have_count(0)
    strip.get_by_role("link", name="Go to the drive").click()
    expect(page.locator(".fault-card").get_by_role("button", name="Continue")).to_be_visible()
    put_back(clinic)

    clinic.fault(Fault.SHIRT_SILENT)
    clinic.shown["drive"] = {**DRIVE, "waits": 271.0}
    go(page, clinic, "session/patient/2")
    expect(strip.get_by_role("link", name="Go to the drive")).to_have_attribute("href", "#/drive/chair")


def test_without_a_trial_the_stop_is_taken_back_and_nothing_is_continued(page, clinic):
    clinic.fault(Fault.SHIRT_SILENT)
    go(page, clinic, "controls")
    strip = page.locator(".note")
    expect(strip).to_contain_text("Check its battery and cable, and look at the Shirt page. No trial and no drive runs")
    expect(strip).not_to_contain_text("Continue")
    expect(strip.get_by_role("button", name="Take the stop back")).to_be_enabled()


def test_a_trial_that_is_measured_offers_nothing_else(page, clinic):
    PLACES["drive, stopped"](page, clinic)
    picture = clinic.app.state.parts[ClinicLive]._picture
    clinic.shown["trial"] = {**picture().trial.model_dump(), "measuring": True}
    card = page.locator(".over-view")
    expect(card).to_contain_text("Measuring")
    expect(card).to_contain_text("Its result comes here by itself")
    expect(card.get_by_role("button")).to_have_count(0)
    expect(page.get_by_role("button", name="Measuring")).to_be_disabled()
    expect(page.get_by_role("button", name="End trial")).to_have_count(0)


@pytest.mark.parametrize(
    ("place", "notice"),
    [
        ("drive, stopped", ".over-view"),
        ("chair, stopped", ".drive-state"),
        ("patient's screen, stopped", ".band.stopped"),
        ("patients, fault", ".note"),
    ],
)
def test_a_further_stop_is_said_with_its_time_beside_the_first_reason(page, clinic, place, notice):
    PLACES[place](page, clinic)
    notice = page.locator(notice)
    reason = re.compile("Stop was pressed on|The shirt stopped sending")
    expect(notice).to_contain_text(reason)
    expect(notice).not_to_contain_text("again")
    page.wait_for_timeout(ONE_PRESS)
    clinic.fault(Fault.STOP_TABLET)
    expect(notice).to_contain_text(re.compile(r"Stopped again at \d\d:\d\d:\d\d\."))
    expect(notice).to_contain_text(reason)
    clinic.clear()
    expect(notice.filter(has_text=reason)).to_have_count(0)
    clinic.fault(Fault.STOP_TABLET)
    expect(notice).to_contain_text("Stop was pressed on")
    expect(notice).not_to_contain_text("again")


def test_a_further_stop_is_still_said_to_somebody_who_comes_back_to_the_trial(page, clinic):
    PLACES["drive, stopped"](page, clinic)
    page.wait_for_timeout(ONE_PRESS)
    clinic.fault(Fault.STOP_TABLET)
    again = page.locator(".over-view").get_by_text("Stopped again at")
    words = again.inner_text()
    page.evaluate("() => (location.hash = '#/controls')")
    strip = page.locator(".note")
    expect(strip).to_contain_text(words)
    strip.get_by_role("link", name="Go to the drive").click()
    expect(again).to_have_text(words)


def test_what_a_stop_forbids_is_offered_again_once_it_is_taken_back(page, clinic):
    clinic.fault(Fault.SHIRT_SILENT)
    go(page, clinic, "adapt")
    look = page.get_by_role("button", name="Look now")
    expect(page.get_by_text("A stop is still in force")).to_be_visible()
    expect(look).to_be_disabled()
    clinic.clear()
    expect(look).to_be_enabled()
    expect(page.get_by_text("A stop is still in force")).to_have_count(0)
