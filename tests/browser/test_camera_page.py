"""A person before a real browser's camera, which plays a film: what is sent, what is not, and what is said."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser.conftest import PATIENCE
from browser.fake_camera import Traffic, browser_with_camera, film_of
from browser.sizes import keep
from browser.tablets import put_first_sentences_away, send
from playwright.sync_api import Page, Playwright, expect

from app.hardware.shirt.camera import CameraSample, decode_sample

pytestmark = [pytest.mark.browser, pytest.mark.long]

CHANNELS = 19
SECONDS = 120  # until the first picture is read: software compiles the shaders for 20 s on an idle machine
# The longest time for which the page's own thread did nothing else: its heartbeat and its Stop wait for it.
LONGEST_GAP = """() => {
  let [last, longest] = [performance.now(), 0];
  window.longestGap = () => longest;
  window.forgetGaps = () => (longest = 0);
  setInterval(() => {
    const now = performance.now();
    [longest, last] = [Math.max(longest, now - last), now];
  }, 20);
}"""
STORED = """async () => ({
  local: Object.keys(localStorage), session: Object.keys(sessionStorage),
  databases: (await indexedDB.databases()).length, caches: (await caches.keys()).length,
})"""


class Filmed:
    """The page of a demonstration, in a browser with a camera."""

    def __init__(self, page: Page, link: str, log: Any) -> None:
        self.page, self.link, self.log = page, link, log
        self.traffic = Traffic(page)
        page.goto(link)
        expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
        put_first_sentences_away(page)
        page.evaluate(LONGEST_GAP)

    @property
    def card(self) -> Any:
        return self.page.locator("section.card[data-card=camera]")

    @property
    def samples(self) -> list[CameraSample]:
        """Return what was sent as the camera; every message is a sample."""
        messages = self.traffic.messages.get("/camera", [])
        samples = [decode_sample(message, CHANNELS) for message in messages if isinstance(message, bytes)]
        assert len(samples) == len(messages)
        assert None not in samples
        return [sample for sample in samples if sample is not None]

    def until(self, wanted: Callable[[list[CameraSample]], bool], since: int = 0) -> list[CameraSample]:
        """Wait until the samples since one of them are as wanted, and return them."""
        for _ in range(SECONDS * 10):
            samples = self.samples[since:]
            if wanted(samples):
                return samples
            self.page.wait_for_timeout(100)
        raise AssertionError(f"{len(self.samples)} samples, none as wanted; {self.card.inner_text()}")

    def shirt_words(self) -> str:
        return str(send(self.page, self.link, "GET", "/equipment").json()["status"]["message"])


def sees_somebody(samples: list[CameraSample]) -> bool:
    return any(np.isfinite(sample.values[:6]).all() for sample in samples)  # both shoulders


def sees_nobody(samples: list[CameraSample]) -> bool:
    return any(np.isnan(sample.values).all() for sample in samples)


@pytest.fixture
def film(
    tmp_path: Path, own_demo: str, playwright: Playwright, page_log: Callable[[str], Any]
) -> Iterator[Callable[..., Filmed]]:
    """Return what opens a demonstration before a camera that plays a film of so many seconds; no page has an error."""
    opened: list[Filmed] = []

    def open_before(**seconds: float) -> Filmed:
        file = film_of(tmp_path / "film.mjpeg", **seconds)
        browser = ends.enter_context(browser_with_camera(playwright, file, tmp_path))
        context = browser.new_context(viewport={"width": 1280, "height": 800}, permissions=["camera"])
        context.set_default_timeout(PATIENCE)
        page, log = context.new_page(), page_log(own_demo)
        opened.append(Filmed(log.watch(page), own_demo, log))
        return opened[-1]

    with ExitStack() as ends:
        yield open_before
        for filmed in opened:
            filmed.log.assert_clean()


def test_a_demonstration_is_moved_by_oneself_and_nothing_of_the_picture_is_sent_or_stored(
    film: Callable[..., Filmed],
) -> None:
    filmed = film(seconds=8.0)
    page = filmed.page
    stored = page.evaluate(STORED)
    requests = len(filmed.traffic.bodies)
    page.get_by_role("button", name="Move it yourself with this camera").click()
    expect(filmed.card.get_by_role("heading", name="The camera")).to_be_visible()
    expect(filmed.card.get_by_text("nothing of it is stored or sent")).to_be_visible()
    samples = filmed.until(sees_somebody)
    filmed.until(lambda more: len(more) >= 10)
    assert [sample.seq for sample in samples] == sorted({sample.seq for sample in samples})
    keep(page, "camera-mirror")
    assert filmed.card.locator("video").evaluate("(video) => video.videoWidth") == 640
    assert filmed.card.locator("svg path").count() >= 1  # the shoulders, at least
    # Who leans from side to side keeps the shoulders in their place on the trunk.
    elevations = np.array([sample.values[0] for sample in filmed.samples])
    assert np.ptp(elevations[np.isfinite(elevations)]) < 0.3  # widths of the shoulders

    # Every request since then: small ones to this machine, and no body that could be a picture.
    bodies = filmed.traffic.bodies[requests:]
    assert {method for method, _, length in bodies if length} <= {"PUT", "POST"}
    assert max(length for _, _, length in bodies) < 1000
    others = {path: sent for path, sent in filmed.traffic.messages.items() if path != "/camera"}
    assert all(isinstance(message, str) and len(message) < 1000 for sent in others.values() for message in sent)
    assert page.evaluate(STORED) == stored
    filmed.log.assert_clean()  # no other machine was asked for anything


def test_who_goes_away_is_missing_and_comes_back(film: Callable[..., Filmed]) -> None:
    filmed = film(seconds=15.0, empty_seconds=15.0)
    filmed.page.get_by_role("button", name="Move it yourself with this camera").click()
    filmed.until(sees_somebody)
    here = len(filmed.samples)
    filmed.until(sees_nobody, here)
    expect(filmed.card.get_by_text("The camera sees nobody, and the chair stops")).to_be_visible()
    away = len(filmed.samples)
    filmed.until(sees_somebody, away)


def test_the_page_goes_on_while_pictures_are_read_and_the_camera_ends_when_it_is_stopped(
    film: Callable[..., Filmed],
) -> None:
    filmed = film(seconds=8.0)
    page = filmed.page
    page.get_by_role("button", name="Move it yourself with this camera").click()
    filmed.until(sees_somebody)
    page.evaluate("() => window.forgetGaps()")
    count = len(filmed.samples)
    page.wait_for_timeout(5000)
    assert len(filmed.samples) > count
    assert page.evaluate("() => window.longestGap()") < 1000  # ms: the chair stops after 3 s
    assert filmed.shirt_words().startswith(("Camera, 19 sensors", "The camera sees nobody"))

    filmed.card.get_by_role("button", name="Stop the camera").click()
    expect(filmed.card.locator("video")).to_have_count(0)
    page.wait_for_timeout(1000)
    count = len(filmed.samples)
    page.wait_for_timeout(1000)
    assert len(filmed.samples) == count
    assert filmed.shirt_words().startswith("No camera sends")


def test_another_shirt_ends_the_camera(film: Callable[..., Filmed]) -> None:
    filmed = film(seconds=8.0)
    filmed.page.get_by_role("button", name="Move it yourself with this camera").click()
    filmed.until(sees_somebody)
    simulated = {"kind": "simulator", "sample_rate": 100.0, "seed": 1, "layout": None, "dead_channels": []}
    assert send(filmed.page, filmed.link, "PUT", "/equipment/shirt", simulated).ok
    expect(filmed.card).to_have_count(0)
    filmed.page.wait_for_timeout(1000)
    count = len(filmed.samples)
    filmed.page.wait_for_timeout(1000)
    assert len(filmed.samples) == count
