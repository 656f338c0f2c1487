"""The whole story in a real browser: equipment, controls, a drive, its score, and what goes wrong."""

import os
import signal

import psutil
import pytest
from browser.driving import bend_until, choose_task, drive_by_plan, drives_until, ends_by_hand, reaches_the_goal
from browser.tablets import go_to, signed_in
from playwright.sync_api import expect
from processes.served_demo import printed_link, running_program

pytestmark = [pytest.mark.browser]


@pytest.fixture
def demo():
    """Yield a running demonstration: its process and its link."""
    with running_program("demo", "--port", "0") as process:
        yield process, printed_link(process)
    assert process.returncode == 0


@pytest.fixture(params=["1024x768", pytest.param("820x1180", marks=pytest.mark.long)])
def tablet(request, browser, page_log, demo):
    """Yield one tablet after the other, each in a demonstration of its own."""
    with signed_in(request.param, browser, page_log, demo[1], in_3d=True) as page_and_keep:
        yield page_and_keep


def drives_to_the_goal(page, keep):
    """Start the chosen trial, look at it from everywhere, and wait for its end at the goal."""
    page.get_by_role("button", name="Start trial").click()
    frame = page.frame_locator("iframe")
    expect(frame.locator("canvas").first).to_be_visible()
    drives_until(page, 2)
    for view in ("Eye", "Chase", "Top"):
        page.get_by_text(view, exact=True).click()
        page.wait_for_timeout(700)  # two pictures
        keep(f"drive-{view.lower()}")
    page.get_by_text("Plan", exact=True).click()  # for the rest of the way: it costs software far less than a 3D view
    reaches_the_goal(page)


def test_a_clinic_drives_stops_and_loses_its_control_process(tablet, demo):
    page, keep = tablet
    from_the_shirt_to_a_scored_drive(page, keep)
    the_visitor_drives_by_pads_stops_and_goes_on(page, keep)
    the_loss_of_the_control_process_is_said(page, keep, demo[0])


def from_the_shirt_to_a_scored_drive(page, keep):
    keep("drive-choose")
    expect(page.get_by_text("demonstration", exact=False).first).to_be_visible()

    go_to(page, "patients")
    expect(page.get_by_text("Kingfisher").first).to_be_visible()
    keep("patients")

    go_to(page, "shirt")
    lamps = page.locator(".bodies .sensor")
    expect(lamps).to_have_count(52)
    lamps.nth(20).click()
    keep("shirt")

    go_to(page, "controls")
    handle = page.get_by_role("slider").first
    before = handle.get_attribute("aria-valuenow")
    handle.focus()
    page.keyboard.press("ArrowRight")
    assert float(handle.get_attribute("aria-valuenow")) > float(before)
    expect(page.get_by_role("button", name="Undo")).to_be_enabled()
    keep("controls")
    page.get_by_role("button", name="Undo").click()
    expect(page.get_by_role("slider").first).to_have_attribute("aria-valuenow", before)

    go_to(page, "drive")
    choose_task(page, "corridors", "straight")
    keep("drive-chosen")
    drives_to_the_goal(page, keep)
    expect(page.get_by_text("Distance driven").first).to_be_visible()
    one_of_the_first = page.get_by_text("one of the first three trials of this task")
    count_it = page.get_by_role("button", name="Count it")  # where a busy machine interrupted the trial
    expect(one_of_the_first.or_(count_it)).to_be_visible()
    if count_it.is_visible():
        count_it.click()
    expect(one_of_the_first).to_be_visible()
    keep("trial-over-first")

    page.get_by_role("button", name="Next trial").click()
    expect(page.locator(".place")).to_be_visible()
    page.get_by_text("Plan", exact=True).click()
    drives_until(page, 2)
    ends_by_hand(page)
    keep("trial-over-second")

    go_to(page, "review")
    expect(page.locator(".chart canvas").first).to_be_visible()
    keep("review")


def the_visitor_drives_by_pads_stops_and_goes_on(page, keep):
    drive_by_plan(page)
    go_to(page, "shirt")
    become_the_body(page)
    keep("shirt-visitor")
    go_to(page, "drive")
    page.get_by_role("button", name="Start trial").click()
    expect(page.locator(".pad-dock")).to_be_visible()
    drives_until(page, 2)
    speed = page.locator(".bar .speed .big")
    bend_until(page, speed, 0.1)
    keep("visitor-drives")
    page.locator("#stop").dispatch_event("pointerdown")
    expect(page.get_by_role("button", name="Continue")).to_be_visible()
    expect(speed).to_contain_text("0.00")
    keep("stopped")
    page.get_by_role("button", name="Continue").click()
    expect(page.get_by_role("button", name="Continue")).to_be_hidden()


def the_loss_of_the_control_process_is_said(page, keep, process):
    control = next(
        child
        for child in psutil.Process(process.pid).children(recursive=True)
        if "app.pipeline.process" in child.cmdline()
    )
    os.kill(control.pid, signal.SIGKILL)
    expect(page.get_by_text("control process", exact=False).first).to_be_visible()
    keep("control-lost")


def become_the_body(page):
    """Choose the visitor as the body in front of the simulated shirt."""
    card = page.locator("section.card", has=page.get_by_role("heading", name="Simulated body"))
    card.locator("summary").click()
    card.get_by_role("radio", name="You").check(force=True)
    expect(page.get_by_text("You move this body").first).to_be_visible()
