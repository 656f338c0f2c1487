"""Driving as a person does: bend the elbow until it goes, and tap Continue when a busy machine held the chair up."""

import re
from contextlib import suppress

from browser.tablets import send
from playwright.sync_api import Error, expect

from app.world.scene import bundled_places
from app.world.task_groups import TaskGroup, group_of

STOPS = 5  # on a machine so busy that the driving page itself is late
LOOK_EVERY = 250  # ms
BEND = 700  # ms there, and the same back: the movement is what drives
HIDE = """() => {
  Object.defineProperty(document, "visibilityState", { configurable: true, get: () => "hidden" });
  document.dispatchEvent(new Event("visibilitychange"));
}"""
SHOW = """() => {
  delete document.visibilityState;
  document.dispatchEvent(new Event("visibilitychange"));
}"""

WITHOUT_WEBGL = """{
  const get = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    return kind.startsWith("webgl") ? null : get.call(this, kind, ...more);
  };
}"""

GROUPS: dict[TaskGroup, str] = {
    "first": "First steps",
    "corridors": "Corridors",
    "doors": "Doors",
    "obstacles": "Obstacles",
    "following": "Following",
    "outdoors": "Outdoors",
}


def drive_by_plan(page):
    """Begin the next trial of this page with the drawn plan, as one does who chose it before."""
    page.evaluate("() => sessionStorage.setItem('bodydrive-view', 'plan')")


def end_trial(page, link):
    """End the trial that runs in a demonstration, if one does, so that the next test begins without one."""
    ended = send(page, link, "POST", "/trials/current/end", {"reason": "by hand"})
    assert ended.ok or ended.status in {409, 503}, ended.text()  # there is none, or it is still being measured


def choose_task(page, floorplan, path):
    """Choose a task of a bundled place as a person does: Choose another, its group, its level, the task."""
    place = bundled_places()[floorplan]
    title = place.plan.path_named(path).title
    page.get_by_role("link", name="Choose another").click()
    page.get_by_role("button", name=GROUPS[group_of(place)], exact=True).click()
    scene = place.plan.title if place.scene is None else place.scene.title
    card = page.locator(".plan-card").filter(has=page.get_by_role("heading", name=re.compile(f"^{scene}")))
    if place.level is not None:
        card.get_by_text(place.level.title, exact=True).click()
    card.get_by_role("link", name=title).click()
    expect(page.locator(".task-card h2")).to_have_text(title)


def clock_of(page):
    """Return the seconds on the trial's clock; 0 while it shows none."""
    minutes, _, seconds = page.locator(".place .big").inner_text().partition(":")
    return 60 * int(minutes) + int(seconds) if seconds else 0


def drives_until(page, seconds, *, within=60):
    """Wait until so many seconds stand on the trial's clock, within so many real ones."""
    expect(page.locator(".place .big")).to_be_visible()
    go_on_until(page, lambda: clock_of(page) >= seconds, f"{seconds} s on the trial's clock", seconds=within)


def drives_for(page, seconds):
    """Wait until the trial's clock shows so many seconds more."""
    drives_until(page, clock_of(page) + seconds)


def reaches_the_goal(page, *, within=150):
    goal = page.get_by_role("heading", name="Goal reached")
    go_on_until(page, goal.is_visible, "the goal", seconds=within)


def ends_by_hand(page):
    page.get_by_role("button", name="End trial").first.click()
    expect(page.get_by_role("heading", name="Ended by hand")).to_be_visible()


def speed_in(text):
    """Return the speed (m/s) at the beginning of what a page shows of it."""
    return float(re.match(r"[\d.]+", text)[0])


def go_on_until(page, reached, what, *, seconds=60):
    """Wait until `reached`; a machine that is too busy may stop the chair, and then Continue goes on."""
    # Not one that was just pressed: to press that, one would wait until it comes again.
    go_on = page.get_by_role("button", name="Continue", disabled=False)
    for _ in range(seconds * 1000 // LOOK_EVERY):
        if reached():
            return
        if go_on.is_visible():
            with suppress(Error):  # it went by itself
                go_on.click(timeout=2000)
        page.wait_for_timeout(LOOK_EVERY)
    raise AssertionError(f"{what} did not come: {page.locator('main').inner_text()[:500]}")


def stops_because(page, card, words, cause, again):
    """Let `cause` stop the chair, until the card gives the reason in `words`.

    A machine that is too busy may miss the driving page first: then `again` makes it ready to be stopped once more.
    """
    for _ in range(STOPS):
        cause()
        expect(page.get_by_role("button", name="Continue")).to_be_visible()
        if words in card.inner_text():
            return
        again()
    expect(card).to_contain_text(words)


def bend_until(page, speed, least, bend=None):
    """Bend the right elbow again and again, until the speed on the page was at least that (m/s).

    `bend` takes the elbow's share; without it the keys move the body in the simulated shirt.
    """
    bend = bend or (lambda share: (page.keyboard.down if share else page.keyboard.up)("ArrowUp"))

    def is_fast():
        bend(1.0)
        page.wait_for_timeout(BEND)
        fast = speed_in(speed.inner_text()) >= least
        bend(0.0)
        if not fast:
            page.wait_for_timeout(BEND)
        return fast

    go_on_until(page, is_fast, f"a speed of {least} m/s")
