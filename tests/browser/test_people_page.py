"""People in real browsers: an owner invites two, both accept in browsers of their own, one is disabled; the lock."""

import re
from datetime import timedelta
from functools import partial

import pytest
from browser.served.clinic_app import go
from browser.served.served_clinic import OWNER
from browser.sizes import photograph
from playwright.sync_api import expect

from app.api.live.live_picture import ClinicLive
from app.clock import utc_now
from app.news import News
from app.store.access import sign_ins

pytestmark = [pytest.mark.browser]

GONE_WITHIN = 5_000  # ms


@pytest.fixture
def opened(served, open_page):
    """Return what opens a page in a browser of its own."""
    return partial(open_page, allowed="Failed to load resource")


def owner_page(opened, served, size="1280x800"):
    page = opened(f"{served.address}/#/patients", size, sign_in=served.sign_in_as("Ada"))
    expect(page.get_by_role("heading", name="Who has come?")).to_be_visible()
    return page


def invite(page, name, role, patient=None):
    """Invite somebody on the owner's page; return the link's part behind the address."""
    page.get_by_role("button", name="Invite somebody").click()
    page.get_by_label("Name").fill(name)
    page.get_by_text(role, exact=True).first.click()
    if patient is not None:
        page.get_by_text("Chosen patients", exact=True).click()
        page.get_by_text(patient).click()
        photograph(page, "people-invite")
    page.get_by_role("button", name="Make the invitation").click()
    expect(page.get_by_role("heading", name=f"The invitation of {name}, shown this once")).to_be_visible()
    link = "#" + page.locator("pre code").inner_text().partition("#")[2]
    if patient is not None:
        photograph(page, "people-link")
    page.get_by_role("button", name="Done", exact=True).click()
    return link


def paste(page, field, words):
    """Paste words from the clipboard, as a keeper of passwords does."""
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.evaluate("(words) => navigator.clipboard.writeText(words)", words)
    field.press("Control+v")
    expect(field).to_have_value(words)


def accept(page, name, first_page="Who has come?"):
    expect(page.get_by_role("heading", name=f"Welcome, {name}")).to_be_visible()
    paste(page, page.get_by_label("Your new password"), f"{name}'s long password")
    page.get_by_role("button", name="Save and sign in").click()
    expect(page.get_by_role("heading", name=first_page)).to_be_visible()


def numbers(page):
    """Return the numbers of the first sentences that stand on the rail."""
    return page.locator(".rail a[data-first]:visible").evaluate_all("(all) => all.map((one) => one.dataset.first)")


def only_who_may_go_on_is_offered_it(reviewer, clinician):
    """Stop as a reviewer, and go on as a clinician."""
    reviewer.locator("#stop").click()
    expect(reviewer.get_by_text("The clinician beside the chair looks around")).to_be_visible()
    expect(reviewer.get_by_role("button", name="Take the stop back")).to_have_count(0)
    photograph(reviewer, "people-stopped")
    clinician.get_by_role("button", name="Take the stop back").click()
    expect(reviewer.get_by_text("The clinician beside the chair looks around")).to_have_count(0)


def follows_a_new_patient(looks_on, clinician):
    """Add a patient, whom somebody who looks at the list sees at once."""
    row = looks_on.get_by_role("listitem").filter(has_text="P-73")
    expect(row).to_have_count(0)
    clinician.get_by_role("button", name="New patient").click()
    clinician.get_by_role("textbox", name="Code", exact=True).fill("P-73")
    clinician.get_by_label("Pseudonym", exact=True).fill("Heron")
    clinician.get_by_role("button", name="Add and start the session").click()
    expect(row).to_contain_text("session open")


def test_two_are_invited_accept_elsewhere_and_one_is_disabled(opened, served):
    owner = owner_page(opened, served)
    go(owner, "people")
    for_ben, for_rita = invite(owner, "Ben", "Clinician"), invite(owner, "Rita", "Reviewer", "B-12 · Bird B-12")
    ben, rita = opened(f"{served.address}/{for_ben}", "768x1024"), opened(f"{served.address}/{for_rita}", "390x844")
    expect(ben.get_by_role("heading", name="Welcome, Ben")).to_be_visible()
    assert "invite" not in ben.evaluate("() => location.href")
    expect(rita.get_by_role("heading", name="Welcome, Rita")).to_be_visible()
    photograph(rita, "invitation")
    accept(ben, "Ben")
    accept(rita, "Rita", "Who to look at")
    expect(owner.get_by_text("has not chosen a password yet")).to_have_count(0, timeout=15_000)  # without a reload
    first = rita.get_by_role("region", name="Three things, the first time")
    expect(first.get_by_role("listitem")).to_have_text(
        [re.compile(f"^{word}") for word in ("STOP", "Patients:", "Review:")]
    )
    assert numbers(rita) == ["2", "3"]
    # A reviewer is offered nothing that is refused, and Stop stays in the first row of a telephone.
    for name in ("New patient", "Import an archive", "Start session", "Delete B-12"):
        expect(rita.get_by_role("button", name=name)).to_have_count(0)
    assert rita.locator(".stop").bounding_box()["y"] == 0
    rita.get_by_role("link", name="Review").first.click()
    expect(rita.get_by_role("heading", name="No trials yet")).to_be_visible()
    assert rita.get_by_role("link", name="Drive the first one").count() == 0
    go(rita, "patients")
    expect(ben.get_by_text("Bird A-03")).to_be_visible()
    expect(rita.get_by_text("Bird B-12")).to_be_visible()
    assert rita.get_by_text("Bird A-03").count() == 0
    only_who_may_go_on_is_offered_it(rita, ben)
    go(owner, "patients")
    follows_a_new_patient(owner, ben)
    go(owner, "people")
    again = opened(f"{served.address}/{for_ben}", "390x844")
    expect(again.get_by_role("heading", name="This invitation does not work")).to_be_visible()
    owner.reload()
    expect(owner.get_by_text("Reviewer · B-12")).to_be_visible()
    photograph(owner, "people-list")
    owner.get_by_role("button", name="Disable Ben").click()
    expect(ben.get_by_role("heading", name="Sign in")).to_be_visible(timeout=GONE_WITHIN)
    expect(ben.locator(".toast")).to_have_text("You were signed out: sign in again.")
    assert "Bird A-03" not in ben.evaluate("() => document.documentElement.outerHTML")
    expect(owner.get_by_text("Disabled: cannot sign in.")).to_be_visible()
    expect(rita.get_by_text("Bird B-12")).to_be_visible()
    go(owner, "log")
    owner.get_by_label("Person").select_option("Rita")
    expect(owner.locator(".log-table")).to_contain_text("invitation accepted")
    expect(owner.locator(".log-table")).not_to_contain_text("person disabled")
    expect(owner.get_by_text("The log is whole")).to_be_visible()
    photograph(owner, "people-log")
    go(owner, "settings")
    expect(owner.get_by_role("heading", name="Your password")).to_be_visible()
    photograph(owner, "people-settings")


def test_an_idle_page_locks_with_stop_alive_and_keeps_what_was_typed(opened, served, monkeypatch):
    page = owner_page(opened, served, "768x1024")
    page.get_by_role("button", name="New patient").first.click()
    page.get_by_role("textbox", name="Code").fill("P-99")
    later = timedelta(minutes=11)
    monkeypatch.setattr(sign_ins, "utc_now", lambda: utc_now() + later)
    expect(page.get_by_role("heading", name="Locked")).to_be_visible()
    held = page.evaluate("() => document.documentElement.outerHTML")
    assert [word for word in ("Bird A-03", "A-03", "P-99") if word in held] == []
    photograph(page, "people-lock")
    me = page.context.request.get(f"{served.address}/api/v1/auth/me")
    assert me.json()["locked"] is True
    with page.expect_response("**/api/v1/control/stop") as stopped:
        page.locator("#stop").dispatch_event("pointerdown")
    assert stopped.value.ok
    page.get_by_label("Password of Ada").fill("not this one")
    page.get_by_role("button", name="Unlock").click()
    expect(page.locator(".lock-page .problem").first).to_contain_text("That is not the password of Ada")
    page.get_by_label("Password of Ada").clear()
    paste(page, page.get_by_label("Password of Ada"), OWNER["password"])
    page.get_by_role("button", name="Unlock").click()
    expect(page.get_by_role("textbox", name="Code")).to_have_value("P-99")
    expect(page.get_by_text("Bird A-03")).to_be_visible()


def test_after_the_lock_the_page_is_the_one_of_its_address(opened, served, monkeypatch):
    page = owner_page(opened, served, "1280x800")
    page.goto(f"{served.address}/#/people")
    expect(page.get_by_role("heading", name="People", level=1)).to_be_visible()
    later = timedelta(minutes=30)  # also after the time to which another test has moved the last action
    monkeypatch.setattr(sign_ins, "utc_now", lambda: utc_now() + later)
    expect(page.get_by_role("heading", name="Locked")).to_be_visible()
    page.evaluate("() => { location.hash = '#/people/invite'; }")  # as Forward of the browser does
    page.get_by_label("Password of Ada").fill(OWNER["password"])
    page.get_by_role("button", name="Unlock").click()
    expect(page.get_by_role("textbox", name="Name")).to_be_visible()


def test_focus_and_what_was_entered_stay_when_the_list_is_read_again(opened, served):
    page = owner_page(opened, served)
    go(page, "people")
    page.get_by_role("button", name="Invite somebody").click()
    name = page.get_by_label("Name")
    expect(name).to_be_focused()
    name.fill("Olga")
    page.get_by_text("Reviewer", exact=True).first.click()
    page.get_by_text("Chosen patients", exact=True).click()
    page.get_by_label("A-03 · Bird A-03").check()
    name.focus()
    served.good("POST", "/people", {"name": "Nora", "role": "clinician", "patients": None})
    expect(page.get_by_role("listitem").filter(has_text="Nora")).to_be_visible(timeout=15_000)
    expect(name).to_be_focused()
    expect(name).to_have_value("Olga")
    expect(page.get_by_label("A-03 · Bird A-03")).to_be_checked()
    page.get_by_role("button", name="Cancel").click()
    expect(page.get_by_role("button", name="Invite somebody")).to_be_visible()


def test_focus_an_open_part_and_what_was_typed_stay_when_news_come(opened, served):
    served.open_session("B-12")
    page = owner_page(opened, served)
    report = page.get_by_role("listitem").filter(has_text="B-12").locator("details")
    report.locator("summary").click()
    report.get_by_label("Paper").select_option("letter")
    page.get_by_role("button", name="New patient").click()
    code = page.get_by_role("textbox", name="Code", exact=True)
    expect(code).to_be_focused()
    code.fill("P-98")
    served.good("POST", "/patients", {"code": "P-74", "pseudonym": "Swift", "note": ""})
    served.app.state.parts[ClinicLive].notify(News(what="session"))
    expect(page.get_by_role("listitem").filter(has_text="P-74")).to_be_visible()
    expect(code).to_be_focused()
    expect(code).to_have_value("P-98")
    expect(report.get_by_label("Paper")).to_have_value("letter")
    expect(report).to_have_attribute("open", "")
