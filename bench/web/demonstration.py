"""A demonstration that runs, and a Chromium to look at it."""

import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager

from playwright.sync_api import Browser, sync_playwright

from bench.children import BODYDRIVE, start_command

CHROMIUM = (
    "--headless=new",
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",  # WebGL in software, so that a page finds it on every machine
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)


@contextmanager
def demonstration() -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Yield the process of a demonstration as soon as it has printed its link, and the link.

    Raises
    ------
    RuntimeError
        When it does not start.
    """
    with start_command([*BODYDRIVE, "demo", "--port", "0"]) as demo:
        try:
            link = next((line.strip() for line in demo.stdout or () if line.startswith("http")), None)
            if link is None:
                raise RuntimeError("the demonstration did not start: its message stands above")
            yield demo, link
        finally:
            demo.terminate()


@contextmanager
def chromium() -> Iterator[Browser]:
    """Yield a browser; RuntimeError when there is none."""
    found = shutil.which("chromium")
    if found is None:
        raise RuntimeError("there is no chromium here: install Debian's package 'chromium' to measure pages")
    with (
        sync_playwright() as playwright,
        playwright.chromium.launch(executable_path=found, args=list(CHROMIUM)) as browser,
    ):
        yield browser
