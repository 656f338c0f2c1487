"""Measures the memory of the web process after a session in Chromium: calibration, trial, replay and review."""

import psutil
from playwright.sync_api import Page, expect

from bench.row import Row
from bench.web.demonstration import chromium, demonstration

REACH = 260.0  # MB
LONGEST = 300_000.0  # ms: the whole calibration or the whole trial, on a slow machine
SIZE = {"width": 1024, "height": 768}


def measure_session() -> list[Row]:
    """Return the memory (MB) of the web process after a session, that of the computing process in words.

    Raises
    ------
    RuntimeError
        When there is no Chromium, or the demonstration does not start.
    """
    expect.set_options(timeout=LONGEST)
    with chromium() as browser, demonstration() as (demo, link):
        page = browser.new_page(viewport=SIZE)  # type: ignore[arg-type]
        page.set_default_timeout(LONGEST)
        page.goto(link)
        _spend_session(page, link.partition("#")[0])
        memory = {_name(process): process.memory_info().rss / 1e6 for process in _family(demo.pid)}
    words = ", ".join(f"{name} {size:.0f} MB" for name, size in memory.items() if name != "web")
    what = "memory of the web process after a calibration, a trial, its replay and the review"
    return [Row(what, [memory["web"]], "MB", REACH, "lower", f"shared parts included; beside it: {words}")]


def _spend_session(page: Page, address: str) -> None:
    """Calibrate, drive the first task to its goal, and look at it."""
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    page.goto(f"{address}#/calibrate")
    start = page.get_by_role("button", name="Start", exact=True)
    start.click()
    expect(page.get_by_role("heading", name="Ready to drive")).to_be_visible()  # with the calibration from before
    start.click()
    expect(page.get_by_text("When one gesture is made, what else moves")).to_be_visible()
    page.get_by_role("button", name="Use this calibration").click()
    expect(page.get_by_role("heading", name="Which movement does what")).to_be_visible()
    page.goto(f"{address}#/drive/task/corridors/straight")
    page.get_by_role("button", name="Start trial").click()
    goal, stopped = page.get_by_role("heading", name="Goal reached"), page.get_by_role("button", name="Continue")
    while not goal.is_visible():
        expect(goal.or_(stopped).first).to_be_visible()
        if stopped.is_visible():  # a machine that is busy may stop the chair
            stopped.click()
    page.goto(f"{address}#/review")
    expect(page.locator(".chart canvas").first).to_be_visible()
    page.goto(f"{address}#/review/1/trial/1")
    expect(page.locator("iframe").first).to_be_visible()


def _family(pid: int) -> list[psutil.Process]:
    web = psutil.Process(pid)
    return [web, *web.children()]


def _name(process: psutil.Process) -> str:
    """Return which process of the program this is, by its command."""
    command = " ".join(process.cmdline())
    names = {"app.computing_process": "computing process", "app.pipeline": "control process", "hashing": "hashing"}
    return next((name for part, name in names.items() if part in command), "web")
