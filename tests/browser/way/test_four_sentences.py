"""Each of the four sentences for a first time leads where it says, with the words that it uses, in few taps."""

import pytest
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]


@pytest.fixture
def open_at(open_page):
    """Return what opens a link on a tablet, with the sentences on it, and follows the number of one of them."""

    def follow(link, number):
        page = open_page(link, has_touch=True)
        expect(page.locator(".first-sentences")).to_be_visible()
        page.locator(f'.rail a[data-first="{number}"]:visible').tap()
        return page

    return follow


def test_stop_is_in_view_with_its_number_and_one_tap_stops(demo, open_page):
    page = open_page(demo, has_touch=True)
    expect(page.locator(".first-sentences li").first).to_contain_text("STOP, on every page")
    stop = page.get_by_role("button", name="Stop the chair now")
    expect(stop).to_be_in_viewport(ratio=1)
    stop.tap()
    expect(page.get_by_role("button", name="Take the stop back")).to_be_visible()
    page.get_by_role("button", name="Take the stop back").tap()
    expect(page.get_by_role("button", name="Take the stop back")).to_have_count(0)


def test_one_joint_is_repeated_from_the_row_of_steps(demo, open_at):
    page = open_at(demo, 2)
    page.get_by_role("list", name="The steps of the calibration").get_by_role("button", name="right elbow").tap()
    expect(page.get_by_role("heading", name="Bend your right elbow")).to_be_visible()
    expect(page.get_by_role("button", name="Start", exact=True)).to_be_in_viewport(ratio=1)


def test_turning_becomes_slower_and_undo_takes_it_back(demo, open_at):
    page = open_at(demo, 3)
    speed = page.get_by_role("group", name="Turn speed", exact=True)
    expect(speed).to_be_visible()
    before = speed.locator("output").inner_text()
    speed.get_by_role("button", name="Turn speed −").tap()
    expect(speed.locator("output")).not_to_have_text(before)
    page.get_by_role("button", name="Undo").tap()
    expect(speed.locator("output")).to_have_text(before)


def test_whether_last_week_was_better_is_read_without_scrolling(course, open_at):
    page = open_at(course.link, 4)
    page.get_by_label("Patient").select_option(label="P-1 Heron")
    expect(page.get_by_role("heading", name="Better, or noise?")).to_be_in_viewport(ratio=1)
    expect(page.get_by_text("m² better than noise").first).to_be_in_viewport(ratio=1)
