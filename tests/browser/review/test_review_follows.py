"""Review pages that are open while a trial begins and ends elsewhere, in a real browser of a reviewer."""

import pytest
from browser.served.clinic_app import assert_quiet, go
from playwright.sync_api import expect

from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.people import add_person, the_clinic

pytestmark = [pytest.mark.browser]

PLACE = {"floorplan": "apartment", "screen": "the-screen-of-the-tests"}


@pytest.fixture(scope="module")
def served(served):
    served.open_session("A-03")
    served.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
    return served


@pytest.fixture
def reviewer(browser, page_log, served):
    """Yield the page of a reviewer who is signed in."""
    with served.app.state.parts[Database].transaction() as db:
        cookie = sign_in(db, add_person(db, the_clinic(db), "Rita", "reviewer", None), "test")
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    context.add_cookies([{"name": "bodydrive_sign_in", "value": cookie, "url": served.address}])
    log = page_log(served.address)
    page = log.watch(context.new_page())
    yield page
    assert_quiet(log)
    context.close()


def drive(served):
    """Begin a trial; return its id."""
    path = served.good("GET", f"/floorplans/{PLACE['floorplan']}")["paths"][0]["name"]
    return served.good("POST", "/trials", {**PLACE, "path": path})["id"]


def end(served):
    served.good("POST", "/trials/current/end", {})


def test_the_list_and_the_page_of_a_trial_follow_it_to_its_end(reviewer, served):
    patient = served.patients["A-03"]
    reviewer.goto(f"{served.address}/#/review/{patient}")
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
