"""What a screen reader says of a real chair and on the patient's screen: each state once, Stop at once."""

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back
from browser.eyes.spoken import LISTEN, said_after, with_words
from browser.eyes.states.live_places import DRIVE, TRIAL
from playwright.sync_api import expect

from app.faults import Fault, State

pytestmark = [pytest.mark.browser]


@pytest.fixture(autouse=True)
def put_back_afterwards(page, clinic):
    look_as(page, ("1280x800", "light"))
    yield
    put_back(clinic)


def after(page, change, words=""):
    """Return what was said after a change; on a busy machine a message may come late, which is said, too."""
    return [row for row in said_after(page, change, words) if "No connection" not in row[1]]


def go_on(clinic):
    """Take a stop back while a trial or drive is under way."""
    clinic.clear()
    clinic.process.state = State.ARMED


def test_each_state_of_a_real_chair_is_said_once(page, clinic):
    PLACES["chair, checking"](page, clinic)
    page.evaluate(LISTEN)
    assert after(page, lambda: None) == []  # nothing has happened, though figures change twenty times a second
    process = clinic.process
    rows = after(page, lambda: setattr(process, "state", State.ARMED), "Driving")
    assert with_words(rows, "Driving") == ["polite"], rows
    rows = after(page, lambda: clinic.fault(Fault.CHAIR_SILENT), "The chair no longer answers")
    assert with_words(rows, "The chair no longer answers") == ["polite"], rows
    clinic.shown["drive"] = {**DRIVE, "waits": 200.0}
    assert after(page, lambda: None) == []  # the time that is left is for the eye
    after(page, lambda: go_on(clinic))
    rows = after(page, lambda: clinic.fault(Fault.STOP_TABLET), "Stop was pressed")
    assert with_words(rows, "Stop was pressed") == ["assertive"], rows
    assert {live for live, _ in rows} == {"assertive"}, rows


def test_each_state_is_said_once_on_the_patients_screen(page, clinic):
    PLACES["patient's screen"](page, clinic)
    clinic.shown_to_patient |= {"trial": TRIAL, "drives": True}
    page.evaluate(LISTEN)
    after(page, lambda: None)
    process = clinic.process
    rows = after(page, lambda: setattr(process, "state", State.CHECKING), "Rest")
    assert with_words(rows, "Rest") == ["polite"], rows
    rows = after(page, lambda: setattr(process, "state", State.ARMED), "Go")
    assert with_words(rows, "Go") == ["polite"], rows
    assert after(page, lambda: None) == []
    rows = after(page, lambda: clinic.fault(Fault.SHIRT_SILENT), "The shirt sent nothing any more.")
    assert with_words(rows, "The shirt sent nothing any more.") == ["polite"], rows
    after(page, lambda: go_on(clinic))
    expect(page.locator(".band.stopped")).to_have_count(0)
    for _ in range(2):  # each press is said, also the second one
        rows = after(page, lambda: clinic.fault(Fault.STOP_TABLET), "Stop was pressed")
        assert with_words(rows, "Stop was pressed") == ["assertive"], rows
        assert len(rows) == 1, rows
        after(page, lambda: go_on(clinic))
    over = {"over": {"id": 7, "end": "goal"}, "trial": None, "drives": False}
    rows = after(page, lambda: clinic.shown_to_patient.update(over), "Goal")
    assert with_words(rows, "Goal") == ["polite"], rows
