"""The same verdict on the trial page, in review and in the comparison, in a real browser."""

import re

import pytest
from browser.sizes import each_size, keep
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

PLAIN = re.compile(r"^Better than noise over 28 trials in 4 sessions: the area off the path fell by about \d\.\d\d m²")
POINT = re.compile(r"trial \d+: \d\.\d\d m²")
NEAR_THE_TOP = 0.15  # of the height of a chart
TOO_WIDE = "document.querySelector('main').scrollWidth > document.querySelector('main').clientWidth"


def keep_each_size(page, name):
    for size in each_size(page, settle=0):
        page.wait_for_function(f"() => !({TOO_WIDE})")  # charts follow the new size
        keep(page, f"{size}-{name}")


def words_near_the_top(page):
    """Return what the first chart says of the first point that is near its upper edge."""
    chart = page.locator(".chart:has(canvas)").first
    chart.scroll_into_view_if_needed()
    frame, tip = chart.locator(".u-over").bounding_box(), chart.locator(".chart-tip")
    for across in range(0, int(frame["width"]), 15):
        page.mouse.move(frame["x"] + across, frame["y"] + NEAR_THE_TOP * frame["height"])
        if tip.is_visible():
            return tip.inner_text()
    raise AssertionError("no point is near the upper edge")


def opens_with_a_word(page, address):
    """Open Review: until its curve has come, it says that it waits."""
    waiting = []
    page.route("**/learning?*", lambda route: waiting.append(route))  # noqa: PLW0108 - Playwright sets an attribute of it
    page.goto(address)
    expect(page.locator("main .stack > [role=status]")).to_have_text("One moment…")
    while not waiting:
        page.wait_for_timeout(50)
    waiting[0].continue_()
    page.unroute("**/learning?*")


def test_a_change_has_one_word_on_every_page(course, open_page):
    page = open_page(course.link, allowed="404")  # these trials have no recordings
    ids, review = course.trials, f"{course.address}/#/review/1"
    expect(page.get_by_role("heading", level=1)).to_be_visible()

    page.goto(f"{review}/trial/{ids[-2]}")  # the last one that reached the goal; 1.0 m2 on that day as before
    area = page.locator(".large-figures section").filter(has=page.locator(".change")).first
    expect(area.locator(".change")).to_have_text("within noise")
    expect(page.get_by_text("No minimal detectable change has been published")).to_be_visible()
    keep_each_size(page, "verdict-trial")

    page.goto(f"{review}/trial/{ids[-1]}")  # 65 m2, and the goal was not reached
    expect(page.get_by_text("The goal was not reached")).to_be_visible()
    expect(page.locator(".large-figures")).to_have_count(0)
    unfinished = re.compile(r"\d\d\.\d\d m²|E_diff|Area off|Compared with")
    expect(page.locator("main")).not_to_contain_text(unfinished, use_inner_text=True)
    keep_each_size(page, "verdict-unfinished")

    page.goto(f"{review}/trial/{ids[1]}")
    expect(page.get_by_text("one of the first three trials")).to_be_visible()

    page.goto(f"{review}/compare/{ids[-2]}/{ids[-9]}")  # of two sessions, named in the wrong order
    row = page.locator("main tbody tr").first
    expect(row).to_contain_text("↓ better than noise")
    expect(page.locator("main tbody tr").filter(has_text="Mean speed")).to_contain_text("–")
    keep_each_size(page, "verdict-compare")

    opens_with_a_word(page, review)
    card = page.locator(".session-verdicts")
    expect(
        card.get_by_role(
            "heading", name=re.compile(r"^Session 4 \(.* 20\d\d, 7 trials\) against session 3 \(.* 20\d\d, 7 trials\)$")
        )
    ).to_be_visible()
    expect(card.locator("b.change.good").first).to_contain_text("better than noise")
    expect(page.locator(".trials tbody tr").filter(has_text="getting used to it")).to_have_count(3)
    expect(page.locator(".trials")).not_to_contain_text(re.compile(r"\d\d\.\d\d m²"))
    assert POINT.match(words_near_the_top(page))  # the 65 m2 that do not count take no room
    expect(card.locator("p").filter(has_text="Goal reached: 100 % → 88 %").first).to_contain_text("within noise")
    card.locator("summary").first.click()
    expect(card.locator("tbody tr").filter(has_text="Time").first).to_contain_text("within noise")
    keep_each_size(page, "verdict-review")
    card.get_by_role("link", name="Compare sessions").click()
    expect(page.get_by_role("link", name="Session 4").first).to_be_in_viewport()
    page.go_back()


def test_the_curve_is_said_in_plain_words_and_its_statistics_stand_in_closed_details(course, open_page):
    page = open_page(course.link)
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    page.goto(f"{course.address}/#/review/1")
    card = page.locator("section.card").filter(has=page.get_by_role("heading", name="Learning curve"))
    summary = card.get_by_text("Details: statistics, and which curve is drawn")
    choice, statistics = (
        card.get_by_role("radiogroup", name="Which curve is drawn"),
        card.get_by_text("medians of the first"),
    )
    for state in ("closed", "open"):
        if state == "open":
            summary.click()
        for size in each_size(page, settle=0):
            page.wait_for_function(f"() => !({TOO_WIDE})")
            expect(card.get_by_text(PLAIN)).to_be_visible()
            expect(choice).to_be_visible(visible=state == "open")
            expect(statistics).to_be_visible(visible=state == "open")
            summary.scroll_into_view_if_needed()
            keep(page, f"{size}-curve-{state}")
    drawn = card.locator(".chart")
    choice.get_by_text("Level line").click()
    expect(card.get_by_text("Level line: describes these trials less well than the best")).to_be_visible()
    expect(drawn.locator(".chart-legend")).to_contain_text("Learning curve")
