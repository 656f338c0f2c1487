"""Review pages that are open while a trial begins and ends elsewhere, in a real browser of a reviewer."""

from urllib.parse import urlsplit

import pytest
from browser.served.clinic_app import go
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

PLACE = {"floorplan": "apartment", "screen": "the-screen-of-the-tests"}
QUIET = 1000  # ms without a question, after which a page asks nothing more
OF_THE_FRAME = {"/api/v1/session", "/api/v1/equipment"}  # who is here, and whether the disk is full


@pytest.fixture(scope="module")
def served(served):
    served.open_session("A-03")
    served.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
    return served


@pytest.fixture
def reviewer(served, open_page):
    """Return the page of a reviewer who is signed in."""
    token = served.sign_in_as("Rita", "reviewer")
    where = f"{served.address}/#/review/{served.patients['A-03']}"
    return open_page(where, "1280x800", sign_in=token, allowed="Failed to load resource")


def drive(served):
    """Begin a trial; return its id."""
    path = served.good("GET", f"/floorplans/{PLACE['floorplan']}")["paths"][0]["name"]
    return served.good("POST", "/trials", {**PLACE, "path": path})["id"]


def end(served):
    served.good("POST", "/trials/current/end", {})


def test_the_list_and_the_page_of_a_trial_follow_it_to_its_end(reviewer, served):
    patient = served.patients["A-03"]
    expect(reviewer.get_by_role("heading", name="No trials yet")).to_be_visible()
    first = drive(served)
    row = reviewer.locator("table.trials tbody tr")
    expect(row).to_contain_text("running")
    end(served)
    expect(row).to_contain_text("by hand")

    # A list that is drawn anew keeps what was ticked, and shows what became of a trial.
    second = drive(served)
    expect(row).to_have_count(2)
    reviewer.get_by_label("Compare trial 1").check()
    served.good("POST", f"/trials/{first}/discard", {"reason": "somebody stood in the way"})
    expect(row.last).to_contain_text("somebody stood in the way")
    expect(reviewer.get_by_label("Compare trial 1")).to_be_checked()

    go(reviewer, f"review/{patient}/trial/{second}")
    expect(reviewer.get_by_role("heading", name="Trial 2 is running")).to_be_visible()
    end(served)
    expect(reviewer.get_by_role("heading", name="Ended by hand")).to_be_visible()


def when_quiet(page, asked, answered):
    """Return when the page has asked nothing for a while, and waits for no answer."""
    before = -1
    while before < len(asked) or len(answered) < len(asked):
        before = len(asked)
        page.wait_for_timeout(QUIET)


def test_a_page_asks_nothing_for_a_trial_of_another_patient(served, open_page):
    shown, other = served.patients["A-03"], served.patients["B-12"]
    served.open_session("A-03")
    trial = drive(served)
    end(served)
    served.open_session("B-12")
    where = f"{served.address}/#/review/{shown}"
    page = open_page(where, "1280x800", sign_in=served.sign_in_as("Ron", "reviewer"), allowed="Failed to load resource")
    asked, answered = [], []

    def keep(urls, request):
        if "/api/v1/" in request.url:
            urls.append(request.url)

    page.on("request", lambda request: keep(asked, request))
    page.on("requestfinished", lambda request: keep(answered, request))
    page.on("requestfailed", lambda request: keep(answered, request))
    page.reload()
    expect(page.locator("table.trials tbody tr").first).to_contain_text("by hand")
    when_quiet(page, asked, answered)

    asked.clear()
    answered.clear()
    with page.expect_request("**/api/v1/session"):
        drive(served)
        end(served)
    when_quiet(page, asked, answered)
    assert {urlsplit(url).path for url in asked} <= OF_THE_FRAME
    assert [one["status"] for one in served.good("GET", f"/trials?patient={other}")] == ["done"]

    with page.expect_request(f"**/api/v1/trials?patient={shown}"):
        served.good("POST", f"/trials/{trial}/discard", {"reason": "somebody stood in the way"})
