"""Comments on moments of a replay: written, marked on the time bar, listed, revised, withdrawn, read by others."""

import pytest
from browser.eyes.by_keyboard import focused, press, tab_to
from browser.sizes import fits
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

# Where the marks stand on the time bar, as shares of it.
MARKS = """() => [...document.querySelectorAll(".comment-marks i")].map((one) => {
  const bar = one.parentElement.getBoundingClientRect();
  const mark = one.getBoundingClientRect();
  return (mark.left + mark.width / 2 - bar.left) / bar.width;
})"""


def slider(page):
    return page.get_by_label("Moment of the trial")


def at(page):
    return float(slider(page).input_value())


def write(page, moment, words):
    """Write a comment at a moment (s) of the replay that is shown."""
    slider(page).fill(str(moment))
    page.get_by_role("button", name="Comment on this moment").click()
    page.get_by_label(f"Comment at {moment:.1f} s").fill(words)
    page.get_by_role("button", name="Add the comment").click()
    expect(page.locator(".comments")).to_contain_text(words)


def test_a_comment_of_a_reviewer_on_a_phone_reaches_the_clinician(app, open_for):
    first = app.trials[0]
    reviewer = open_for("Rhea", "reviewer", f"review/1/trial/{first}", "390x844")
    expect(reviewer.get_by_text("Nobody has commented on this trial.")).to_be_visible()
    clinician = open_for("Cleo", "clinician", "review/1")
    row = clinician.get_by_role("row").filter(has=clinician.get_by_role("link", name="Open trial 1"))
    expect(row).to_be_visible()
    expect(row).not_to_contain_text("unread")
    write(reviewer, 5.0, "Here the turn is late.")
    write(reviewer, 12.5, "The left shoulder tires.")
    start, end = (float(slider(reviewer).get_attribute(name)) for name in ("min", "max"))
    shares = [(moment - start) / (end - start) for moment in (5.0, 12.5)]
    assert reviewer.evaluate(MARKS) == pytest.approx(shares, abs=0.01)
    fits(reviewer, ".comments-card")
    # A tap on a phone leads to the moment, and to its picture.
    reviewer.get_by_role("button", name="Go to 5.0 s, the comment of Rhea").click()
    assert at(reviewer) == pytest.approx(5.0, abs=0.051)
    expect(reviewer.locator(".replay-picture")).to_be_in_viewport(ratio=0.9)
    # The clinician's open list of trials says so, and so does the list of sessions.
    expect(row).to_contain_text("2 unread comments")
    clinician.goto(f"{app.address}/#/session/patient/1")
    expect(clinician.locator(".person")).to_contain_text("2 unread comments")
    # Read when opened: a tap goes to the moment.
    clinician.goto(f"{app.address}/#/review/1/trial/{first}")
    comments = clinician.locator(".comments li")
    expect(comments).to_have_count(2)
    expect(comments.first).to_contain_text("New")
    clinician.get_by_role("button", name="Go to 12.5 s, the comment of Rhea").click()
    assert at(clinician) == pytest.approx(12.5, abs=0.051)
    expect(comments.nth(1)).to_have_class("is-here")
    expect(clinician.get_by_role("button", name="Revise or withdraw")).to_have_count(0)
    # One more comes while the trial is open.
    write(reviewer, 8.0, "Well turned.")
    expect(comments).to_have_count(3)
    clinician.goto(f"{app.address}/#/review/1")
    expect(row).to_be_visible()
    expect(row).not_to_contain_text("unread")


def test_by_keyboard_alone_a_comment_is_written_revised_and_withdrawn(app, open_for):
    page = open_for("Cleo", "clinician", f"review/1/trial/{app.trials[0]}")
    expect(slider(page)).to_be_visible()
    tab_to(page, "Moment of the trial")
    page.keyboard.press("Home")
    page.keyboard.press("Shift+ArrowRight")
    moment = at(page)
    words = f"{moment:.1f} s"
    tab_to(page, "Comment on this moment", key="Shift+Tab")
    page.keyboard.press("Enter")
    assert focused(page) == f"Comment at {words}"
    page.keyboard.type("p left, p right")  # writes, and plays nothing
    assert at(page) == moment
    press(page, "Add the comment")
    expect(page.locator(".toast")).to_contain_text("The comment was added.")
    assert focused(page) == "Comment on this moment"
    tab_to(page, f"Go to {words}", key="Shift+Tab")
    page.keyboard.press("Shift+ArrowRight")
    assert at(page) > moment
    page.keyboard.press("Enter")
    assert at(page) == pytest.approx(moment, abs=0.051)
    press(page, f"Revise or withdraw your comment at {words}")
    assert focused(page) == f"Comment at {words}"
    page.keyboard.press("Control+A")
    page.keyboard.type("Better so.")
    press(page, "Save the revision")
    expect(page.locator(".comments")).to_contain_text("Better so.")
    expect(page.locator(".comments")).to_contain_text("1 earlier text")
    assert focused(page) == f"Revise or withdraw your comment at {words}"
    page.keyboard.press("Enter")
    press(page, "Cancel")
    assert focused(page) == f"Revise or withdraw your comment at {words}"
    page.keyboard.press("Enter")
    press(page, "Withdraw")
    expect(page.get_by_text("Nobody has commented on this trial.")).to_be_visible()
    assert focused(page) == "Comments"
    assert page.evaluate(MARKS) == []


def test_without_its_recording_a_trial_still_shows_what_was_said(app, open_for):
    first = app.trials[0]
    page = open_for("Cleo", "clinician", f"review/1/trial/{first}")
    write(page, 5.0, "Here the turn is late.")
    page.route("**/timeline", lambda route: route.fulfill(status=404, json={"detail": "There is no recording."}))
    page.reload()
    expect(page.locator(".comments")).to_contain_text("Here the turn is late.")
    expect(page.get_by_text("The moments cannot be shown")).to_be_visible()
    expect(page.get_by_role("button", name="Go to")).to_have_count(0)
