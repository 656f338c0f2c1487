"""How old is the pose that real browsers draw, and how many pictures do they make, with 1, 4 and 8 of them?

Each is a page of its own in one Chromium, and looks at the demonstration's clinician's view. Their own drawing shares
this machine with the server: without a graphics card, that is what the figures say most about.
"""

import shutil
import statistics
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from browser.conftest import CHROMIUM
from playwright.sync_api import Page, ViewportSize, sync_playwright
from processes.served_demo import Demo

VIEWERS = (1, 4, 8)
SIZE: ViewportSize = {"width": 640, "height": 400}
SETTLE = 10_000  # ms until a new page draws as fast as it will
LOOKS = 100
EVERY = 100  # ms

COUNT = """() => {
  window.pictures = 0;
  const next = () => { window.pictures += 1; requestAnimationFrame(next); };
  next();
}"""
LOOK = "() => [window.bodydriveView.lag(), window.pictures, performance.now() / 1000]"


class Drawn(NamedTuple):
    """What pages drew that looked at the same time."""

    viewers: int
    pictures: float  # a second, of the page that made the fewest
    age_p50: float  # s, of the drawn pose
    age_p99: float  # s


def drawn() -> Iterator[Drawn]:
    """Open more and more pages, and measure them together."""
    with Demo.running() as demo, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=list(CHROMIUM))
        context = browser.new_context(viewport=SIZE)
        context.add_cookies([{"name": n, "value": v, "url": demo.base} for n, v in demo.client.cookies.items()])
        pages: list[Page] = []
        for viewers in VIEWERS:
            while len(pages) < viewers:
                pages.append(context.new_page())
                pages[-1].goto(f"{demo.base}/view/clinician/")
                pages[-1].wait_for_function("window.bodydriveView?.lag() >= 0", timeout=120_000)
                pages[-1].evaluate(COUNT)
            yield _measured(pages)
        browser.close()


def _measured(pages: list[Page]) -> Drawn:
    pages[0].wait_for_timeout(SETTLE)
    began = [page.evaluate(LOOK) for page in pages]
    ages = []
    for _ in range(LOOKS):
        pages[0].wait_for_timeout(EVERY)
        ages += [page.evaluate(LOOK)[0] for page in pages]
    ended = [page.evaluate(LOOK) for page in pages]
    rates = [(after[1] - before[1]) / (after[2] - before[2]) for before, after in zip(began, ended, strict=True)]
    return Drawn(len(pages), min(rates), statistics.median(ages), float(np.percentile(ages, 99)))
