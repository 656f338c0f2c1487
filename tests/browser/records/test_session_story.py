"""A session as a story for a reviewer: from the list of sessions to the replay of a trial, on each size of screen."""

import re

import pytest
from browser.served.review_app import ReviewApp
from browser.tablets import put_first_sentences_away
from playwright.sync_api import expect

from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.people import add_person, the_clinic
from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser]

SIZES = {"390x844": (390, 844), "768x1024": (768, 1024), "1280x800": (1280, 800)}
TOO_WIDE = "document.querySelector('main').scrollWidth > document.querySelector('main').clientWidth"
SMALL = """() => [...document.querySelectorAll("main .person > .btn, main .story a, main .foot a")]
  .filter((one) => one.getBoundingClientRect().height < 44).map((one) => one.outerHTML)"""


@pytest.fixture(scope="module")
def app(tmp_path_factory):
    served = ReviewApp(tmp_path_factory.mktemp("clinic"))
    served.start()
    yield served
    served.stop()


@pytest.fixture(scope="module")
def token(app):
    """Sign a reviewer in; return what the cookie holds."""
    with app.app.state.parts[Database].transaction() as db:
        return sign_in(db, add_person(db, the_clinic(db), "Rhea", "reviewer", None), "test")


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("size", SIZES)
def test_a_reviewer_reads_a_session_as_a_story_and_opens_a_replay(browser, page_log, app, token, size, theme):
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    width, height = SIZES[size]
    context = browser.new_context(viewport={"width": width, "height": height}, color_scheme=theme)
    context.add_cookies([{"name": "bodydrive_sign_in", "value": token, "url": app.address}])
    log = page_log(app.address)
    page = log.watch(context.new_page())
    page.goto(f"{app.address}/#/session/patient/1")
    expect(page.get_by_role("heading", name="Sessions of P-1")).to_be_visible()
    put_first_sentences_away(page)
    page.screenshot(path=SCREENSHOTS / f"story-list-{size}-{theme}.png")
    page.get_by_role("link", name="Story of session 1").click()
    expect(page.get_by_role("heading", name="Story of session 1 of P-1")).to_be_visible()
    story = page.locator(".story")
    expect(story.locator("li").first).to_contain_text("Session began")
    days = [line.inner_text() for line in story.locator("li").all() if re.search(r"\d, 20\d\d", line.inner_text())]
    assert len(days) == 1  # the day stands where it begins
    assert "Session began" in days[0]
    assert "share-event" not in story.inner_text()  # an id that has no text
    page.screenshot(path=SCREENSHOTS / f"story-{size}-{theme}.png")
    assert not page.evaluate(TOO_WIDE)
    assert page.evaluate(SMALL) == []
    trial = story.locator("li").filter(has=page.get_by_role("link", name="Trial 2"))
    expect(trial).to_contain_text("simulated")
    trial.get_by_role("link").click()
    expect(page).to_have_url(f"{app.address}/#/review/1/trial/{app.trials[1]}")
    page.go_back()
    page.get_by_role("link", name="Record", exact=True).click()
    expect(page.get_by_role("heading", name="Session 1 of P-1", exact=True)).to_be_visible()
    page.get_by_role("link", name="Story", exact=True).click()
    expect(story).to_be_visible()
    log.assert_clean()
    context.close()
