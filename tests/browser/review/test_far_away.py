"""A reviewer's home and the page of a trial on a phone, 300 ms away: readable after few round trips."""

import re
import time

import pytest
from browser.sizes import fits
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.long]

FAR = {"offline": False, "latency": 300, "downloadThroughput": 500_000, "uploadThroughput": 250_000}  # ms, byte/s
PATIENCE = 60_000  # ms: how long a busy machine may take; what a person waits for is the number of round trips


HOME = {"start", "reference", "equipment", "attention"}
TRIAL = {"trials/2", "trials", "floorplans", "floorplans/follow_me.easy"} | {
    *("trials/2/verdicts", "trials/2/timeline", "trials/2/comments", "replays")
}


def api_paths(asked):
    return [url.partition("/api/v1/")[2].partition("?")[0] for url in asked if "/api/v1/" in url]


def test_a_reviewer_reads_home_and_a_trial_from_far_away(app, open_for):
    page = open_for("Rhea", "reviewer", "", "390x844")
    page.context.new_cdp_session(page).send("Network.emulateNetworkConditions", FAR)
    asked = []
    page.on("request", lambda request: asked.append(request.url))
    begun = time.monotonic()
    page.reload()
    expect(page.get_by_role("heading", name="Who to look at")).to_be_visible(timeout=PATIENCE)
    expect(page.get_by_role("link", name="P-1").first).to_be_visible(timeout=PATIENCE)
    print("home readable after", round(time.monotonic() - begun, 1), "s")  # noqa: T201
    paths = api_paths(asked)
    assert len(paths) == len(set(paths))  # nothing is asked for twice
    assert set(paths) <= HOME
    fits(page)

    asked.clear()
    begun = time.monotonic()
    page.evaluate(f"location.hash = '#/review/1/trial/{app.trials[1]}'")
    expect(page.get_by_role("slider").first).to_be_visible(timeout=PATIENCE)
    print("trial readable after", round(time.monotonic() - begun, 1), "s")  # noqa: T201
    paths = api_paths(asked)
    assert len(paths) == len(set(paths))
    assert set(paths) <= TRIAL
    expect(page.get_by_text("0.0 / 23.5 s")).to_be_visible(timeout=PATIENCE)
    page.get_by_role("button", name="Play").click()
    expect(page.get_by_text(re.compile(r"^[1-9]\d?\.\d / 23\.5 s$"))).to_be_visible(timeout=PATIENCE)
    fits(page)
