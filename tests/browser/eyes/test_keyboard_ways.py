"""By keyboard alone through pages below the main ones, and through what is no page of a session: first start, docs."""

import re

import pytest
from browser.eyes.by_keyboard import focused, heading, opens_and_gives_back, press, tab_to
from browser.eyes.opening import document, go
from browser.eyes.places import PLACES
from browser.eyes.states.layout_places import own_layout
from browser.eyes.states.session_places import revoke_links, written_session
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]


def test_a_task_is_chosen(page, clinic):
    go(page, clinic, "drive/tasks")
    press(page, "Doors")
    expect(page.get_by_role("button", name="Doors", exact=True)).to_have_attribute("aria-pressed", "true")
    tab_to(page, page.locator("a.choice").first.locator("b").inner_text())
    page.keyboard.press("Enter")
    expect(page).to_have_url(re.compile("#/drive/task/"))


def test_a_sensor_is_chosen_put_elsewhere_and_saved(page, clinic):
    go(page, clinic, f"layouts/edit/{own_layout(clinic)}")
    tab_to(page, "Place of Right shoulder 1")
    mark = page.locator(".place-mark[role=slider]")
    expect(mark).to_have_attribute("aria-valuetext", "Front: right shoulder")
    for _ in range(4):
        page.keyboard.press("Shift+ArrowDown")
    expect(mark).to_have_attribute("aria-valuetext", "Front: right upper arm")
    assert focused(page) == "Place of Right shoulder 1"
    tab_to(page, "Right shoulder 1")
    page.keyboard.press("ArrowDown")
    heading(page, "Right shoulder 2").to_be_visible()
    press(page, "Save")
    expect(page.get_by_text("“Ward 3” was saved.")).to_be_visible()
    assert focused(page) == "Use"


def test_another_chair_is_chosen(page, clinic):
    go(page, clinic, "drive/chairs")
    tab_to(page, "Answers at once")
    page.keyboard.press("ArrowRight")
    tab_to(page, "Back to the task")


@pytest.mark.parametrize("where", ["drive/screen", "settings"])
def test_a_screen_is_paired_and_the_code_is_closed(page, clinic, where):
    go(page, clinic, where)
    opens_and_gives_back(page, "Pair a screen", "Pair a screen", closer="Close")


def test_the_help_is_opened_and_closed(page, clinic):
    go(page, clinic, "controls")
    press(page, "What is this page for?")
    expect(page.get_by_role("dialog")).to_be_visible()
    assert focused(page) == page.locator("#page-help-title").inner_text()
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).to_be_hidden()
    assert focused(page) == "What is this page for?"


def test_the_first_sentences_are_put_away(page, clinic):
    PLACES["first time"](page, clinic)
    press(page, "Got it")
    expect(page.locator(".first-sentences")).to_be_hidden()
    assert focused(page) == page.locator("main h1").inner_text()


def test_a_note_is_revised_or_left_as_it_is(page, clinic):
    go(page, clinic, f"session/{written_session(clinic)}")
    opens_and_gives_back(page, "Revise the note", "Text of the note")
    page.keyboard.press("Enter")
    page.keyboard.type("Rested. ")
    press(page, "Save the revision")
    expect(page.locator(".notes-of-session")).to_contain_text("Rested.")
    assert "Revise the note" in focused(page)


def test_a_scale_is_added_and_removed(page, clinic):
    go(page, clinic, f"session/{written_session(clinic)}")
    tab_to(page, "Scale")
    page.keyboard.type("WST")
    tab_to(page, "Total")
    page.keyboard.type("70")
    press(page, "Add the scale")
    expect(page.get_by_role("row", name="WST")).to_be_visible()
    assert focused(page) == "Scale"
    press(page, "Remove WST", key="Enter")
    expect(page.get_by_role("row", name="WST")).to_be_hidden()
    assert focused(page)


def test_a_session_is_signed_off_and_unlocked(page, clinic):
    go(page, clinic, f"session/{written_session(clinic)}")
    press(page, "Sign off")
    press(page, "Cancel")
    assert focused(page) == "Sign off"
    page.keyboard.press("Enter")
    assert focused(page) == "Yes, sign off"
    page.keyboard.press("Enter")
    heading(page, "Session").to_be_focused()
    opens_and_gives_back(page, "Unlock", "Why it is unlocked")
    page.keyboard.press("Enter")
    page.keyboard.type("The goal is not the patient's.")
    press(page, "Unlock the session")
    heading(page, "Session").to_be_focused()


def test_a_share_link_is_made_and_revoked(page, clinic):
    written_session(clinic)  # with the consent
    go(page, clinic, "session/patient/1")
    tab_to(page, "How long")
    page.keyboard.press("ArrowDown")
    press(page, "Make the link")
    heading(page, "The link and its PIN, shown this once").to_be_focused()
    tab_to(page, "Copy the link")
    press(page, "Done")
    assert focused(page) == "Make the link"
    tab_to(page, "Revoke the link: All sessions", key="Shift+Tab")
    page.keyboard.press("Enter")
    expect(page.get_by_text("The link was revoked")).to_be_visible()
    assert focused(page) == "Share links"


def test_two_sessions_are_compared(page, clinic):
    go(page, clinic, "session/patient/1")
    for number in (1, 2):
        tab_to(page, f"Compare session {number}")
        page.keyboard.press("Space")
    press(page, "Compare the two")
    heading(page, "Two sessions side by side").to_be_focused()


def test_a_deleted_patient_is_not_erased_after_all(page, clinic):
    PLACES["backup, erase"](page, clinic)
    assert focused(page) == "Cancel"
    page.keyboard.press("Enter")
    expect(page.get_by_role("group", name="Erase now")).to_be_hidden()
    assert "Erase now" in focused(page)
    press(page, "Undo the deletion", key="Enter")
    expect(page.get_by_text("is back")).to_be_visible()
    assert focused(page)


def test_the_computer_is_measured(page, clinic):
    PLACES["computer, measured"](page, clinic)
    assert focused(page) == page.locator("main h2").nth(0).inner_text()
    tab_to(page, "Settings")


def test_a_reason_to_look_at_somebody_is_followed(page, clinic):
    PLACES["attention"](page, clinic)
    reason = page.locator(".reasons a").first.inner_text()
    press(page, reason)
    expect(page).to_have_url(re.compile("#/(review|session)/"))
    expect(page.locator("main h1")).to_be_focused()


def test_the_two_minute_test_is_begun_ended_and_asked_about(page, clinic):
    PLACES["interface_test, runs"](page, clinic)
    press(page, "End the test")
    expect(page.get_by_role("button", name="Start the test")).to_be_visible()
    PLACES["interface_test, over"](page, clinic)
    tab_to(page, "Thinking")
    page.keyboard.press("ArrowRight")
    press(page, "Leave out: Thinking")
    assert "Thinking" in focused(page)
    page.keyboard.press("ArrowLeft")
    press(page, "Save the answers")
    expect(page.get_by_text("Saved.").first).to_be_visible()


def test_the_story_of_a_session_leads_to_its_trials_and_record(page, clinic):
    PLACES["session story"](page, clinic)
    press(page, "Record")
    heading(page, "Session").to_be_focused()


def test_the_first_owner_is_asked_for_and_a_wrong_code_is_refused(page, clinic):
    PLACES["set_up"](page, clinic)
    for field, words in (("Set-up code", "no such code"), ("Name", "Ida"), ("Password", "correct horse battery")):
        tab_to(page, field)
        page.keyboard.type(words)
    press(page, "Show what is typed", key="Space")
    expect(page.get_by_label("Password", exact=True)).to_have_attribute("type", "text")
    press(page, "Set up and sign in")
    expect(page.locator(".problem")).not_to_be_empty()


def test_an_invitation_is_accepted(browser, clinic):
    link = clinic.good("POST", "/people", {"name": "Cara", "role": "reviewer", "patients": None})["url"]
    page = browser.new_page()
    page.goto(f"{clinic.address}/#{link.partition('#')[2]}")
    heading(page, "Welcome, Cara").to_be_visible()
    tab_to(page, "Your new password")
    page.keyboard.type("battery horse correct")
    page.keyboard.press("Enter")
    heading(page, "Who to look at").to_be_focused()


def test_shared_records_are_opened_read_and_explained(browser, clinic):
    written_session(clinic)  # with the consent
    revoke_links(clinic)
    made = clinic.good("POST", "/patients/1/shares", {"days": 1})
    page = browser.new_page()
    page.goto(f"{clinic.address}/share.html#{made['url'].partition('#')[2]}")
    tab_to(page, "PIN of this link")
    page.keyboard.type(made["pin"])
    page.keyboard.press("Enter")
    heading(page, "Records of P-1").to_be_focused()
    press(page, "What is this page for?")
    expect(page.get_by_role("dialog")).to_be_visible()
    page.keyboard.press("Escape")
    assert focused(page) == "What is this page for?"


def test_a_page_of_the_docs_leads_to_the_next(page, clinic):
    document("docs/")(page, clinic)
    tab_to(page, "For clinicians")
    page.keyboard.press("Enter")
    expect(page).to_have_url(re.compile("docs/clinicians"))


def test_a_screen_is_paired_by_its_code(browser, clinic):
    code = clinic.good("POST", "/patient-screen/pairing")["code"]
    page = browser.new_page()
    page.goto(f"{clinic.address}/patient.html")
    tab_to(page, "Code from the clinician's page")
    page.keyboard.type(code)
    page.keyboard.press("Enter")
    expect(page.get_by_text("We wait for your clinician")).to_be_visible()
