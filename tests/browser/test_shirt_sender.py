"""A second sender of the shirt's frames on the Shirt page: named, left out, and taken by a tap."""

import pytest
from browser.tablets import headers_of
from browser.wave_sender import WaveSender
from playwright.sync_api import expect
from processes.served_demo import running_demo
from processes.udp_shirt import free_port

from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser]

SIZES = {"768x1024": (768, 1024), "1280x800": (1280, 800), "390x844": (390, 844)}


@pytest.fixture
def demo(tmp_path):
    with running_demo(TMPDIR=str(tmp_path)) as link:
        yield link


def tell_of_the_equipment(page, link):
    """Let every page read the equipment again, although nothing differs."""
    base, calls = link.split("/#")[0], page.context.request
    with page.expect_response("**/api/v1/equipment"):
        assert calls.put(f"{base}/api/v1/equipment/head", headers=headers_of(calls, base), data={"config": None}).ok
    page.wait_for_timeout(200)


def test_another_sender_is_named_and_becomes_the_shirt_by_a_tap(browser, page_log, demo):
    page = browser.new_page(viewport={"width": 768, "height": 1024}, has_touch=True)
    page.set_default_timeout(60_000)
    expect.set_options(timeout=60_000)
    log = page_log(demo)
    log.watch(page)
    page.goto(demo)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    page.goto(page.url.split("#")[0] + "#/shirt")
    port = free_port()
    card = page.locator("section.card", has=page.get_by_role("heading", name="Source"))
    card.locator("summary").click()
    card.get_by_text("A shirt over the network", exact=True).click()
    card.get_by_label("Port").fill(str(port))
    tell_of_the_equipment(page, demo)
    assert card.get_by_label("Port").input_value() == str(port)  # what is typed outlives the news
    card.get_by_role("button", name="Use this").click()
    expect(card.get_by_text(f"Network shirt on port {port}")).to_be_visible()
    first = WaveSender(port)
    expect(card.get_by_text(f"Its frames come from {first.name}.")).to_be_visible()
    second = WaveSender(port)
    try:
        take = card.get_by_role("button", name="Use the new sender")
        expect(take).to_be_visible()
        expect(card.get_by_text(f"Frames come from {second.name}, too.")).to_be_visible()
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        for name, (width, height) in SIZES.items():
            page.set_viewport_size({"width": width, "height": height})
            take.scroll_into_view_if_needed()
            assert take.bounding_box()["height"] >= 44
            page.screenshot(path=SCREENSHOTS / f"{name}-shirt-sender.png")
        first.close()
        take.click()
        expect(card.get_by_text(f"Its frames come from {second.name}.")).to_be_visible()
        expect(take).to_have_count(0)
    finally:
        first.close()
        second.close()
    log.assert_clean()
    page.close()
