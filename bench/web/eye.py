"""Measures the pictures a second of the eye's view in Chromium, and those of a plainer scene."""

from contextlib import ExitStack
from typing import Final

from playwright.sync_api import Page, ViewportSize

from bench.children import next_line, started
from bench.row import Row
from bench.web.demonstration import chromium

RUNS: Final = 5
SECONDS: Final = 4.0
WINDOW: Final[ViewportSize] = {"width": 1280, "height": 800}
DRAWN, PLAIN = "drawn", "plain"
REACH: Final = 0.95  # of the plain scene's pictures
SETTLED: Final = 3000  # ms until the building has been sent and its programs are compiled
COUNT: Final = """(seconds) => new Promise((resolve) => {
  const since = performance.now();
  let pictures = 0;
  const count = () => {
    const time = performance.now() - since;
    if (time >= 1000 * seconds && pictures) return resolve((1000 * pictures) / time);
    pictures += 1;
    requestAnimationFrame(count);
  };
  requestAnimationFrame(count);
})"""


def measure_eye(runs: int = RUNS, seconds: float = SECONDS) -> list[Row]:
    """Return the pictures a second of both scenes, which take turns in one run, and their ratio.

    Raises
    ------
    RuntimeError
        When there is no Chromium, or a scene is not served.
    """
    rates: dict[str, list[float]] = {DRAWN: [], PLAIN: []}
    with ExitStack() as stack:
        served = {name: stack.enter_context(started("bench.processes.eye_served", name)) for name in rates}
        for process in served.values():
            stack.callback(process.kill)
        ports = {name: next_line(process) for name, process in served.items()}
        browser = stack.enter_context(chromium())
        for _ in range(runs):
            for name, port in ports.items():
                page = browser.new_page(viewport=WINDOW)
                rates[name].append(_pictures(page, port, seconds))
                page.close()
    ratios = [drawn / plain for drawn, plain in zip(rates[DRAWN], rates[PLAIN], strict=True)]
    times = f"{runs} runs of {seconds:g} s in turn, 1280 x 800, drawn by software where there is no graphics card"
    without = "the same plan with bare walls and floor under an open sky"
    return [
        Row(
            "pictures of the eye's view, to a plain scene's",
            ratios,
            "x",
            REACH,
            "higher",
            times,
        ),
        Row("pictures of the eye's view", rates[DRAWN], "pictures/s", None, "higher", times),
        Row("pictures of the eye's view, plain", rates[PLAIN], "pictures/s", None, "higher", without),
    ]


def _pictures(page: Page, port: str, seconds: float) -> float:
    page.goto(f"http://127.0.0.1:{port}/view/patient/")
    page.locator("canvas").first.wait_for()
    page.wait_for_timeout(SETTLED)
    return float(page.evaluate(COUNT, seconds))
