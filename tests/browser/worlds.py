"""A task chosen on the Drive page and driven by the simulated person, seen in a real browser."""

from browser.driving import choose_task, reaches_the_goal
from playwright.sync_api import expect

from app.world.scene import bundled_places


def tasks(level="easy"):
    """Return every task of every scene at one level, as (floor plan, path)."""
    found = []
    for name, (plan, scene, at) in bundled_places().items():
        if scene is not None and (at is None or at.name == level):
            found += [(name, path) for path in plan.paths]
    return found


def open_drive_page(browser, log, link, size=(1024, 768)):
    """Return a signed-in page that shows where one can drive."""
    page = browser.new_page(in_3d=True, viewport={"width": size[0], "height": size[1]}, has_touch=True)
    log.watch(page)
    page.goto(link)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    return page


def drive(page, floorplan, path, meanwhile=None):
    """Choose the task, start it, and wait until its page says that the goal was reached; return the measures' text.

    `meanwhile` is done once, while it is driven.
    """
    page.goto(page.url.split("#")[0] + "#/drive")
    choose_task(page, floorplan, path.name)
    page.get_by_role("button", name="Start trial").click()
    if meanwhile is not None:
        page.locator(".view-bar").wait_for()
        meanwhile()
    reaches_the_goal(page, within=int(path.time_limit) + 60)
    return "\n".join(page.locator("table.measures").all_inner_texts())
