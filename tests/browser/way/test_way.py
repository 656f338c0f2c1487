"""Finding one's way: the first screen, the taps to a drive, the sentences for a first time, the help of each page.

Each of the four sentences leads where it says, with the words that it uses, in few taps: before they are put away.
"""

import pytest
from browser.driving import choose_task, drives_until
from browser.tablets import go_to
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

MOST_UNCALIBRATED = 3  # taps from the card of a patient who was never calibrated until the chair may drive
MOST_NEW, MOST_KNOWN = 8, 3  # taps, from sign-in and from the patient's card until the chair may drive
CALIBRATION = 240_000  # ms
COUNT = """window.taps ??= 0;
document.addEventListener("click", (event) => { if (event.isTrusted && event.detail > 0) window.taps += 1; }, true)"""
# Taps "Delete" as soon as it stands where "End session" was, as a hasty second tap does on a machine of any speed.
SECOND_TAP = """() => new MutationObserver((_, observer) => {
  const button = document.querySelector("[aria-label='Delete DEMO-1']");
  if (!button) return;
  observer.disconnect();
  button.click();
  window.secondTap = true;
}).observe(document.body, { childList: true, subtree: true })"""
ONE_LINE = 60  # px
TABLET_WIDTH = 768  # px, from which a step fits the screen
JOINTS = [f"{side} {part}" for part in ("shoulder", "elbow", "wrist") for side in ("Right", "Left")]
STEPS = ["Rest", "Move freely", *JOINTS, "Result"]
# How many names of steps can be seen, and how many of them are cut off or wider than their place.
CUT_NAMES = """() => {
  const names = [...document.querySelectorAll(".steps small")].filter((one) => one.checkVisibility());
  const cut = names.filter((one) => {
    const [name, place] = [one.getBoundingClientRect(), one.closest("li").getBoundingClientRect()];
    if (one.scrollWidth > place.width + 1) return true;
    return name.left < 0 || name.right > innerWidth || name.bottom > place.bottom + 1;
  });
  return [names.length, cut.length];
}"""
WHOLE = "(all) => all.length > 0 && all.every((one) => one.scrollWidth <= one.clientWidth)"
FITS = "() => { const page = document.querySelector('main'); return page.scrollHeight <= page.clientHeight; }"


@pytest.fixture
def open_at(open_page):
    """Return what opens a link on a tablet, with the sentences on it, and follows the number of one of them."""

    def follow(link, number):
        page = open_page(link, has_touch=True)
        expect(page.locator(".first-sentences")).to_be_visible()
        page.locator(f'.rail a[data-first="{number}"]:visible').tap()
        return page

    return follow


def test_stop_is_in_view_with_its_number_and_one_tap_stops(demo, open_page):
    page = open_page(demo, has_touch=True)
    expect(page.locator(".first-sentences li").first).to_contain_text("STOP, on every page")
    stop = page.get_by_role("button", name="Stop the chair now")
    expect(stop).to_be_in_viewport(ratio=1)
    stop.tap()
    expect(page.get_by_role("button", name="Take the stop back")).to_be_visible()
    page.get_by_role("button", name="Take the stop back").tap()
    expect(page.get_by_role("button", name="Take the stop back")).to_have_count(0)


def test_one_joint_is_repeated_from_the_row_of_steps(demo, open_at):
    page = open_at(demo, 2)
    page.get_by_role("list", name="The steps of the calibration").get_by_role("button", name="right elbow").tap()
    expect(page.get_by_role("heading", name="Bend your right elbow")).to_be_visible()
    expect(page.get_by_role("button", name="Start", exact=True)).to_be_in_viewport(ratio=1)


def test_turning_becomes_slower_and_undo_takes_it_back(demo, open_at):
    page = open_at(demo, 3)
    speed = page.get_by_role("group", name="Turn speed", exact=True)
    expect(speed).to_be_visible()
    before = speed.locator("output").inner_text()
    speed.get_by_role("button", name="Turn speed −").tap()
    expect(speed.locator("output")).not_to_have_text(before)
    page.get_by_role("button", name="Undo").tap()
    expect(speed.locator("output")).to_have_text(before)


def test_whether_last_week_was_better_is_read_without_scrolling(course, open_at):
    page = open_at(course.link, 4)
    page.get_by_label("Patient").select_option(label="P-1 Heron")
    expect(page.get_by_role("heading", name="Better, or noise?")).to_be_in_viewport(ratio=1)
    expect(page.get_by_text("m² better than noise").first).to_be_in_viewport(ratio=1)


@pytest.fixture
def opened(demo, open_page):
    """Return what opens the demonstration on a tablet of its own."""

    def open_demo():
        page = open_page(demo)
        expect(page.locator("main h1")).to_be_visible()
        return page

    return open_demo


def ends(page):
    page.get_by_role("button", name="End trial").first.click()
    expect(page.get_by_role("link", name="Another task")).to_be_visible()


def test_the_sentences_of_a_first_time_come_until_they_are_put_away(opened):
    page = opened()
    first = page.get_by_role("region", name="Four things, the first time")
    expect(first.get_by_role("listitem")).to_have_count(4)
    for words in ("STOP", "repeat one joint", "turning slower", "last week was better"):
        expect(first).to_contain_text(words)
    go_to(page, "review")
    opener = first.get_by_role("button", name="Four things, the first time")
    expect(opener).to_be_visible()
    assert first.bounding_box()["height"] <= ONE_LINE
    opener.click()
    expect(first.get_by_role("listitem")).to_have_count(4)
    expect(page.locator(".app.first-time")).to_have_count(1)
    go_to(page, "calibrate")
    expect(first.get_by_role("listitem")).to_have_count(0)
    opener.click()
    expect(first.get_by_role("listitem")).to_have_count(4)
    expect(page.locator(".app.first-time")).to_have_count(0)  # its numbers would stand beside those of the steps
    first.get_by_role("button", name="Got it").click()
    expect(first).to_have_count(0)
    expect(page.locator("h1")).to_be_focused()
    again = opened()
    expect(again.get_by_role("heading", name="Where to?")).to_be_visible()
    expect(again.locator(".first-sentences")).to_have_count(0)


def test_each_step_has_its_name_and_one_joint_of_an_earlier_session_is_not_promised(opened):
    page = opened()
    go_to(page, "calibrate")
    steps = page.get_by_role("list", name="The steps of the calibration")
    expect(steps.locator("small")).to_have_text(STEPS)
    steps.get_by_role("button", name="Left elbow: not done yet").click()
    expect(page.get_by_role("heading", name="Bend your left elbow")).to_be_visible()
    expect(page.get_by_text("One joint of it cannot be repeated alone")).to_be_visible()
    page.get_by_role("button", name="Stop the chair now").click()
    expect(page.get_by_role("button", name="Take the stop back")).to_be_visible()  # a notice above the page
    for width, height, names in ((1024, 768, 9), (768, 1024, 9), (512, 384, 1), (390, 844, 1)):
        page.set_viewport_size({"width": width, "height": height})
        assert page.evaluate(CUT_NAMES) == [names, 0], width
        if width >= TABLET_WIDTH:
            trace, foot = (page.locator(one).bounding_box() for one in (".step-body .trace", ".foot"))
            assert trace["y"] + trace["height"] <= foot["y"], (width, height)
    page.set_viewport_size({"width": 768, "height": 1024})
    page.get_by_role("button", name="Take the stop back").click()


def test_the_drive_page_fits_on_the_first_screen_and_leads_to_all_else(opened):
    page = opened()
    expect(page.locator(".task-card svg")).to_be_visible()
    away = page.get_by_role("button", name="Got it")
    if away.count():
        away.click()
    assert page.evaluate(FITS)
    assert page.locator(".lamps .lamp:visible").evaluate_all(WHOLE)
    expect(page.get_by_role("button", name="Start trial")).to_be_in_viewport(ratio=1)
    for link, heading in (("Chair", "Chair"), ("The patient's screen", "The patient's screen")):
        page.get_by_role("navigation", name="What else").get_by_role("link", name=link).click()
        expect(page.get_by_role("heading", level=1, name=heading)).to_be_focused()
        page.get_by_role("link", name="Back to the task").click()
    choose_task(page, "door.hard", "aside")
    page.reload()
    expect(page.locator(".task-card")).to_contain_text("A door · Hard")
    page.get_by_role("link", name="Choose another").click()
    page.get_by_role("button", name="Own plans").click()
    expect(page.get_by_role("link", name="Draw or import a floor plan")).to_be_visible()
    page.get_by_role("button", name="Doors", exact=True).click()
    expect(page.get_by_role("link", name="Round the corner and through")).to_have_attribute("aria-current", "true")


def test_a_question_mark_says_what_the_page_is_for_and_gives_the_focus_back(opened):
    page = opened()
    question = page.get_by_role("button", name="What is this page for?")
    panel = page.locator(".page-help")
    for place in ("drive", "drive/screen", "controls"):
        go_to(page, place)
        expect(page.locator("h1")).to_be_focused()
        question.focus()
        page.keyboard.press("Enter")
        expect(panel.get_by_role("heading")).to_be_focused()
        expect(panel.locator("p")).to_have_count(4)  # three sentences, and the way to the page for clinicians
        expect(panel.get_by_role("link")).to_have_count(1)
        page.keyboard.press("Escape")
        expect(panel).to_have_count(0)
        expect(question).to_be_focused()
    question.click()
    expect(panel).to_be_visible()
    go_to(page, "review")
    expect(panel).to_have_count(0)


def test_a_known_patient_drives_after_few_taps(opened):
    page = opened()
    go_to(page, "patients")
    page.evaluate(SECOND_TAP)
    page.get_by_role("button", name="End session").click()
    start = page.get_by_role("listitem").filter(has_text="DEMO-1").get_by_role("button", name="Start session")
    expect(start).to_be_visible()
    assert page.evaluate("window.secondTap")
    page.evaluate(COUNT)
    start.click()
    page.get_by_role("button", name="Start trial").click()
    taps = page.evaluate("window.taps")
    drives_until(page, 1)
    ends(page)
    assert taps <= MOST_KNOWN


def test_somebody_never_calibrated_drives_after_three_taps(opened):
    page = opened()
    go_to(page, "patients")
    page.get_by_role("button", name="End session").click()
    start = page.get_by_role("listitem").filter(has_text="DEMO-2").get_by_role("button", name="Start session")
    expect(start).to_be_visible()
    page.evaluate(COUNT)
    start.click()
    page.get_by_role("button", name="Start", exact=True).click()  # rest, then ten seconds of free movement
    page.get_by_role("button", name="Drive now").click(timeout=CALIBRATION)
    taps = page.evaluate("window.taps")
    drives_until(page, 1)
    ends(page)
    assert taps <= MOST_UNCALIBRATED
    go_to(page, "calibrate")  # where the map of each joint comes from, with a way on
    expect(page.get_by_text("From other people", exact=True).first).to_be_visible()
    expect(page.get_by_role("button", name="Drive now")).to_be_visible()


@pytest.mark.long
def test_a_new_patient_drives_after_few_taps(opened):
    """The demonstration is signed in by its link: the tap on Patients stands for the one on Sign in."""
    page = opened()
    go_to(page, "patients")
    page.get_by_role("button", name="End session").click()
    expect(page.get_by_role("button", name="End session")).to_have_count(0)
    go_to(page, "shirt")
    page.evaluate(COUNT)
    page.get_by_role("link", name="Patients").first.click()
    page.get_by_role("button", name="New patient").click()
    page.keyboard.type("P-900")
    page.keyboard.press("Tab")
    page.keyboard.type("Wren")
    page.get_by_role("button", name="Add and start the session").click()
    page.get_by_role("button", name="Start", exact=True).click()
    expect(page.get_by_role("button", name="Drive now")).to_be_visible(timeout=CALIBRATION)
    page.get_by_role("button", name="Start", exact=True).click()
    page.get_by_role("button", name="Use this calibration").click(timeout=CALIBRATION)
    page.get_by_role("link", name="Drive with these").click()
    page.get_by_role("button", name="Start trial").click()
    taps = page.evaluate("window.taps")
    drives_until(page, 1)
    assert page.get_by_text("P-900").first.is_visible()
    ends(page)
    assert taps <= MOST_NEW
