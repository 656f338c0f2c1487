"""A halted trial: its end ends its stop, and Continue waits for a patient's screen that the trial uses."""

import pytest
from browser.driving import WITHOUT_WEBGL, choose_task, end_trial, go_on_until
from browser.tablets import headers_of
from playwright.sync_api import expect
from processes.served_demo import running_demo

from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser]

SEEN = 1500  # ms: what is tapped sooner was meant for what stood there before


@pytest.fixture(scope="module")
def demo():
    """Yield the link of a running demonstration."""
    with running_demo() as link:
        yield link


@pytest.fixture
def pages(browser, page_log, demo):
    """Yield the clinician's page, and what opens the patient's screen, which draws the plan."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    log = page_log(demo)
    contexts = [browser.new_context(viewport={"width": 768, "height": 1024}) for _ in range(2)]
    contexts[1].add_init_script(WITHOUT_WEBGL)
    page = log.watch(contexts[0].new_page())
    page.goto(demo)

    def patient():
        base = demo.split("/#")[0]
        calls = page.context.request
        offer = calls.post(f"{base}/api/v1/patient-screen/pairing", headers=headers_of(calls, base)).json()
        screen = log.watch(contexts[1].new_page())
        screen.goto(offer["url"])
        return screen

    yield page, patient
    end_trial(page, demo)
    log.assert_clean()
    for context in contexts:
        context.close()


def keep(page, name):
    for width, height in ((390, 844), (768, 1024)):
        page.set_viewport_size({"width": width, "height": height})
        page.wait_for_timeout(200)
        page.screenshot(path=SCREENSHOTS / f"halted-{name}-{width}.png")


def drives(page):
    """Wait until the clock of the trial runs."""
    clock = page.locator(".place .big")
    go_on_until(page, lambda: clock.is_visible() and clock.inner_text() not in ("0:00", ""), "the trial's clock")


def stops(page):
    page.locator("#stop").dispatch_event("pointerdown")
    expect(page.locator(".fault-card")).to_contain_text("Stop was pressed on the screen")
    page.wait_for_timeout(SEEN)


def test_the_end_of_a_halted_trial_ends_its_stop_and_the_next_one_starts_with_one_tap(pages):
    page, _ = pages
    choose_task(page, "corridors", "straight")
    page.get_by_role("button", name="Start trial").click()
    drives(page)
    stops(page)
    page.get_by_role("button", name="End trial").first.click()
    expect(page.get_by_role("button", name="Next trial")).to_be_visible()
    expect(page.get_by_role("button", name="Take the stop back")).to_be_hidden()
    expect(page.locator(".interruptions")).to_contain_text("Stopped once by a person")
    keep(page, "over")
    page.get_by_role("button", name="Next trial").click()
    drives(page)


def test_continue_waits_for_the_patients_screen_and_the_header_says_where_it_is(pages):
    page, open_patient = pages
    choose_task(page, "corridors", "straight")
    patient = open_patient()
    lamp = page.locator(".head .screen-lamp")
    expect(lamp).to_have_text("Patient’s screen")
    expect(patient.locator(".speed, .view, .drawn-plan").first).to_be_attached()
    page.get_by_role("button", name="Start trial").click()
    drives(page)
    stops(page)
    patient.goto("about:blank")
    expect(lamp).to_have_text("Patient’s screen: out of reach")
    page.get_by_role("button", name="Continue").click()
    expect(page.get_by_text("which this trial uses, is out of reach")).to_be_visible()
    expect(page.locator(".fault-card")).to_be_visible()
    keep(page, "away")
