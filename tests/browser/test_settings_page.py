"""The page "Settings" in a real browser: what is open and typed stays while another screen pairs a chair."""

import pytest
from browser.served.clinic_app import go
from browser.sizes import window
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]


@pytest.fixture
def page(browser, page_log, served):
    log = page_log(served.address)
    yield served.sign_in(log.watch(browser.new_page(viewport=window("1024x768"))), "A-03")
    log.assert_quiet()


def pair(served, name):
    """Pair a chair of this name on another screen, and return its id."""
    served.good("POST", "/chairs", {"name": name, "host": "127.0.0.1", "port": 5354, "speeds": {}})
    return next(chair["id"] for chair in served.good("GET", "/chairs")["chairs"] if chair["name"] == name)


def test_what_is_open_and_typed_stays_when_another_screen_pairs_a_chair(page, served):
    go(page, "settings")
    chairs = page.locator(".paired-chair")
    page.get_by_role("button", name="Pair a chair").click()
    form = page.locator(".pair-form")
    name = form.get_by_label("Name")
    expect(name).to_be_focused()
    form.locator("summary").click()
    name.fill("Ward 3")
    field = name.element_handle()
    first = pair(served, "Ward 4")
    expect(chairs).to_have_count(1)
    expect(name).to_be_focused()
    expect(name).to_have_value("Ward 3")
    expect(form.locator("details")).to_have_js_property("open", True)
    assert field.evaluate("(input) => input.isConnected")
    page.get_by_role("button", name="Unpair Ward 4").click()
    question = page.get_by_role("group", name="Unpair Ward 4")
    cancel = question.get_by_role("button", name="Cancel")
    expect(cancel).to_be_focused()
    second = pair(served, "Ward 5")
    expect(chairs).to_have_count(2)
    expect(cancel).to_be_focused()
    cancel.click()
    expect(question).to_have_count(0)
    expect(name).to_have_value("Ward 3")
    for chair in (first, second):
        served.good("DELETE", f"/chairs/{chair}")
    expect(page.get_by_text("No chair is paired")).to_be_visible()
