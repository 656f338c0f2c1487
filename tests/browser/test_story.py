"""The whole story in a real browser: equipment, calibration, controls, a drive, its score, and what goes wrong."""

import os
import re
import signal
from contextlib import ExitStack, contextmanager

import psutil
import pytest
from browser.driving import bend_until, go_on_until
from playwright.sync_api import expect
from processes.test_demo_process import bodydrive, printed_link

from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser, pytest.mark.timeout(420)]

TABLETS = {"1024x768": (1024, 768), "820x1180": (820, 1180)}
STEP_LIMIT = 60_000  # ms: the longest step of the calibration takes 13 s
AFTER_SOME_SECONDS = re.compile(r"^0:(0[2-9]|[1-5]\d)$")
DRIVE_LIMIT = 150  # s
PATIENCE = 60_000  # ms: drawing in software on a busy machine is slow


@pytest.fixture
def demo():
    """Yield a running demonstration: its process and its link."""
    with bodydrive("demo", "--port", "0") as process:
        try:
            yield process, printed_link(process)
        finally:
            process.send_signal(signal.SIGINT)
            assert process.wait(20) == 0


@contextmanager
def signed_in(name, browser, page_log, link):
    """Yield a page of one tablet, signed in to the demonstration, and a function that keeps a screenshot."""
    width, height = TABLETS[name]
    page = browser.new_page(viewport={"width": width, "height": height}, has_touch=True)
    page.set_default_timeout(PATIENCE)
    log = page_log(link)
    log.watch(page)
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    page.goto(link)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible(timeout=PATIENCE)
    yield page, lambda picture: page.screenshot(path=SCREENSHOTS / f"{name}-{picture}.png")
    log.assert_clean()
    page.close()


@pytest.fixture(params=["1024x768", pytest.param("820x1180", marks=pytest.mark.long)])
def tablet(request, browser, page_log, demo):
    """Yield one tablet after the other, each in a demonstration of its own."""
    with signed_in(request.param, browser, page_log, demo[1]) as page_and_keep:
        yield page_and_keep


@pytest.fixture
def tablets(browser, page_log, demo):
    """Yield both tablets, side by side in one demonstration."""
    with ExitStack() as stack:
        yield [stack.enter_context(signed_in(name, browser, page_log, demo[1])) for name in TABLETS]


def go_to(page, step):
    page.goto(page.url.split("#")[0] + f"#/{step}")


def drives_to_the_goal(page, keep):
    """Start the chosen trial, look at it from everywhere, and wait for its end at the goal."""
    page.get_by_role("button", name="Start trial").click()
    frame = page.frame_locator("iframe")
    expect(frame.locator("canvas").first).to_be_visible(timeout=PATIENCE)
    clock = page.locator(".place .big")
    go_on_until(page, lambda: AFTER_SOME_SECONDS.match(clock.inner_text()), "two seconds of the trial")
    for view in ("Eye", "Chase", "Top"):
        page.get_by_text(view, exact=True).click()
        page.wait_for_timeout(1500)
        keep(f"drive-{view.lower()}")
    reaches_the_goal(page)


def reaches_the_goal(page):
    goal = page.get_by_role("heading", name="Goal reached")
    go_on_until(page, goal.is_visible, "the goal", seconds=DRIVE_LIMIT)


def test_from_the_shirt_to_a_scored_drive(tablet):
    page, keep = tablet
    keep("drive-choose")
    expect(page.get_by_text("demonstration", exact=False).first).to_be_visible()

    go_to(page, "patients")
    expect(page.get_by_text("Kingfisher").first).to_be_visible()
    keep("patients")

    go_to(page, "shirt")
    lamps = page.locator(".bodies .sensor")
    expect(lamps).to_have_count(52)
    lamps.nth(20).click()
    page.wait_for_timeout(1500)
    keep("shirt")

    go_to(page, "controls")
    handle = page.get_by_role("slider").first
    before = float(handle.get_attribute("aria-valuenow"))
    handle.focus()
    page.keyboard.press("ArrowRight")
    assert float(handle.get_attribute("aria-valuenow")) > before
    page.wait_for_timeout(1500)
    keep("controls")
    page.get_by_role("button", name="Undo").click()
    page.wait_for_timeout(500)
    assert float(page.get_by_role("slider").first.get_attribute("aria-valuenow")) == pytest.approx(before)

    go_to(page, "drive")
    page.get_by_text("Straight ahead", exact=True).click()
    keep("drive-chosen")
    drives_to_the_goal(page, keep)
    expect(page.get_by_text("Dist, distance driven").first).to_be_visible()
    keep("trial-over-first")

    page.get_by_role("button", name="Next trial").click()
    expect(page.locator(".place")).to_be_visible()
    reaches_the_goal(page)
    expect(page.get_by_text("Trial 1").first).to_be_visible()
    keep("trial-over-second")

    go_to(page, "review")
    expect(page.locator(".js-plotly-plot").first).to_be_visible(timeout=PATIENCE)
    page.wait_for_timeout(1000)
    keep("review")


def test_the_calibration_is_walked_through_and_survives_a_reload(tablets):
    """One tablet leads, the other one follows; both are looked at."""
    (page, _), (follower, _) = tablets

    def keep(picture):
        for _, keep_one in tablets:
            keep_one(picture)

    for one in (follower, page):
        go_to(one, "calibrate")
        expect(one.get_by_role("button", name="Start")).to_be_visible()
        one.get_by_role("switch", name="Go on by itself").set_checked(False, force=True)
    keep("calibrate-rest")
    page.get_by_role("button", name="Start").click()
    expect(page.get_by_role("heading", name="Move freely")).to_be_visible(timeout=STEP_LIMIT)
    page.reload()
    expect(page.get_by_role("heading", name="Move freely")).to_be_visible()
    page.get_by_role("switch", name="Go on by itself").set_checked(True, force=True)
    page.get_by_role("button", name="Start").click()
    page.wait_for_timeout(5000)
    keep("calibrate-free")
    expect(page.locator(".cue-word")).to_have_text("Push", timeout=STEP_LIMIT)
    keep("calibrate-prompt")
    for one in (page, follower):
        expect(one.get_by_role("heading", name="What this body can do")).to_be_visible(timeout=4 * STEP_LIMIT)
        expect(one.get_by_text("When one gesture is made, what else moves")).to_be_visible(timeout=PATIENCE)
    keep("calibrate-result")
    page.get_by_role("button", name="Use this calibration").click()
    expect(page.get_by_role("heading", name="Which movement does what")).to_be_visible()


def test_the_visitor_drives_by_pads_stops_and_goes_on(tablet, demo):
    page, keep = tablet
    go_to(page, "shirt")
    become_the_body(page)
    keep("shirt-visitor")
    go_to(page, "drive")
    page.get_by_role("button", name="Start trial").click()
    expect(page.locator(".pad-dock")).to_be_visible()
    clock = page.locator(".place .big")
    go_on_until(page, lambda: AFTER_SOME_SECONDS.match(clock.inner_text()), "two seconds of the trial")
    speed = page.locator(".bar .speed .big")
    bend_until(page, speed, 0.1)
    keep("visitor-drives")
    page.locator("#stop").dispatch_event("pointerdown")
    expect(page.get_by_role("button", name="Continue")).to_be_visible()
    expect(speed).to_contain_text("0.00")
    keep("stopped")
    page.get_by_role("button", name="Continue").click()
    expect(page.get_by_role("button", name="Continue")).to_be_hidden()

    control = next(
        child
        for child in psutil.Process(demo[0].pid).children(recursive=True)
        if "app.pipeline.process" in child.cmdline()
    )
    os.kill(control.pid, signal.SIGKILL)
    expect(page.get_by_text("control process", exact=False).first).to_be_visible()
    keep("control-lost")


def become_the_body(page):
    """Choose the visitor as the body in front of the simulated shirt."""
    card = page.locator("section.card", has=page.get_by_role("heading", name="Body inside"))
    card.locator("summary").click()
    card.get_by_role("radio", name="You").check(force=True)
    expect(page.get_by_text("You move this body").first).to_be_visible()
