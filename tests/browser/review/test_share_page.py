"""The page of a share link on a phone, 300 ms away: a PIN, then story and figures in one answer."""

import asyncio
import time
from concurrent.futures import ThreadPoolExecutor

import pytest
from browser.review.test_far_away import FAR
from browser.sizes import fits, keep, window
from playwright.sync_api import expect

from app.api.sign_in.hashing import Hashing
from app.clock import utc_now
from app.features.consents.service import give_consent
from app.features.sharing.service import add_share
from app.store.database import Database
from app.store.tables import Patient, Trial

pytestmark = [pytest.mark.browser, pytest.mark.long]

PIN = "314159"


@pytest.fixture
def link(app):
    """Make a link whose PIN is known; return its address."""
    with ThreadPoolExecutor(1) as pool:  # the browser has an event loop in this thread
        pin_hash = pool.submit(lambda: asyncio.run(_hash(PIN))).result()
    with app.app.state.parts[Database].transaction() as db:
        patient = db.query(Patient).one()
        for trial in db.query(Trial):
            trial.measures = {**trial.measures, "reached": True}
        give_consent(db, patient.id, "sharing", utc_now().astimezone().date(), "Ada")
        _, token = add_share(db, patient.id, None, pin_hash, 14, "Ada")
    return f"{app.address}/share.html#{token}"


async def _hash(pin: str) -> str:
    hashing = Hashing()
    try:
        return await hashing.hash(pin)
    finally:
        await hashing.close()


def test_a_share_link_on_a_phone_far_away(browser, link) -> None:
    context = browser.new_context(viewport=window("390x844"))
    page = context.new_page()
    context.new_cdp_session(page).send("Network.emulateNetworkConditions", FAR)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    begun = time.monotonic()
    page.goto(link)
    expect(page.get_by_label("PIN of this link")).to_be_visible(timeout=20_000)
    print("PIN asked after", round(time.monotonic() - begun, 1), "s")  # noqa: T201
    page.get_by_label("PIN of this link").fill("000000")
    page.get_by_role("button", name="Open").click()
    expect(page.get_by_role("alert")).to_contain_text("The link or the PIN is wrong", timeout=20_000)
    expect(page.get_by_label("PIN of this link")).to_be_focused()
    page.get_by_label("PIN of this link").fill(f"{PIN[:3]} {PIN[3:]}")  # as people write it
    asked.clear()
    begun = time.monotonic()
    page.get_by_role("button", name="Open").click()
    expect(page.get_by_role("heading", name="Records of P-1")).to_be_visible(timeout=60_000)
    print("readable after", round(time.monotonic() - begun, 1), "s")  # noqa: T201
    assert [url.rpartition("/api/v1/")[2] for url in asked] == ["shared/open", "shared"]
    expect(page.locator("main")).to_contain_text("Trial 2")
    expect(page.get_by_role("heading", name="Records of P-1")).to_be_focused()
    assert "Heron" not in page.locator("body").inner_text()
    assert page.locator("svg polyline").count() >= 3
    curve = page.locator(".area-curve").first
    expect(curve.locator("circle")).to_have_count(2)
    assert curve.locator("text").all_text_contents()[-2:] == ["Trial 1", "Trial 2"]
    fits(page, "main")
    # What the page is for, by keyboard.
    page.keyboard.press("Shift+Tab")
    expect(page.get_by_role("button", name="What is this page for?")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.get_by_role("dialog", name="Shared records").get_by_role("heading")).to_be_focused(timeout=20_000)
    fits(page)
    page.keyboard.press("Escape")
    expect(page.get_by_role("button", name="What is this page for?")).to_be_focused()
    keep(page, "share-390")


def test_a_page_without_its_reference_says_so_and_reads_it_after_the_next_pin(browser, link) -> None:
    page = browser.new_page(viewport=window("390x844"))
    page.route("**/api/v1/reference", lambda route: route.abort())
    page.goto(link)
    page.get_by_label("PIN of this link").fill(PIN)
    page.get_by_role("button", name="Open").click()
    expect(page.get_by_role("alert")).to_contain_text("does not answer", timeout=20_000)
    page.unroute("**/api/v1/reference")
    page.get_by_label("PIN of this link").fill(PIN)
    page.get_by_role("button", name="Open").click()
    expect(page.get_by_role("heading", name="Records of P-1")).to_be_visible(timeout=20_000)
