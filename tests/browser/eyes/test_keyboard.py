"""Each page by keyboard alone: Tab comes to each control; what opens takes the focus, and gives it back."""

import re

import pytest
from browser.eyes.by_keyboard import focused, heading, opens_and_gives_back, press, tab_to
from browser.eyes.opening import go
from browser.eyes.places import PLACES
from browser.served.served_clinic import OWNER
from playwright.sync_api import expect

from app.api.live.live_picture import ClinicLive
from app.news import News
from app.session.calibration import calibration_flow

pytestmark = [pytest.mark.browser]


def test_sign_in(browser, clinic):
    page = browser.new_page()
    page.goto(clinic.address)
    heading(page, "Sign in").to_be_visible()
    tab_to(page, "Name")
    page.keyboard.type(OWNER["name"])
    tab_to(page, "Password")
    page.keyboard.type(OWNER["password"])
    page.keyboard.press("Enter")
    heading(page, "Where to?").to_be_visible()  # somebody is here, and calibrated
    assert focused(page) == "Where to?"


def test_patients(page, clinic):
    go(page, clinic, "patients")
    opens_and_gives_back(page, "New patient", "Code")
    page.keyboard.press("Enter")
    page.keyboard.type("P-9")
    page.keyboard.press("Tab")
    page.keyboard.type("Wren")
    page.keyboard.press("Enter")
    press(page, "End it and start P-9")  # the session of another patient is open
    heading(page, "Rest").to_be_visible()  # in a shirt that nobody wears there is nothing to look at
    clinic.be_here()
    go(page, clinic, "patients")
    press(page, "Delete P-9")
    expect(page.get_by_text("P-9 was deleted")).to_be_visible()
    press(page, "Undo")
    expect(page.get_by_text("P-9")).to_be_visible()
    assert focused(page)


def test_shirt(page, clinic):
    go(page, clinic, "shirt")
    press(page, "Change")
    tab_to(page, "Simulated shirt")
    page.keyboard.press("ArrowUp")
    expect(page.get_by_label("Port")).to_be_visible()
    tab_to(page, "Right shoulder 1")
    page.keyboard.press("ArrowRight")
    heading(page, "Right shoulder 2").to_be_visible()
    assert "Right shoulder 2" in focused(page)


def test_calibrate(page, clinic, monkeypatch):
    monkeypatch.setattr(calibration_flow, "STANDSTILL_LIMIT", 3600.0)  # s: a step does not end by itself meanwhile
    go(page, clinic, "calibrate")
    press(page, "Start")
    tab_to(page, "Stop recording")
    show_news(page, clinic, "Sit upright.")
    assert focused(page) == "Stop recording"
    page.keyboard.press("Enter")
    expect(page.get_by_role("button", name="Stop recording")).to_have_count(0)
    assert focused(page) == "Start"
    tab_to(page, "Go on by itself", key="Shift+Tab")
    show_news(page, clinic, "Sit still.")
    assert focused(page) == "Go on by itself after each step"


def show_news(page, clinic, words):
    """Return when the calibration's page has read again, after news, and shows other words on its first step."""
    view = clinic.good("GET", "/calibration")
    first, *others = view["steps"]
    answer = {**view, "steps": [{**first, "instruction": words}, *others]}
    page.route("**/api/v1/calibration", lambda route: route.fulfill(json=answer))
    clinic.app.state.parts[ClinicLive].notify(News(what="calibration"))
    expect(page.locator("main .lead")).to_contain_text(words)
    page.unroute_all()


def test_controls(page, clinic):
    go(page, clinic, "controls")
    slider = page.get_by_role("slider").first
    tab_to(page, slider.get_attribute("aria-label"))
    before = float(slider.get_attribute("aria-valuenow"))
    page.keyboard.press("ArrowRight")
    assert float(slider.get_attribute("aria-valuenow")) > before
    expect(page.get_by_role("status").filter(has_text="Saved")).to_be_visible()
    press(page, "Undo")
    expect(slider).to_have_attribute("aria-valuenow", str(before))
    assert focused(page)


def test_drive(page, clinic):
    go(page, clinic, "drive")
    press(page, "Start trial")
    expect(page.get_by_role("button", name="End trial").first).to_be_enabled()
    press(page, "Stop the chair now")
    heading(page, "Stop was pressed").to_be_visible()
    page.wait_for_timeout(1100)  # a Continue that comes too soon was meant for something else
    press(page, "Continue")
    heading(page, "Stop was pressed").to_be_hidden()
    press(page, "End trial")
    expect(page).to_have_url(re.compile("drive/over"))


def test_chair(page, clinic):
    PLACES["chair"](page, clinic)
    tab_to(page, "Practise it now")
    press(page, "Stop the chair now")
    expect(page.get_by_text("Stop was pressed on the screen")).to_be_visible()
    page.wait_for_timeout(1100)
    press(page, "Take the stop back")
    expect(page.get_by_text("Stop was pressed on the screen")).to_be_hidden()


def test_adapt(page, clinic):
    go(page, clinic, "adapt")
    page.get_by_role("radio", name="Suggest").wait_for()
    tab_to(page, "Off")
    page.keyboard.press("ArrowDown")
    press(page, "Look now")


def test_review(page, clinic):
    path = clinic.good("GET", "/floorplans/follow_me.easy")["paths"][0]["name"]
    go(page, clinic, f"review/1/follow_me.easy/{path}")
    expect(page.get_by_label("Compare trial 1")).to_be_visible()  # the list comes after the charts
    tab_to(page, "Compare trial 1")
    page.keyboard.press("Space")
    tab_to(page, "Compare trial 2")
    page.keyboard.press("Space")
    press(page, "Compare two trials")
    heading(page, "Two trials side by side").to_be_visible()
    expect(page.get_by_label("Moment of the trial")).to_be_visible()
    tab_to(page, "Moment of the trial")
    before = page.get_by_label("Moment of the trial").input_value()
    page.keyboard.press("ArrowRight")
    assert page.get_by_label("Moment of the trial").input_value() != before


def test_settings(page, clinic):
    go(page, clinic, "settings")
    opens_and_gives_back(page, "Pair a chair", "Name")


def test_people(page, clinic):
    go(page, clinic, "people")
    opens_and_gives_back(page, "Invite somebody", "Name")
    page.keyboard.press("Enter")
    page.keyboard.type("Cleo")
    page.keyboard.press("Tab")
    page.keyboard.press("ArrowDown")
    press(page, "Make the invitation")
    heading(page, "The invitation of Cleo").to_be_visible()
    assert "The invitation of Cleo" in focused(page)
    press(page, "Done")
    assert focused(page) == "Invite somebody"


def test_log(page, clinic):
    go(page, clinic, "log")
    tab_to(page, "Person")
    page.keyboard.type("Ada")
    expect(page.locator(".log-table tbody tr").first).to_contain_text("Ada")


def test_plans(page, clinic):
    go(page, clinic, "plans")
    press(page, "New plan")
    expect(page.locator(".sheet")).to_be_visible()
    press(page, "Wall")
    expect(page.get_by_role("button", name="Wall", exact=True)).to_have_attribute("aria-pressed", "true")


def test_a_taken_name_is_asked_about_and_the_focus_comes_back(page, clinic):
    PLACES["shirt, same name"](page, clinic)
    assert page.evaluate("() => document.activeElement.getAttribute('role')") == "alertdialog"
    page.keyboard.press("Escape")
    expect(page.get_by_role("alertdialog")).to_be_hidden()
    assert focused(page)


def test_the_other_pages(page, clinic):
    PLACES["lock"](page, clinic)
    assert "Password of" in focused(page)
    PLACES["stereo"](page, clinic)
    tab_to(page, "Swap left and right")
    page.keyboard.press("Space")
    PLACES["tablet"](page, clinic)
    press(page, "Android")
    assert focused(page) == "Android"
    PLACES["other session"](page, clinic)
    assert focused(page) == "Another session is open"
    tab_to(page, "Go on with P-2")
