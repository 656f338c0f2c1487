"""People in real browsers: an owner invites two, both accept in browsers of their own, one is disabled; the lock."""

import re
from datetime import timedelta

import pytest
from browser.served.served_clinic import ServedClinic
from playwright.sync_api import expect

from app.clock import utc_now
from app.settings import Settings
from app.store.access import sign_ins
from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser]

CODE = "the-set-up-code"
PASSWORD = "correct horse battery"
SIZES = {"768x1024": (768, 1024), "1280x800": (1280, 800), "390x844": (390, 844)}
GONE_WITHIN = 5_000  # ms


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    clinic = ServedClinic(Settings(state=tmp_path_factory.mktemp("people"), setup_code=CODE))
    clinic.start()
    yield clinic
    clinic.stop()


@pytest.fixture
def opened(browser, page_log, served):
    """Return what opens a page in a browser of its own; at the end, none of them has reported an error."""
    contexts, logs = [], []

    def open_page(address, size="1280x800"):
        width, height = SIZES[size]
        context = browser.new_context(viewport={"width": width, "height": height})
        log = page_log(served.address)
        page = log.watch(context.new_page())
        page.set_default_timeout(20_000)
        page.goto(address)
        contexts.append(context)
        logs.append(log)
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert [log.outside for log in logs if log.outside] == []
    uncaught = [error for log in logs for error in log.errors if error.startswith("uncaught")]
    assert uncaught == []


@pytest.fixture(scope="module")
def owner_cookies(browser, served):
    """Return the state of a browser in which the owner has set up the clinic, with two patients."""
    context = browser.new_context()
    base = f"{served.address}/api/v1"
    for path, body in (
        ("/auth/setup", {"code": CODE, "name": "Ada", "password": PASSWORD}),
        ("/patients", {"code": "P-71", "pseudonym": "Kingfisher"}),
        ("/patients", {"code": "P-72", "pseudonym": "Otter"}),
    ):
        answer = context.request.post(f"{base}{path}", data=body, headers={"Origin": served.address})
        assert answer.ok, answer.text()
    yield context.storage_state()
    context.close()


def owner_page(opened, served, owner_cookies, size="1280x800"):
    page = opened(served.address, size)
    page.context.add_cookies(owner_cookies["cookies"])
    page.goto(f"{served.address}/#/patients")
    page.reload()
    expect(page.get_by_role("heading", name="Who has come?")).to_be_visible()
    return page


def go_to(page, place):
    page.evaluate(f"location.hash = '#/{place}'")


def photograph(page, name):
    """Keep a screenshot at each size."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    before = page.viewport_size
    for size, (width, height) in SIZES.items():
        page.set_viewport_size({"width": width, "height": height})
        page.wait_for_timeout(250)
        page.screenshot(path=SCREENSHOTS / f"people-{name}-{size}.png")
        assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth"), f"{name} {size} scrolls"
    page.set_viewport_size(before)


def invite(page, name, role, patient=None):
    """Invite somebody on the owner's page; return the link's part behind the address."""
    page.get_by_role("button", name="Invite somebody").click()
    page.get_by_label("Name").fill(name)
    page.get_by_text(role, exact=True).first.click()
    if patient is not None:
        page.get_by_text("Chosen patients", exact=True).click()
        page.get_by_text(patient).click()
        photograph(page, "invite")
    page.get_by_role("button", name="Make the invitation").click()
    expect(page.get_by_role("heading", name=f"The invitation of {name}, shown this once")).to_be_visible()
    link = "#" + page.locator("pre code").inner_text().partition("#")[2]
    if patient is not None:
        photograph(page, "link")
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
    photograph(reviewer, "stopped")
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


def test_two_are_invited_accept_elsewhere_and_one_is_disabled(opened, served, owner_cookies):
    owner = owner_page(opened, served, owner_cookies)
    go_to(owner, "people")
    for_ben, for_rita = invite(owner, "Ben", "Clinician"), invite(owner, "Rita", "Reviewer", "P-72 · Otter")
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
    for name in ("New patient", "Import an archive", "Start session", "Delete P-72"):
        expect(rita.get_by_role("button", name=name)).to_have_count(0)
    assert rita.locator(".stop").bounding_box()["y"] == 0
    rita.get_by_role("link", name="Review").first.click()
    expect(rita.get_by_role("heading", name="No trials yet")).to_be_visible()
    assert rita.get_by_role("link", name="Drive the first one").count() == 0
    go_to(rita, "patients")
    expect(ben.get_by_text("Kingfisher")).to_be_visible()
    expect(rita.get_by_text("Otter")).to_be_visible()
    assert rita.get_by_text("Kingfisher").count() == 0
    only_who_may_go_on_is_offered_it(rita, ben)
    go_to(owner, "patients")
    follows_a_new_patient(owner, ben)
    go_to(owner, "people")
    again = opened(f"{served.address}/{for_ben}", "390x844")
    expect(again.get_by_role("heading", name="This invitation does not work")).to_be_visible()
    owner.reload()
    expect(owner.get_by_text("Reviewer · P-72")).to_be_visible()
    photograph(owner, "list")
    owner.get_by_role("button", name="Disable Ben").click()
    expect(ben.get_by_role("heading", name="Sign in")).to_be_visible(timeout=GONE_WITHIN)
    expect(ben.locator(".toast")).to_have_text("You were signed out: sign in again.")
    assert "Kingfisher" not in ben.evaluate("() => document.documentElement.outerHTML")
    expect(owner.get_by_text("Disabled: cannot sign in.")).to_be_visible()
    expect(rita.get_by_text("Otter")).to_be_visible()
    go_to(owner, "log")
    owner.get_by_label("Person").select_option("Rita")
    expect(owner.locator(".log-table")).to_contain_text("invitation accepted")
    expect(owner.locator(".log-table")).not_to_contain_text("person disabled")
    expect(owner.get_by_text("The log is whole")).to_be_visible()
    photograph(owner, "log")
    go_to(owner, "settings")
    expect(owner.get_by_role("heading", name="Your password")).to_be_visible()
    photograph(owner, "settings")


def test_an_idle_page_locks_with_stop_alive_and_keeps_what_was_typed(opened, served, owner_cookies, monkeypatch):
    page = owner_page(opened, served, owner_cookies, "768x1024")
    page.get_by_role("button", name="New patient").first.click()
    page.get_by_role("textbox", name="Code").fill("P-99")
    later = timedelta(minutes=11)
    monkeypatch.setattr(sign_ins, "utc_now", lambda: utc_now() + later)
    expect(page.get_by_role("heading", name="Locked")).to_be_visible()
    held = page.evaluate("() => document.documentElement.outerHTML")
    assert [word for word in ("Kingfisher", "P-71", "P-99") if word in held] == []
    photograph(page, "lock")
    me = page.context.request.get(f"{served.address}/api/v1/auth/me")
    assert me.json()["locked"] is True
    with page.expect_response("**/api/v1/control/stop") as stopped:
        page.locator("#stop").dispatch_event("pointerdown")
    assert stopped.value.ok
    page.get_by_label("Password of Ada").fill("not this one")
    page.get_by_role("button", name="Unlock").click()
    expect(page.locator(".lock-page .problem").first).to_contain_text("That is not the password of Ada")
    page.get_by_label("Password of Ada").clear()
    paste(page, page.get_by_label("Password of Ada"), PASSWORD)
    page.get_by_role("button", name="Unlock").click()
    expect(page.get_by_role("textbox", name="Code")).to_have_value("P-99")
    expect(page.get_by_text("Kingfisher")).to_be_visible()


def test_after_the_lock_the_page_is_the_one_of_its_address(opened, served, owner_cookies, monkeypatch):
    page = owner_page(opened, served, owner_cookies, "1280x800")
    page.goto(f"{served.address}/#/people")
    expect(page.get_by_role("heading", name="People", level=1)).to_be_visible()
    later = timedelta(minutes=30)  # also after the time to which another test has moved the last action
    monkeypatch.setattr(sign_ins, "utc_now", lambda: utc_now() + later)
    expect(page.get_by_role("heading", name="Locked")).to_be_visible()
    page.evaluate("() => { location.hash = '#/people/invite'; }")  # as Forward of the browser does
    page.get_by_label("Password of Ada").fill(PASSWORD)
    page.get_by_role("button", name="Unlock").click()
    expect(page.get_by_role("textbox", name="Name")).to_be_visible()
