"""The two-minute test in a browser: the cross on both screens, Stop, the figures, and the sliders by keyboard."""

import pytest
from browser.eyes.opening import go, tap
from browser.eyes.places import PLACES
from browser.eyes.states.session_places import interface_test_over
from playwright.sync_api import expect

from app.faults import Fault

pytestmark = [pytest.mark.browser]

PLACE = """() => {
  const dot = document.querySelector(".target-cross .dot");
  return [+dot.getAttribute("cx"), +dot.getAttribute("cy")];
}"""


def test_the_dot_moves_on_both_screens_and_stop_ends_the_test(page, clinic, browser, until):
    go(page, clinic, "drive")
    page.get_by_role("link", name="Two-minute test").click()
    other = browser.new_page(storage_state=clinic.storage())
    PLACES["patient's screen"](other, clinic)
    tap(page, "Start the test")
    expect(page.get_by_text("The first target comes in a moment")).to_be_visible()
    clinic.process.run_t = 3.5
    expect(other.get_by_text("Bring the dot into the target.")).to_be_visible()
    assert page.evaluate(PLACE) == [0, 0]
    clinic.process.says["u1"] = 1.0
    clinic.when_left.append(lambda: clinic.process.says.pop("u1"))
    clinic.process.run_t = 3.55
    for shown in (page, other):
        until(shown, "+document.querySelector('.target-cross .dot').getAttribute('cy') < -4")  # up
    clinic.fault(Fault.STOP_TABLET)
    expect(page.get_by_text("This test was stopped, so it does not count")).to_be_visible()
    expect(other.locator(".test-layer")).to_be_hidden()
    expect(page.get_by_role("button", name="Start the test")).to_be_visible()


def test_the_six_sliders_are_answered_and_left_out_by_keyboard(page, clinic):
    interface_test_over(page, clinic)
    before = clinic.good("GET", "/interface-tests?patient=1")["tests"][-1]
    assert before["workload"] is None
    slider = page.get_by_role("slider", name="Thinking")
    assert slider.get_attribute("aria-valuetext") == "No answer"
    slider.focus()
    page.keyboard.press("ArrowRight")
    page.get_by_role("slider", name="Effort").focus()
    page.keyboard.press("End")
    page.get_by_role("slider", name="Body").focus()
    page.keyboard.press("Home")
    page.keyboard.press("Tab")
    expect(page.get_by_role("button", name="Leave out: Body")).to_be_focused()
    page.keyboard.press("Enter")
    page.get_by_role("button", name="Save the answers").press("Enter")
    expect(page.get_by_text("Saved.")).to_be_visible()
    saved = clinic.good("GET", "/interface-tests?patient=1")["tests"][-1]
    assert (saved["workload"]["mental"], saved["workload"]["effort"], saved["workload"]["physical"]) == (55, 100, None)
    assert saved["raw_tlx"] is None


def test_the_review_shows_the_tests_and_what_is_better_than_noise(page, clinic):
    clinic.add_tests()
    go(page, clinic, "review/1")
    expect(page.get_by_role("heading", name="Over the tests")).to_be_visible()
    table = page.get_by_role("region", name="Better, or noise?").last
    expect(
        table.get_by_role("row", name="Speed and precision together").get_by_text("better than noise").first
    ).to_be_visible()
    assert page.get_by_role("slider").count() == 0  # nothing is asked there
    expect(page.locator(".test-course .chart canvas").first).to_be_attached()
