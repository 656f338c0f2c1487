"""Who to look at: what a reviewer meets first, on a telephone; a tap on a reason leads to what it is about.

A reviewer who looks on from elsewhere has no Stop of the clinic; whoever is in the building has.
"""

import re

import pytest
from browser.sizes import fits, keep
from playwright.sync_api import expect

from app.features.comments.service import add_comment
from app.store.database import Database
from app.store.people import add_person, the_clinic
from app.store.runs import find_trial

pytestmark = [pytest.mark.browser]


def steps(page):
    return [one.inner_text().split("\n")[0] for one in page.locator(".rail a").all() if one.is_visible()]


def test_a_reviewer_begins_with_who_needs_attention(app, open_for):
    with app.app.state.parts[Database].transaction() as db:
        author = add_person(db, the_clinic(db), "Ben", "clinician", None)
        add_comment(db, find_trial(db, app.trials[0]), author.id, 2.0, "Here the turn is late.")
    page = open_for("Rhea", "reviewer", "", "390x844")
    expect(page.get_by_role("heading", name="Who to look at")).to_be_visible()
    assert steps(page) == ["Patients", "Review", "Settings"]
    expect(page.get_by_text("worked out")).to_have_count(0)
    reason = page.get_by_role("link", name="1 unread comment")
    assert reason.bounding_box()["height"] >= 44
    fits(page)
    keep(page, "390x844-attention")
    reason.click()
    expect(page).to_have_url(re.compile(f"#/review/1/trial/{app.trials[0]}$"))


def test_a_clinician_comes_to_it_from_the_review(open_for):
    page = open_for("Cleo", "clinician", "attention")
    assert "Drive" in steps(page)
    page.get_by_role("link", name="P-1").first.click()
    expect(page.get_by_role("heading", name="What was learnt")).to_be_visible()


@pytest.mark.parametrize(
    ("role", "headers", "has_stop"),
    [("reviewer", {}, True), ("reviewer", {"Via": "1.1 proxy"}, False), ("clinician", {"Via": "1.1 proxy"}, True)],
)
def test_who_has_a_stop(open_for, role, headers, has_stop):
    page = open_for("Rhea", role, "review/1")
    stops = []
    page.on("request", lambda request: stops.append(request.url) if request.url.endswith("/control/stop") else None)
    page.context.set_extra_http_headers(headers)
    page.reload()
    expect(page.get_by_role("heading", name="What was learnt")).to_be_visible()
    expect(page.locator("header .stop")).to_be_visible(visible=has_stop)
    assert stops == []
