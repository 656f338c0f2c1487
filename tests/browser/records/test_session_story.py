"""A session as a story for a reviewer: from the list of sessions to the replay of a trial, on each size of screen."""

import re

import pytest
from browser.sizes import photograph
from browser.tablets import put_first_sentences_away
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]


def photographed(page, name, touched=""):
    for theme in ("light", "dark"):
        page.emulate_media(color_scheme=theme)
        photograph(page, f"{name}-{theme}", touched=touched)


def test_a_reviewer_reads_a_session_as_a_story_and_opens_a_replay(recorded, open_page):
    token = recorded.sign_in_as("Rhea", "reviewer")
    page = open_page(f"{recorded.address}/#/session/patient/1", sign_in=token)
    expect(page.get_by_role("heading", name="Sessions of P-1")).to_be_visible()
    put_first_sentences_away(page)
    photographed(page, "story-list")
    page.get_by_role("link", name="Story of session 1").click()
    expect(page.get_by_role("heading", name="Story of session 1 of P-1")).to_be_visible()
    story = page.locator(".story")
    expect(story.locator("li").first).to_contain_text("Session began")
    days = [line.inner_text() for line in story.locator("li").all() if re.search(r"\d, 20\d\d", line.inner_text())]
    assert len(days) == 1  # the day stands where it begins
    assert "Session began" in days[0]
    assert "share-event" not in story.inner_text()  # an id that has no text
    photographed(page, "story", touched="main .person > .btn, main .story, main .foot")
    trial = story.locator("li").filter(has=page.get_by_role("link", name="Trial 2"))
    expect(trial).to_contain_text("simulated")
    trial.get_by_role("link").click()
    expect(page).to_have_url(f"{recorded.address}/#/review/1/trial/{recorded.trials[1]}")
    page.go_back()
    page.get_by_role("link", name="Record", exact=True).click()
    expect(page.get_by_role("heading", name="Session 1 of P-1", exact=True)).to_be_visible()
    page.get_by_role("link", name="Story", exact=True).click()
    expect(story).to_be_visible()
