"""A second sender of the shirt's frames on the Shirt page: named, left out, and taken by a tap."""

from contextlib import closing

import pytest
from browser.sizes import each_size, keep
from browser.tablets import choose_network_shirt, send
from browser.wave_sender import WaveSender
from playwright.sync_api import expect
from processes.udp_shirt import free_port

pytestmark = [pytest.mark.browser]


def tell_of_the_equipment(page, link):
    """Let every page read the equipment again, although nothing differs."""
    with page.expect_response("**/api/v1/equipment"):
        assert send(page, link, "PUT", "/equipment/head", {"config": None}).ok
    page.wait_for_timeout(200)


def test_another_sender_is_named_and_becomes_the_shirt_by_a_tap(own_demo, open_page):
    page, port = open_page(own_demo, has_touch=True), free_port()
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    card = choose_network_shirt(page, port)
    tell_of_the_equipment(page, own_demo)
    assert card.get_by_label("Port").input_value() == str(port)  # what is typed outlives the news
    card.get_by_role("button", name="Use this").click()
    expect(card.get_by_text(f"Network shirt on port {port}")).to_be_visible()
    with closing(WaveSender(port)) as first:
        expect(card.get_by_text(f"Its frames come from {first.name}.")).to_be_visible()
        with closing(WaveSender(port)) as second:
            take = card.get_by_role("button", name="Use the new sender")
            expect(take).to_be_visible()
            expect(card.get_by_text(f"Another sender, {second.name}, also sends frames.")).to_be_visible()
            for size in each_size(page, settle=0):
                take.scroll_into_view_if_needed()
                assert take.bounding_box()["height"] >= 44
                keep(page, f"{size}-shirt-sender")
            first.close()
            take.click()
            expect(card.get_by_text(f"Its frames come from {second.name}.")).to_be_visible()
            expect(take).to_have_count(0)
