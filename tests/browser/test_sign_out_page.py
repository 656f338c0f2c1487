"""Signing out in a real browser: nothing that names a patient stays on the page, and nothing comes later."""

import pytest
from browser.served.served_clinic import OWNER
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

NAMES = ("A-03", "Bird A-03")
LATER = 1500  # ms


@pytest.fixture
def page(served, open_page):
    """Return the page of the owner, with a patient in the list."""
    served.client.request("POST", f"/patients/{served.patients['A-03']}/restore")  # the test before has deleted them
    token = served.sign_in_as(OWNER["name"])
    page = open_page(f"{served.address}/#/patients", sign_in=token, allowed="Failed to load resource")
    expect(page.get_by_text("Bird A-03")).to_be_visible()
    return page


def everything(page):
    """Return all that the page holds, also what is not shown, and its title and address."""
    return page.evaluate("() => document.documentElement.outerHTML + document.title + location.href")


def assert_names_nobody(page):
    expect(page.get_by_label("Password")).to_be_visible()
    page.wait_for_timeout(LATER)
    assert [name for name in NAMES if name in everything(page)] == []


def test_a_toast_that_names_a_patient_goes_with_the_sign_in(page):
    page.get_by_role("button", name="Delete A-03").click()
    expect(page.locator(".toast")).to_contain_text("A-03")
    page.get_by_role("button", name="Sign out").click()
    assert_names_nobody(page)
    assert page.locator(".toast").count() == 0


def test_header_and_title_that_name_a_patient_go_with_the_sign_in(page, served):
    expect(page.locator("header .me")).to_have_text("Ada")
    page.goto(f"{served.address}/#/review/{served.patients['A-03']}")
    expect(page).to_have_title("A-03, shown · Review · bodydrive")
    expect(page.locator("header .who")).to_have_text("A-03 shown")
    page.get_by_role("button", name="Sign out").click()
    assert_names_nobody(page)
    expect(page).to_have_title("Sign in · bodydrive")


def test_an_answer_that_comes_after_the_sign_out_says_nothing(page):
    late = []
    page.route("**/api/v1/session", lambda route: late.append((route, route.fetch())))
    page.get_by_role("button", name="Delete A-03").click()
    while not late:
        page.wait_for_timeout(50)
    page.get_by_role("button", name="Sign out").click()
    expect(page.get_by_label("Password")).to_be_visible()
    for route, answer in late:
        assert answer.ok
        route.fulfill(response=answer)
    assert_names_nobody(page)


def test_signed_out_elsewhere_the_page_forgets_as_well(page, served):
    page.get_by_role("button", name="Delete A-03").click()
    expect(page.locator(".toast")).to_contain_text("A-03")
    answer = page.context.request.post(f"{served.address}/api/v1/auth/sign-out", headers={"Origin": served.address})
    assert answer.ok, answer.text()
    expect(page.locator(".toast")).to_have_text("You were signed out: sign in again.")
    assert_names_nobody(page)
