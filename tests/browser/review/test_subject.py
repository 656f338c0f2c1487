"""Header and title name whose data a page shows, also where another patient's session is open."""

import re

import pytest
from browser.script import script
from browser.sizes import SIZES, each_size, keep
from playwright.sync_api import expect

from app.store.database import Database
from app.store.patients import add_patient, end_session, start_session

pytestmark = [pytest.mark.browser]

# The place shows all of its words, inside the header and beside whatever else is there.
IS_WHOLE = script("is_whole")


@pytest.fixture
def other_session(app):
    """Open the session of another patient, who has a long code."""
    with app.app.state.parts[Database].transaction() as db:
        end_session(db)
        start_session(db, add_patient(db, "STUDY-2027-0042", "Otter", "").id, "Ada")


def assert_named(page, name, code, part):
    who = page.locator("header .who")
    expect(page).to_have_title(re.compile(f"^{code}, {part} · .* · bodydrive$"))
    for size in each_size(page, (*SIZES, "320x640"), settle=0):
        expect(who.get_by_text(code, exact=True)).to_be_visible()
        expect(who.get_by_text(part, exact=True)).to_be_visible()
        keep(page, f"subject-{name}-{size}")
        assert who.evaluate(IS_WHOLE), (name, size)


def test_trial_comparison_review_and_record_name_patient_and_session(app, open_for, other_session):
    first, second = app.trials
    page = open_for("Ada Lovelace", "owner", f"review/1/trial/{first}")
    assert_named(page, "trial", "P-1", "session 1 shown")
    for where, part in (
        (f"review/1/compare/{first}/{second}", "session 1 shown"),
        ("review/1", "shown"),
        ("session/1", "session 1 shown"),
        ("session/story/1", "session 1 shown"),
    ):
        page.goto(f"{app.address}/#/{where}")
        assert_named(page, where.replace("/", "-"), "P-1", part)
    page.goto(f"{app.address}/#/patients")
    expect(page).to_have_title("Patients · bodydrive")
    expect(page.locator("header .who")).to_have_text("STUDY-2027-0042 session 1 open")
    page.goto(f"{app.address}/#/calibrate")
    assert_named(page, "calibrate", "STUDY-2027-0042", "session 1 open")


def test_a_page_of_the_open_session_says_so(app, open_for):
    page = open_for("Ada", "owner", f"review/1/trial/{app.trials[0]}", "390x844")
    assert_named(page, "open", "P-1", "session 1 open")
