"""Review pages that are open while a trial begins and ends elsewhere, in a real browser of a reviewer."""

import pytest
from browser.served.clinic_app import go
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

PLACE = {"floorplan": "apartment", "screen": "the-screen-of-the-tests"}


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
