"""The sizes at which pages are looked at, what must hold at each of them, and where pictures of it are kept."""

import os
from collections.abc import Iterator, Sequence
from typing import Any

from browser.eyes.sweep import small_targets
from playwright.sync_api import ViewportSize

from folders import SCREENSHOTS

SIZES = ("768x1024", "1280x800", "390x844")  # a tablet upright, a computer or a tablet on its side, a telephone
TOO_WIDE = """() => [document.documentElement, document.querySelector("main")]
  .some((one) => one && one.scrollWidth > one.clientWidth)"""
SETTLE = 250  # ms after a change of the size
# Before a page is drawn the second time, everything has heard of a change. The browser draws more often than the page.
TWICE_DRAWN = """() => new Promise((done) => {
  const next = window.everyPicture ?? window.requestAnimationFrame;
  next(() => next(done));
})"""
# Pictures are for people to look at, and to take one takes longer than to look at the page.
ARE_KEPT = os.environ.get("BODYDRIVE_PICTURES") == "1"


def window(size: str) -> ViewportSize:
    """Return the window of a size such as 768x1024, in px."""
    width, height = map(int, size.split("x"))
    return {"width": width, "height": height}


def each_size(page: Any, sizes: Sequence[str] = SIZES, settle: float = SETTLE) -> Iterator[str]:
    """Give the page one size after the other, and then its own again.

    It is looked at when it has been drawn twice in a size, and `settle` ms have gone by.
    """
    before = page.viewport_size
    for size in sizes:
        page.set_viewport_size(window(size))
        page.evaluate(TWICE_DRAWN)
        page.wait_for_timeout(settle)
        yield size
    page.set_viewport_size(before)


def keep(page: Any, name: str) -> None:
    """Keep a picture of the page in var/screenshots/, where BODYDRIVE_PICTURES=1 asks for pictures."""
    if ARE_KEPT:
        page.wait_for_timeout(SETTLE)
        page.screenshot(path=SCREENSHOTS / f"{name}.png")


def photograph(page: Any, name: str, sizes: Sequence[str] = SIZES, touched: str = "") -> None:
    """Keep a picture at each size; nothing is too wide, and what is `touched` (a selector) is large enough for it."""
    for size in each_size(page, sizes, settle=0):
        keep(page, f"{name}-{size}")
        fits(page, touched, f"{name} {size}")


def fits(page: Any, touched: str = "", what: str = "") -> None:
    """Fail when the page scrolls sideways, or when a control within `touched` (a selector) is too small to touch."""
    page.evaluate(TWICE_DRAWN)
    if misfits(page, touched):
        page.wait_for_timeout(SETTLE)  # until charts have followed the window
    assert misfits(page, touched) == [], what


def misfits(page: Any, touched: str) -> list[str]:
    """Return what does not fit a page as it is now."""
    sideways = ["scrolls sideways"] if page.evaluate(TOO_WIDE) else []
    return sideways + (small_targets(page, touched) if touched else [])
