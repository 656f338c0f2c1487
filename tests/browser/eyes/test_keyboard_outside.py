"""By keyboard alone through what is no page of a session: first start, invitation, shared records, screens, docs."""

import re

import pytest
from browser.eyes.axe import look_as
from browser.eyes.by_keyboard import focused, heading, press, tab_to
from browser.eyes.places import PLACES, document, put_back
from browser.eyes.states.session_places import revoke_links, written_session
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]


@pytest.fixture(autouse=True)
def whole_clinic(page, clinic):
    """Give each test the same window, and the same clinic."""
    look_as(page, ("1280x800", "light"))
    yield
    put_back(clinic)


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
    page.context.close()


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
    page.context.close()


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
    page.context.close()
