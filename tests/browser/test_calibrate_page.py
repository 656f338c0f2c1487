"""The calibration in a real browser, at the pace of a person: two tablets, one leads and one follows."""

import re
from contextlib import ExitStack

import pytest
from browser.eyes.spoken import LISTEN, said
from browser.tablets import TABLETS, go_to, signed_in
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

# What a screen reader says of one step: each once, and nothing that could cut off a Stop.
SAID = [["polite", "Get ready"], ["polite", "Move freely"], ["polite", "Done. Go on, or repeat it."]]
STEP_LIMIT = 60_000  # ms: the longest step of the calibration takes 13 s


@pytest.fixture
def tablets(browser, page_log, own_demo):
    """Yield both tablets, side by side in one demonstration."""
    with ExitStack() as stack:
        yield [stack.enter_context(signed_in(name, browser, page_log, own_demo)) for name in TABLETS]


@pytest.mark.parametrize("end", ["first gesture", pytest.param("result", marks=pytest.mark.long)])
def test_the_calibration_is_walked_through_and_survives_a_reload(tablets, end):
    """One tablet leads, the other one follows; both are looked at. To its result, it takes a minute and a half."""
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
    page.evaluate(LISTEN)
    page.get_by_role("button", name="Start").click()
    page.wait_for_timeout(1000)
    follower.reload()  # in the middle of the step, which goes on
    expect(follower.get_by_role("heading", name="Move freely")).to_be_visible()
    expect(follower.get_by_role("button", name="Stop recording")).to_be_visible()
    keep("calibrate-free")
    earlier = page.get_by_role("button", name="Drive with this calibration")
    expect(earlier).to_be_visible(timeout=STEP_LIMIT)  # a person chooses
    assert said(page) == SAID
    keep("calibrate-now")
    page.get_by_role("button", name="Start").click()
    expect(page.locator(".cue-word")).to_have_text("Push", timeout=STEP_LIMIT)
    keep("calibrate-prompt")
    expect(follower.locator(".cue-word")).to_have_text("Push")
    if end == "first gesture":
        return
    for one in (page, follower):
        expect(one.get_by_role("heading", name="What this body can do")).to_be_visible(timeout=4 * STEP_LIMIT)
        expect(one.get_by_text("When one movement is made, what else counts")).to_be_visible()
        expect(one.get_by_text(re.compile(r"^About \d+ of 100 movements are recognised")).first).to_be_visible()
    keep("calibrate-result")
    page.get_by_role("button", name="Use this calibration").click()
    expect(page.get_by_role("heading", name="Which movement does what")).to_be_visible()
