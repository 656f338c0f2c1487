"""Nobody drives blind: what a browser does that cannot draw in 3D, or loses its picture while somebody drives (S24)."""

import re

import pytest
from browser.driving import (
    STOPS,
    WITHOUT_WEBGL,
    choose_task,
    clock_of,
    drives_for,
    end_trial,
    ends_by_hand,
    go_on_until,
    stops_because,
)
from browser.sizes import keep
from browser.tablets import pairing_link
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

LOOKS = {"light": "1280x800", "dark": "768x1024"}
FEW_PIXELS = "640x800"  # software draws few pixels of a 3D view faster
VIEW = "document.querySelector('.view iframe').contentWindow"
LOSE = f"""() => {{
  const view = {VIEW};
  const context = view.document.querySelector("canvas[data-engine]").getContext("webgl2");
  window.taken = context.getExtension("WEBGL_lose_context");
  window.taken.loseContext();
}}"""
SHOWS_VIEW = """document.querySelector(".view iframe")?.contentWindow.document.querySelector("canvas[data-engine]")
  && !document.querySelector(".drawn-plan")?.checkVisibility()"""
CHAIR = "document.querySelector('.drawn-plan .chair-outline').getAttribute('transform')"
SMALL = """[...document.querySelectorAll(".lower button, .lower .segments label, .fault-card .btn")]
  .filter((one) => one.checkVisibility())
  .filter((one) => Math.min(one.offsetHeight, one.offsetWidth) < 44).map((one) => one.outerHTML.slice(0, 80))"""


@pytest.fixture
def opened(demo, open_page):
    """Return what opens a page of its own browser context: with or without WebGL, signed in."""
    pages = []

    def open_address(address, scheme="light", *, webgl=True):
        script = "" if webgl else WITHOUT_WEBGL
        size = FEW_PIXELS if webgl else LOOKS[scheme]
        page = open_page(address, size, script=script, in_3d=True, color_scheme=scheme)
        page.keep = lambda name: keep(page, f"{scheme}-{name}")
        pages.append(page)
        return page

    yield open_address
    end_trial(pages[0], demo)


def choose_straight_ahead(page):
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    choose_task(page, "corridors", "straight")


def trials(page):
    """Return the trials of the patient by their ids."""
    base = page.url.split("#")[0]
    return {one["id"]: one for one in page.context.request.get(f"{base}api/v1/trials?patient=1").json()}


@pytest.mark.parametrize("scheme", ["light", pytest.param("dark", marks=pytest.mark.long)])
def test_without_webgl_a_trial_is_driven_and_replayed_in_the_drawn_plan(opened, demo, scheme):
    page = opened(demo, scheme, webgl=False)
    choose_straight_ahead(page)
    before_it = trials(page).keys()
    expect(page.get_by_text("This screen cannot draw the 3D view")).to_be_visible()
    page.keep("plan-choose")
    page.get_by_role("button", name="Start in the drawn plan").click()
    drives_for(page, 3)
    assert page.get_by_label("Plan", exact=True).is_checked()
    assert page.get_by_label("Eye", exact=True).is_disabled()
    before = page.evaluate(CHAIR)
    go_on_until(page, lambda: page.evaluate(CHAIR) != before, "a movement of the chair")
    page.keep("plan-drive")
    page.get_by_role("button", name="Heading up").click()
    page.get_by_role("button", name="Farther").click()
    page.keep("plan-drive-north")
    assert page.evaluate(f"() => {SMALL}") == []
    drives_for(page, 1)  # so that the chair has moved before the whole second that is replayed below
    moved_at = clock_of(page)
    ends_by_hand(page)

    # Somebody comes who wants the eye: nothing begins, and the plan is offered.
    page.evaluate("sessionStorage.setItem('bodydrive-view', 'eye')")
    page.get_by_role("button", name="Next trial").click()
    expect(page.get_by_text("No picture to drive by")).to_be_visible()
    expect(page.locator(".fault-card")).to_contain_text("no WebGL 2")
    page.wait_for_timeout(2000)
    (driven,) = trials(page).keys() - before_it
    assert trials(page)[driven]["status"] == "done"
    page.keep("plan-offer")
    page.get_by_role("button", name="Drive in the drawn plan").click()
    drives_for(page, 1)
    page.get_by_role("button", name="End trial").first.click()
    expect(page.get_by_role("link", name="Look at it again")).to_be_visible()

    page.goto(f"{demo.split('#')[0]}#/review/1/trial/{driven}")
    expect(page.get_by_text("so the replay is shown in the drawn plan")).to_be_visible()
    places = []
    for t in (1, moved_at):
        page.get_by_label("Moment of the trial").fill(str(t))
        places.append(page.evaluate(CHAIR))
    assert places[0] != places[1]
    page.keep("plan-replay")
    assert page.locator("iframe[src]").count() == 0


def test_a_context_that_is_lost_halts_the_trial_until_there_is_a_picture(opened, demo, until):
    page = opened(demo)
    choose_straight_ahead(page)
    page.get_by_role("button", name="Start trial").click()
    drives_for(page, 1)
    card = page.locator(".fault-card")

    def loses_picture():
        """Take the graphics away until that is what halts the trial; a busy machine may miss the page first."""
        for _ in range(STOPS):
            page.evaluate(LOSE)
            expect(card).to_contain_text("the browser has switched off the graphics")
            if "lost the picture" in card.inner_text():
                return
            page.evaluate("() => window.taken.restoreContext()")
            drives_for(page, 1)
        expect(card).to_contain_text("lost the picture")

    loses_picture()
    expect(page.get_by_role("button", name="Continue")).to_be_disabled()
    expect(page.locator(".bar .speed .big")).to_contain_text("0.00")
    page.keep("picture-lost")
    page.get_by_role("button", name="Show the drawn plan").click()
    page.get_by_role("button", name="Continue").click()
    drives_for(page, 1)

    # Back to the 3D view while driving: the plan stays until that view is there.
    page.get_by_text("Eye", exact=True).click()
    assert page.locator(".drawn-plan").is_visible()
    until(page, "!document.querySelector('.picture .drawn-plan').checkVisibility()", seconds=60)
    drives_for(page, 1)
    loses_picture()
    page.evaluate("() => window.taken.restoreContext()")
    page.get_by_role("button", name="Continue").click()
    drives_for(page, 1)
    page.keep("picture-back")

    # A picture that stands still, older than what even a slow page is allowed.
    page.evaluate(f"() => {{ {VIEW}.bodydriveView.age = () => 3.5; }}")
    expect(card).to_contain_text("draws too slowly")
    expect(page.get_by_role("button", name="Continue")).to_be_hidden()
    ends_by_hand(page)


def test_the_patients_screen_falls_back_on_the_drawn_plan_once_the_chair_stands(opened, demo, until):
    page = opened(demo, webgl=False)
    choose_straight_ahead(page)
    base = demo.split("/#")[0]
    patient = opened(pairing_link(page, demo), "dark")
    card = page.locator(".fault-card")

    def drives_with_the_view():
        """Drive until the patient's screen shows the view; a machine that is too busy may have taken it away."""
        for _ in range(STOPS):
            drives_for(page, 1)
            if not patient.locator(".drawn-plan").is_visible():
                return
            opens_anew()

    def opens_anew():
        patient.goto("about:blank")
        patient.goto(f"{base}/patient.html")
        until(patient, SHOWS_VIEW, seconds=60)

    def loses_picture(cause):
        stops_because(page, card, "lost the picture", cause, lambda: (opens_anew(), drives_with_the_view()))

    page.get_by_role("link", name="The patient's screen").click()
    expect(page.locator(".patient-screens .tag", has_text="3D view")).to_be_visible()
    page.get_by_role("link", name="Back to the task").click()
    page.get_by_role("button", name="Start in the drawn plan").click()
    drives_with_the_view()
    loses_picture(lambda: patient.evaluate(LOSE))
    expect(patient.locator(".drawn-plan")).to_be_visible()
    expect(patient.locator(".band.stopped")).to_contain_text("The picture was lost")
    page.get_by_role("button", name="Continue").click()
    drives_for(page, 2)
    before = patient.evaluate(f"() => {CHAIR}")
    go_on_until(page, lambda: patient.evaluate(f"() => {CHAIR}") != before, "the chair in the patient's plan")
    patient.keep("patient-plan")
    # A screen that is gone halts the chair. Both pages share one browser, which may hold up the driving page while it
    # puts the other one away; test_screen_pictures.py says which reason is given.
    patient.goto("about:blank")
    expect(page.get_by_role("button", name="Continue")).to_be_visible()
    expect(card).to_contain_text(re.compile("lost the picture|sent nothing"))
    page.wait_for_timeout(1500)  # Continue takes no tap that was meant for what stood there before
    page.get_by_role("button", name="Continue").click()
    expect(page.get_by_text("which this trial uses, is out of reach")).to_be_visible()
    patient.goto(f"{base}/patient.html")
    expect(page.locator(".head .screen-lamp")).to_have_text("Patient’s screen")
    drives_for(page, 1)
