"""What a screen reader says of a drive, on all pages: each state once and politely, Stop at once, and no figure."""

import re

import pytest
from browser.eyes.places import PLACES, put_back
from browser.eyes.spoken import LISTEN, QUIET, is_said, said, said_after, with_words
from browser.eyes.states.live_places import DRIVE, TRIAL
from browser.script import script
from browser.sizes import window
from playwright.sync_api import expect

from app.faults import Fault, State

pytestmark = [pytest.mark.browser]

A_WHILE = 1000  # ms in which nothing is said
LOOKS = 6  # of that time, until a page is silent; figures that change are said in each of them
# The role of the notice of a page that has lost the program, without a cover over the page and with one.
LOST_ROLES = script("lost_roles")
# A card over the picture, outside every page: `show(why)` gives it one and the same fault, and a picture or none.
CARD = script("fault_card")


def test_each_state_of_a_drive_is_said_once(page, clinic):
    PLACES["drive, runs"](page, clinic)
    page.evaluate(LISTEN)
    page.wait_for_timeout(A_WHILE)
    assert said(page) == []  # nothing has happened, though figures change twenty times a second

    process = clinic.process
    is_said(page, lambda: setattr(process, "state", State.CHECKING), "Rest")

    go, picture = page.locator(".cue-card.go"), page.locator(".picture")
    said(page)
    process.state = State.ARMED
    expect(go).to_be_visible()
    card, whole = go.bounding_box(), picture.bounding_box()
    assert card["y"] + card["height"] < whole["y"] + 0.2 * whole["height"]  # the middle of the path stays free
    expect(go).to_be_hidden()  # it goes by itself, and nothing is said of that
    page.wait_for_timeout(QUIET)
    rows = said(page)
    assert len(rows) == 1, rows
    assert rows[0][0] == "polite"

    is_said(page, lambda: clinic.fault(Fault.SHIRT_SILENT), "The shirt stopped sending")

    said_after(page, clinic.clear, "Go")
    for _ in range(2):  # each press is said, also the second one
        expect(go).to_be_hidden()
        page.locator("#stop").focus()
        rows = is_said(page, lambda: page.keyboard.press("Enter"), "Stop was pressed", "assertive")
        expect(page.get_by_role("heading", name="Stop was pressed")).to_be_visible()
        assert {live for live, _ in rows} == {"assertive"}, rows
        said_after(page, clinic.clear, "Go")


def test_a_picture_that_goes_and_comes_does_not_say_the_fault_again(page, clinic):
    PLACES["settings"](page, clinic)
    page.evaluate(CARD)
    page.evaluate(LISTEN)
    page.evaluate("() => showFault('')")
    page.wait_for_timeout(0)  # until the observer has run
    assert with_words(said(page), "The shirt is silent.") == ["polite"]
    for why, words in (("stale", "older than a second"), ("context", "switched off the graphics"), ("", "")):
        assert words in page.evaluate("(why) => showFault(why)", why)
        rows = said(page)
        assert not words or with_words(rows, words) == ["polite"], rows
        assert with_words(rows, "The shirt is silent.") == [], rows
    page.evaluate("() => removeCard()")


def test_continue_and_end_keep_their_places_when_the_picture_goes_and_comes(browser, clinic):
    # A page of its own: in one whose clock was put forward, every page that is opened later draws all that time again.
    page = browser.new_page(storage_state=clinic.storage(), viewport=window("1280x800"))
    PLACES["settings"](page, clinic)
    page.clock.install()
    page.clock.pause_at(page.evaluate("() => Date.now()") / 1000 + 120)  # it goes on at the test's words only
    page.evaluate(CARD)
    page.evaluate("() => showFault('')")
    go, end, plan = (
        page.locator(".fault-card").get_by_role("button", name=name)
        for name in ("Continue", "End trial", "Show the drawn plan")
    )
    boxes = [go.bounding_box(), end.bounding_box()]
    expect(go).to_be_disabled()  # a tap in its first second was meant for what stood there before
    page.clock.run_for(1000)
    expect(go).to_be_enabled()
    page.evaluate("() => showFault('stale')")
    expect(go).to_be_disabled()
    expect(go).to_have_accessible_description(re.compile("needs a picture.*older than a second"))
    assert [go.bounding_box(), end.bounding_box()] == boxes
    assert plan.bounding_box()["y"] > boxes[0]["y"] + boxes[0]["height"]
    page.clock.run_for(5000)
    expect(go).to_be_disabled()
    plan.focus()
    page.evaluate("() => showFault('')")
    expect(go).to_be_focused()
    page.clock.run_for(900)
    expect(go).to_be_disabled()
    page.clock.run_for(100)
    expect(go).to_be_enabled()
    assert [go.bounding_box(), end.bounding_box()] == boxes


def test_a_lost_page_has_one_main_landmark_also_under_a_cover(page, clinic):
    PLACES["settings"](page, clinic)
    assert page.evaluate(LOST_ROLES) == ["main", None]


def test_no_page_says_figures_that_change(page, clinic):
    spoken = {}
    for name in ("patients", "shirt, lamp", "controls", "drive", "chair", "settings"):
        PLACES[name](page, clinic)
        page.evaluate(LISTEN)
        for _ in range(LOOKS):  # what a page says once, as it opens, may come late
            page.wait_for_timeout(A_WHILE)
            spoken[name] = said(page)
            if not spoken[name]:
                del spoken[name]
                break
        put_back(clinic)
    assert spoken == {}


def go_on(clinic):
    """Take a stop back while a trial or drive is under way."""
    clinic.clear()
    clinic.process.state = State.ARMED


def test_each_state_of_a_real_chair_is_said_once(page, clinic):
    PLACES["chair, checking"](page, clinic)
    page.evaluate(LISTEN)
    assert said_after(page, lambda: None) == []  # nothing has happened, though figures change twenty times a second
    process = clinic.process
    is_said(page, lambda: setattr(process, "state", State.ARMED), "Driving")
    is_said(page, lambda: clinic.fault(Fault.CHAIR_SILENT), "The chair no longer answers")
    clinic.shown["drive"] = {**DRIVE, "waits": 200.0}
    assert said_after(page, lambda: None) == []  # the time that is left is for the eye
    said_after(page, lambda: go_on(clinic))
    rows = is_said(page, lambda: clinic.fault(Fault.STOP_TABLET), "Stop was pressed", "assertive")
    assert {live for live, _ in rows} == {"assertive"}, rows


def test_each_state_is_said_once_on_the_patients_screen(page, clinic):
    PLACES["patient's screen"](page, clinic)
    clinic.shown_to_patient |= {"trial": TRIAL, "drives": True}
    page.evaluate(LISTEN)
    said_after(page, lambda: None)
    process = clinic.process
    is_said(page, lambda: setattr(process, "state", State.CHECKING), "Rest")
    is_said(page, lambda: setattr(process, "state", State.ARMED), "Go")
    assert said_after(page, lambda: None) == []
    is_said(page, lambda: clinic.fault(Fault.SHIRT_SILENT), "The shirt sent nothing any more.")
    said_after(page, lambda: go_on(clinic))
    expect(page.locator(".band.stopped")).to_have_count(0)
    for _ in range(2):  # each press is said, also the second one
        rows = is_said(page, lambda: clinic.fault(Fault.STOP_TABLET), "Stop was pressed", "assertive")
        assert len(rows) == 1, rows
        said_after(page, lambda: go_on(clinic))
    over = {"over": {"id": 7, "end": "goal"}, "trial": None, "drives": False}
    is_said(page, lambda: clinic.shown_to_patient.update(over), "Goal")
