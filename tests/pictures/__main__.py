"""`python -m pictures`: takes the pictures of docs/pictures anew, of a demonstration in Chromium.

`make page PAGE=pictures` runs it.

`python -m pictures drive-now` takes only the one of "Drive now", and prints how many seconds that way takes;
`python -m pictures trial` only those of a trial. A trial that a busy machine halts in a picture is driven once more.
The simulated person drives. What is shown is the program as it is: nothing is drawn by hand.
"""

import io
import shutil
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise

from browser.conftest import CHROMIUM, PATIENCE
from browser.driving import choose_task, drives_until, ends_by_hand, reaches_the_goal
from browser.tablets import go_to
from PIL import Image
from playwright.sync_api import Page, ViewportSize, expect, sync_playwright
from processes.served_demo import running_demo

from folders import ROOT

PICTURES = ROOT / "docs" / "pictures"
TABLET: ViewportSize = {"width": 1024, "height": 768}
MOVING = (640, 480)
PAUSE = 250  # ms between two pictures: a page that is photographed all the time is too slow to drive by
SECONDS = 14.0  # of the moving picture
ALL_TOGETHER = 2_000_000  # bytes
TASK = ("corridors", "straight")
NEWCOMER = "DEMO-2"
ATTEMPTS = 5  # trials, until nothing halts one while it is taken


@dataclass
class Camera:
    """Takes the pictures of one page."""

    page: Page

    def still(self, name: str) -> None:
        """Keep what the page shows now."""
        self.page.wait_for_timeout(1500)
        self._image().save(PICTURES / f"{name}.webp", quality=80, method=6)

    def moving(self, name: str, seconds: float) -> None:
        """Keep what the page shows in the next seconds, as fast as it happened."""
        images: list[Image.Image] = []
        times: list[float] = []
        begin = time.monotonic()
        while not times or times[-1] < seconds:
            times.append(time.monotonic() - begin)
            images.append(self._image().resize(MOVING, Image.Resampling.LANCZOS))
            self.page.wait_for_timeout(PAUSE)
        lasts = [round(1000 * (after - before)) for before, after in pairwise(times)]
        images[0].save(
            PICTURES / f"{name}.webp",
            save_all=True,
            append_images=images[1:-1],
            duration=lasts,
            loop=0,
            quality=50,
            method=6,
        )

    def _image(self) -> Image.Image:
        return Image.open(io.BytesIO(self.page.screenshot())).convert("RGB")


def take() -> None:
    """Take all pictures, in the order of a first session."""
    PICTURES.mkdir(exist_ok=True)
    with demonstration() as page:
        camera = Camera(page)
        for name in ("patients", "shirt", "calibrate", "controls", "drive"):
            go_to(page, name)
            camera.still(name)
        drives(page, camera)
        camera.still("trial-over")
        go_to(page, "review")
        expect(page.locator(".chart canvas").first).to_be_visible()
        camera.still("review")
        drives_now(page, camera)


def take_drive_now() -> None:
    """Take the picture of "Drive now" only."""
    with demonstration() as page:
        drives_now(page, Camera(page))


def take_trial() -> None:
    """Take the pictures of a trial only."""
    with demonstration() as page:
        drives(page, Camera(page))


def drives_now(page: Page, camera: Camera) -> None:
    """Bring the patient who was never calibrated to "Drive now", keep that page, and print the seconds of the way."""
    go_to(page, "patients")
    page.get_by_role("button", name="End session").click()
    start = page.get_by_role("listitem").filter(has_text=NEWCOMER).get_by_role("button", name="Start session")
    start.click()
    page.get_by_role("button", name="Start", exact=True).click()
    begin = time.monotonic()
    now = page.get_by_role("button", name="Drive now")
    expect(now).to_be_visible()
    recorded = time.monotonic() - begin
    camera.still("drive-now")
    begin = time.monotonic()
    now.click()
    expect(page.frame_locator("iframe").locator("canvas").first).to_be_visible()
    sys.stdout.write(f"rest and free movement: {recorded:.0f} s; then: {time.monotonic() - begin:.0f} s to the view\n")


def drives(page: Page, camera: Camera) -> None:
    """Drive a trial, and keep the middle of it."""
    for _ in range(ATTEMPTS):
        go_to(page, "drive")
        choose_task(page, *TASK)
        page.get_by_role("button", name="Start trial").click()
        expect(page.frame_locator("iframe").locator("canvas").first).to_be_visible()
        drives_until(page, 2)
        camera.still("trial")
        camera.moving("moving", SECONDS)
        if not page.get_by_role("button", name="Continue").is_visible():  # nobody has tapped it since
            break
        ends_by_hand(page)
        page.get_by_role("button", name="Take the stop back").click()
    else:
        raise AssertionError(f"each of {ATTEMPTS} trials was halted while it was taken: the machine is too busy")
    reaches_the_goal(page)


@contextmanager
def demonstration() -> Iterator[Page]:
    """Give a page of a demonstration, signed in."""
    with running_demo() as link, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=list(CHROMIUM))
        page = browser.new_page(viewport=TABLET, has_touch=True)
        page.set_default_timeout(PATIENCE)
        expect.set_options(timeout=PATIENCE)
        page.goto(link)
        expect(page.locator(".who")).to_contain_text("session")
        page.get_by_role("button", name="Got it").click()
        yield page
        browser.close()


if __name__ == "__main__":
    wished = sys.argv[1:]
    take_drive_now() if "drive-now" in wished else take_trial() if "trial" in wished else take()
    size = sum(picture.stat().st_size for picture in PICTURES.iterdir())
    sys.exit(0 if size < ALL_TOGETHER else f"docs/pictures has {size} bytes, more than {ALL_TOGETHER}")
