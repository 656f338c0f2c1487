"""A home-made board on a cable in a real browser, up to its first recorded step; `make sources-tried` tries all."""

import pytest
from playwright.sync_api import Playwright, expect
from sources_tried.far_ends import running
from sources_tried.sources import SOURCES
from sources_tried.story import Story, begins_session, chooses, demonstration, made, opened_browser, opened_page

pytestmark = [pytest.mark.browser, pytest.mark.long]


def test_a_board_that_prints_its_sensors_is_chosen_and_recorded(playwright: Playwright, tmp_path):
    source = next(source for source in SOURCES if source.name == "lines")
    with (
        running(source.far_end, made(tmp_path / "far-end")) as (facts, ask),
        opened_browser(playwright, facts, made(tmp_path / "browser")) as browser,
        demonstration(made(tmp_path / "demo"), facts) as (link, _),
        opened_page(browser, link) as (page, log),
    ):
        ask("watch", *link.split("/#demo="))
        story = Story(page, link, source.name, made(tmp_path / "photographs"))
        chooses(story, source, facts, ask)
        begins_session(story, source)
        story.tap(story.foot.get_by_role("button", name="Start", exact=True))
        expect(page.get_by_role("heading", name="Move freely")).to_be_visible()
        assert story.get("/calibration")["steps"][0]["status"] == "done"
        log.assert_quiet()
