"""What waits, or cannot be changed or started now, says so where one looks, and leads to what has to be done first."""

import json
import re
from typing import Any

import pytest
from browser.served.clinic_app import go
from browser.sizes import window
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

REFUSED = "Another screen is changing the controls: try again."
TRIAL: dict[str, Any] = {"id": 1, "number": 1, "waits": None, "done": 0.0, "length": 1.0, "movers": []}


def refuse(route):
    if route.request.method == "PUT":
        route.fulfill(status=409, json={"detail": REFUSED})
    else:
        route.continue_()


@pytest.fixture(scope="module")
def one_page(browser, page_log, served):
    """One page for all tests, whose trial is what its attribute `trial` says."""
    log = page_log(served.address)
    page = log.watch(browser.new_page(viewport=window("1024x768")))
    page.trial = None

    def with_trial(words):
        message = json.loads(words)
        return json.dumps({**message, "trial": page.trial}) if "trial" in message else words

    def pass_on(socket):
        server = socket.connect_to_server()
        server.on_message(lambda words: socket.send(with_trial(words)))

    page.route_web_socket(re.compile("/api/v1/live$"), pass_on)
    yield page
    log.assert_quiet()
    page.context.close()


@pytest.fixture
def page(one_page, served):
    """Yield the page, on which the owner has just signed in."""
    yield served.sign_in(one_page, "A-03")
    one_page.set_viewport_size(window("1024x768"))
    one_page.unroute_all()


def test_a_refused_change_says_so_in_view_and_a_trial_disables_the_page(page):
    go(page, "controls")
    slower = page.get_by_role("button", name="Turn speed −")
    slower.scroll_into_view_if_needed()
    page.route("**/api/v1/controls", refuse)
    slower.click()
    reason = page.get_by_role("alert").filter(has_text=REFUSED)
    expect(reason).to_be_in_viewport(ratio=1)
    page.unroute("**/api/v1/controls")
    slower.click()
    expect(page.get_by_role("status").filter(has_text=re.compile("^saved$"))).to_be_in_viewport(ratio=1)
    expect(reason).to_have_count(0)
    page.trial = TRIAL
    line = page.locator(".foot .busy")
    expect(line).to_contain_text("A trial is running")
    expect(line).to_be_in_viewport(ratio=1)
    expect(line.get_by_role("link", name="Go to the drive")).to_have_attribute("href", "#/drive")
    expect(page.locator(".controls-more")).to_have_js_property("inert", True)
    expect(page.get_by_role("button", name="Suggest for me")).to_be_disabled()
    page.trial = None
    expect(line).to_be_hidden()
    expect(page.locator(".controls-more")).to_have_js_property("inert", False)


def test_a_suggestion_replaces_what_is_set_only_after_a_question(page):
    go(page, "controls")
    sent = []
    page.on("request", lambda request: sent.append(request.url) if request.url.endswith("/suggest") else None)
    suggest = page.get_by_role("button", name="Suggest for me")
    question = page.get_by_role("alertdialog", name="The suggestion replaces")
    suggest.click()
    question.get_by_role("button", name="Cancel").click()
    expect(suggest).to_be_focused()
    assert sent == []
    suggest.click()
    question.get_by_role("button", name="Replace them").click()
    expect(page.locator(".suggestion")).to_be_visible()
    expect(page.get_by_role("button", name="Undo")).to_be_enabled()
    assert len(sent) == 1


def test_without_a_shirt_the_way_to_one_is_in_view_and_the_page_keeps_its_place(page):
    go(page, "drive")
    page.get_by_role("link", name="Choose a shirt").click()
    page.set_viewport_size({"width": 1024, "height": 500})
    page.get_by_role("radio", name="Simulated shirt").check(force=True)
    use = page.get_by_role("button", name="Use this")
    expect(use).to_be_in_viewport(ratio=1)
    side = "Math.round(document.querySelector('[data-card=source]').getBoundingClientRect().left)"
    before = page.evaluate(side)  # in one step: a card that was looked up before may be drawn anew meanwhile
    use.click()
    card = page.locator("[data-card=source]")
    expect(card).to_contain_text("Simulated shirt, 100 frames a second")
    expect(card).to_be_in_viewport()
    assert page.evaluate(side) == before
    expect(page.locator(".lamps .lamp").first).not_to_have_text("No shirt yet")


def test_signing_in_says_that_it_waits_and_is_not_sent_twice(browser, served):
    served.open_session("A-03")
    page = browser.new_page()
    waiting = []
    page.route("**/auth/sign-in", lambda route: waiting.append(route))  # noqa: PLW0108 - Playwright sets an attribute of it
    served.type_name_and_password(page)
    expect(page.get_by_role("status").filter(has_text="One moment…")).to_be_visible()
    page.get_by_role("button", name="Sign in").click(force=True)
    while not waiting:
        page.wait_for_timeout(50)
    waiting[0].continue_()
    expect(page.locator(".who")).to_contain_text("A-03")
    assert len(waiting) == 1
