"""Signing out in a real browser: nothing that names a patient stays on the page, and nothing comes later."""

import pytest
from browser.served.served_clinic import ServedClinic
from playwright.sync_api import expect

from app.settings import Settings

pytestmark = [pytest.mark.browser]

CODE = "the-set-up-code"
PASSWORD = "correct horse battery"
NAMES = ("P-71", "Kingfisher", "likes the window")
LATER = 1500  # ms


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    clinic = ServedClinic(Settings(state=tmp_path_factory.mktemp("clinic"), setup_code=CODE))
    clinic.start()
    yield clinic
    clinic.stop()


@pytest.fixture(scope="module")
def owner(browser, page_log, served):
    """Yield a page whose person has set up the clinic, and is signed in."""
    log = page_log(served.address)
    page = log.watch(browser.new_context(viewport={"width": 1024, "height": 768}).new_page())
    page.goto(f"{served.address}/#setup={CODE}")
    page.get_by_label("Name").fill("Ada")
    page.get_by_label("Password").fill(PASSWORD)
    page.get_by_role("button", name="Set up and sign in").click()
    expect(page.get_by_role("heading", name="Who has come?")).to_be_visible()
    code, pseudonym, note = NAMES
    call(page, served, "/patients", {"code": code, "pseudonym": pseudonym, "note": note})
    yield page
    page.context.close()
    assert log.outside == []


def call(page, served, path, body=None):
    headers = {"Origin": served.address}
    answer = page.context.request.post(f"{served.address}/api/v1{path}", data=body, headers=headers)
    assert answer.ok, answer.text()


@pytest.fixture
def page(owner, served):
    """Yield the page with a patient in the list, signed in."""
    if owner.get_by_label("Password").is_visible():
        owner.get_by_label("Name").fill("Ada")
        owner.get_by_label("Password").fill(PASSWORD)
        owner.locator("form .btn.go").click()
    expect(owner.get_by_role("heading", name="Who has come?")).to_be_visible()
    call(owner, served, "/patients/1/restore")  # the test before has deleted them
    owner.reload()
    expect(owner.get_by_text("Kingfisher")).to_be_visible()
    return owner


def everything(page):
    """Return all that the page holds, also what is not shown, and its title and address."""
    return page.evaluate("() => document.documentElement.outerHTML + document.title + location.href")


def assert_names_nobody(page):
    expect(page.get_by_label("Password")).to_be_visible()
    page.wait_for_timeout(LATER)
    assert [name for name in NAMES if name in everything(page)] == []


def test_a_toast_that_names_a_patient_goes_with_the_sign_in(page):
    page.get_by_role("button", name="Delete P-71").click()
    expect(page.locator(".toast")).to_contain_text("P-71")
    page.get_by_role("button", name="Sign out").click()
    assert_names_nobody(page)
    assert page.locator(".toast").count() == 0


def test_header_and_title_that_name_a_patient_go_with_the_sign_in(page, served):
    expect(page.locator("header .me")).to_have_text("Ada")
    page.goto(f"{served.address}/#/review/1")
    expect(page).to_have_title("P-71, shown · Review · bodydrive")
    expect(page.locator("header .who")).to_have_text("P-71 shown")
    page.get_by_role("button", name="Sign out").click()
    assert_names_nobody(page)
    expect(page).to_have_title("Sign in · bodydrive")
    page.goto(f"{served.address}/#/patients")


def test_an_answer_that_comes_after_the_sign_out_says_nothing(page):
    late = []
    page.route("**/api/v1/session", lambda route: late.append((route, route.fetch())))
    page.get_by_role("button", name="Delete P-71").click()
    while not late:
        page.wait_for_timeout(50)
    page.get_by_role("button", name="Sign out").click()
    expect(page.get_by_label("Password")).to_be_visible()
    for route, answer in late:
        assert answer.ok
        route.fulfill(response=answer)
    assert_names_nobody(page)
    page.unroute_all()


def test_signed_out_elsewhere_the_page_forgets_as_well(page, served):
    page.get_by_role("button", name="Delete P-71").click()
    expect(page.locator(".toast")).to_contain_text("P-71")
    call(page, served, "/auth/sign-out")
    expect(page.locator(".toast")).to_have_text("You were signed out: sign in again.")
    assert_names_nobody(page)
