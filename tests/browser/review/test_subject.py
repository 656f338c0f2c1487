"""Header and title name whose data a page shows, also where another patient's session is open."""

import re

import pytest
from playwright.sync_api import expect

from app.store.database import Database
from app.store.patients import add_patient, end_session, start_session
from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser]

SIZES = ((1280, 800), (768, 1024), (390, 844), (320, 640))
# The place shows all of its words, inside the header and beside whatever else is there.
IS_WHOLE = """(one) => {
  const box = one.getBoundingClientRect();
  const parts = [...one.children].map((part) => part.getBoundingClientRect());
  const head = one.closest("header").getBoundingClientRect();
  const others = [...one.closest("header").querySelectorAll(".lamp, .me, .tools, .stop, .brand, .practice")]
    .filter((other) => other.checkVisibility()).map((other) => other.getBoundingClientRect());
  const overlaps = (other) => parts.some((part) => part.left < other.right - 1 && other.left < part.right - 1
    && part.top < other.bottom - 1 && other.top < part.bottom - 1);
  return box.width > 0 && parts.every((part) => part.left >= 0 && part.right <= innerWidth + 0.5
    && part.top >= head.top - 0.5 && part.bottom <= head.bottom + 0.5)
    && !others.some((other) => other.width && overlaps(other));
}"""


@pytest.fixture
def other_session(app):
    """Open the session of another patient, who has a long code."""
    with app.app.state.parts[Database].transaction() as db:
        end_session(db)
        start_session(db, add_patient(db, "STUDY-2027-0042", "Otter", "").id, "Ada")


def assert_named(page, name, code, part):
    who = page.locator("header .who")
    expect(page).to_have_title(re.compile(f"^{code}, {part} · .* · bodydrive$"))
    for width, height in SIZES:
        page.set_viewport_size({"width": width, "height": height})
        expect(who.get_by_text(code, exact=True)).to_be_visible()
        expect(who.get_by_text(part, exact=True)).to_be_visible()
        page.screenshot(path=SCREENSHOTS / f"subject-{name}-{width}x{height}.png")
        assert who.evaluate(IS_WHOLE), (name, width)


def test_trial_comparison_review_and_record_name_patient_and_session(app, open_for, other_session):
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
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
    page = open_for("Ada", "owner", f"review/1/trial/{app.trials[0]}", (390, 844))
    assert_named(page, "open", "P-1", "session 1 open")
