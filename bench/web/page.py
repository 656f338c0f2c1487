"""Measures how soon a page can be used in Chromium: the page's first load, its reload, and both with a slow network."""

import statistics
from collections.abc import Sequence
from typing import Any

from playwright.sync_api import BrowserContext, CDPSession, Page

from bench.row import Row
from bench.web.demonstration import chromium, demonstration

RUNS = 5
FIRST, RELOAD = "first page", "reload"
REACH = {FIRST: 1600.0, RELOAD: 800.0}  # ms
REACH_DRAWN = 300.0  # ms: until the page says that it is starting
SLOW = 60.0  # ms of latency, as between two buildings
BUTTON = ".foot .btn.go"  # Start trial: the main button of a demonstration's first page
WATCH = f"""new MutationObserver((_, watch) => {{
  if (!document.querySelector("{BUTTON}:enabled")) return;
  window.usable = performance.now();
  watch.disconnect();
}}).observe(document, {{ childList: true, subtree: true }})"""
FIGURES = """() => {
  const files = performance.getEntriesByType("resource");
  const [drawn] = performance.getEntriesByName("first-contentful-paint");
  return [window.usable, drawn?.startTime ?? NaN, files.length, files.reduce((sum, one) => sum + one.transferSize, 0)];
}"""


def measure_page(runs: int = RUNS) -> list[Row]:
    """Return the times (ms) from the address to the first words and to a main button that can be pressed.

    Each is the median of `runs`. A browser that has only just been started needs some 300 ms more for its first picture
    of any page, and one of the runs has it.

    Raises
    ------
    RuntimeError
        When there is no Chromium, or the demonstration does not start.
    """
    with chromium() as browser, demonstration() as (_, link):
        return [row for latency in (0.0, SLOW) for row in _rows(browser.new_context, link, latency, runs)]


def _rows(new_context: Any, link: str, latency: float, runs: int) -> list[Row]:
    figures: dict[str, list[list[float]]] = {FIRST: [], RELOAD: []}
    for _ in range(runs):
        context: BrowserContext = new_context(viewport={"width": 1280, "height": 800})
        context.add_init_script(WATCH)
        page = context.new_page()
        _delay(context.new_cdp_session(page), latency)
        page.goto(link)
        figures[FIRST].append(_usable(page))
        page.reload()
        figures[RELOAD].append(_usable(page))
        context.close()
    return [row for what, loads in figures.items() for row in _load_rows(what, loads, latency)]


def _delay(session: CDPSession, latency: float) -> None:
    session.send("Network.enable")
    everything = {"offline": False, "downloadThroughput": -1, "uploadThroughput": -1}
    session.send("Network.emulateNetworkConditions", {**everything, "latency": latency})


def _usable(page: Page) -> list[float]:
    """Return when the main button and the first content were there (ms), the number of requests, and their bytes."""
    page.locator(BUTTON).wait_for()
    return [float(figure) for figure in page.evaluate(FIGURES)]


def _load_rows(what: str, loads: Sequence[Sequence[float]], latency: float) -> list[Row]:
    usable, drawn, files, size = (sorted(column) for column in zip(*loads, strict=True))
    named = f"{what}, {latency:.0f} ms of latency" if latency else what
    runs = f"{len(loads)} runs"
    sent = f"{statistics.median(files):.0f} requests, {statistics.median(size) / 1000:.0f} kB"
    return [
        Row(f"{named}: first words", drawn, "ms", None if latency else REACH_DRAWN, "lower", runs),
        Row(named, usable, "ms", None if latency else REACH[what], "lower", f"{runs}; {sent}"),
    ]
