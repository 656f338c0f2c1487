"""A real browser, and what it must not do: report an error, or ask another machine for anything."""

import re
import shlex
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from urllib.parse import urlsplit

import pytest
from browser.script import script
from browser.served.clinic_app import ClinicApp
from browser.served.recorded_clinic import RecordedClinic, course_clinic
from browser.sizes import window
from playwright.sync_api import (
    Browser,
    BrowserContext,
    ConsoleMessage,
    Frame,
    Page,
    Playwright,
    Request,
    expect,
    sync_playwright,
)
from processes.served_demo import running_demo

from app.child_process import NICENESS
from needed import need

PATIENCE = 100_000  # ms until a page shows what is expected: a busy machine that draws in software is slow
CHROMIUM = (
    "--headless=new",
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-compositing",  # SwiftShader draws the 3D view only; to put whole pages together costs far more
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)
# No other machine is reached, by whatever name or address: a request to one fails.
THIS_MACHINE_ONLY = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost"

# Chromium without windows passes the same pages in a seventh less time than the whole of it with its windows hidden.
PROGRAM = shutil.which("chromium-headless-shell") or shutil.which("chromium")

# Without a limit, software draws as many pictures of a page and of its 3D view as the processors can: three a second,
# and the 3D view in a quarter of its pixels, leave time for other tests. The chair stops for a picture 1 s old.
FEW_PICTURES = script("few_pictures")

# Most of a processor goes to a 3D view that software draws. A page begins with the drawn plan, as one does on which it
# was chosen before, unless its test looks at the 3D view.
DRAWN_PLAN = """(() => {
  if (window !== top || !location.protocol.startsWith("http")) return;
  if (!sessionStorage.getItem("bodydrive-view")) sessionStorage.setItem("bodydrive-view", "plan");
})()"""


class FewPicturesBrowser:
    """Chromium whose pages draw few pictures; those that a test opens are closed when it ends."""

    def __init__(self, browser: Browser) -> None:
        self._browser = browser

    def new_context(self, *, all_pictures: bool = False, in_3d: bool = False, **options: Any) -> BrowserContext:
        """Open a context, as Playwright does.

        With `all_pictures` its pages draw as often as they can; with `in_3d` a trial begins with the 3D view.
        """
        context = self._browser.new_context(**options)
        if not STARTED.lasting:
            STARTED.passing.append(context)
        context.set_default_timeout(PATIENCE)
        if not all_pictures:
            context.add_init_script(FEW_PICTURES)
        if not in_3d:
            context.add_init_script(DRAWN_PLAN)
        return context

    def new_page(self, **options: Any) -> Page:
        """Open a page in a context of its own, with the options of `new_context`."""
        return self.new_context(**options).new_page()


CONTINUE = "/api/v1/control/clear"
FORBIDDEN = re.compile(r"'((?:https?|wss?)://[^' ]+)'")  # the address in what the browser says of a content policy


@dataclass
class PageLog:
    """What a page did that it should not have.

    A request elsewhere is seen as what becomes of it: the browser refuses it because of the page's content policy, or
    it fails (`THIS_MACHINE_ONLY`), or it leads a frame elsewhere. To be told of each request of a page that loads more
    than a hundred files would take a fifth of the time to open it.
    """

    host: str
    errors: list[str] = field(default_factory=list)
    outside: list[str] = field(default_factory=list)

    def watch(self, page: Page) -> Page:
        """Keep a page's console errors, uncaught errors and requests to other hosts."""
        page.on("console", self._console)
        page.on("pageerror", lambda error: self.errors.append(f"uncaught: {error.stack or error}"))
        page.on("requestfailed", self._request)
        page.on("framenavigated", self._navigated)
        page.on("websocket", lambda socket: self._reached(socket.url))
        return page

    @property
    def uncaught(self) -> list[str]:
        """Return the errors that a page threw."""
        return [error for error in self.errors if error.startswith("uncaught")]

    def assert_clean(self, allowed: str = CONTINUE) -> None:
        """Fail when a page reported an error, unless it contains what is `allowed`, or asked another machine.

        A Continue may be refused: on a busy machine the picture, or the page itself, can be late again.
        """
        assert [error for error in self.errors if allowed not in error] == []
        assert self.outside == []

    def assert_quiet(self) -> None:
        """Fail when a page threw an error or asked another machine; what the server refuses, it may report."""
        assert self.uncaught == []
        assert self.outside == []

    def _console(self, message: ConsoleMessage) -> None:
        if message.type == "error":
            self.errors.append(f"{message.text} {message.location['url']}".rstrip())
            if "Content Security Policy" in message.text:
                for url in FORBIDDEN.findall(message.text):
                    self._reached(url)

    def _request(self, request: Request) -> None:
        self._reached(request.url)

    def _navigated(self, frame: Frame) -> None:
        self._reached(frame.url)

    def _reached(self, url: str) -> None:
        parts = urlsplit(url.removeprefix("blob:"))
        if parts.scheme in {"http", "https", "ws", "wss"} and parts.netloc != self.host:
            self.outside.append(url)


# A browser stands for another machine: it must not take the processors from the program, nor from the processes that
# compute for it at low priority. Chromium of the superuser raises the priority of some of its threads, unless that is
# forbidden.
MODEST = """#!/bin/sh
for word; do case "$word" in --disable-features=*) off="$off,${{word#*=}}" ;; esac; done
set -- nice -n {niceness} {program} "$@" "--disable-features={unseen}$off"
[ "$(id -u)" = 0 ] && command -v setpriv > /dev/null && set -- setpriv --bounding-set -sys_nice "$@"
exec "$@"
"""
# With each window, also one that is never shown, Chromium loads two pages that stand below its address line: that takes
# longer than to load ours. For each context it starts a process for a next page, which most tests do not open. Chromium
# reads the last list of features that are off, so that of Playwright is in it, too.
UNSEEN = "WebUIOmniboxPopup,WebUIOmniboxAimPopup,SpareRendererForSitePerProcess"


def modest(program: str, folder: Path) -> Path:
    """Return a program in `folder` that runs another one, which cannot raise its priority above that of the tests."""
    script = folder / "modest-browser"
    script.write_text(MODEST.format(program=shlex.quote(program), niceness=NICENESS, unseen=UNSEEN))
    script.chmod(0o755)
    return script


class StartedOnce:
    """Playwright and Chromium, each started for the first file that needs it, because that takes seconds."""

    def __init__(self) -> None:
        self._ends = ExitStack()
        self._playwright: Playwright | None = None
        self._chromium: Browser | None = None
        self.passing: list[BrowserContext] = []  # opened by the test that runs now
        self.lasting = 0  # fixtures under way that outlive a test, and so does what they open

    def playwright(self) -> Playwright:
        """Return what starts browsers; there can be one only."""
        if self._playwright is None:
            self._playwright = self._ends.enter_context(sync_playwright())
        return self._playwright

    def chromium(self) -> Browser:
        """Return Chromium without a screen, drawing in software."""
        if self._chromium is None:
            assert PROGRAM is not None
            folder = self._ends.enter_context(TemporaryDirectory())
            self._chromium = self.playwright().chromium.launch(
                executable_path=modest(PROGRAM, Path(folder)), args=[*CHROMIUM, THIS_MACHINE_ONLY]
            )
            self._ends.callback(self._chromium.close)
        return self._chromium

    def close_passing(self) -> None:
        """Close what the test has opened: a page that is left open goes on to draw, and a server waits for it."""
        while self.passing:
            self.passing.pop().close()

    def end(self) -> None:
        """End both; they can be started again."""
        self.passing.clear()
        self._ends.close()
        self._playwright = self._chromium = None


STARTED = StartedOnce()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(nextitem: pytest.Item | None) -> Iterator[None]:
    """End the browser after the last test of this folder.

    Playwright keeps an event loop running as long as it lives, and the tests of other folders start their own.
    """
    yield
    if nextitem is None or Path(__file__).parent not in nextitem.path.parents:
        STARTED.end()


@pytest.hookimpl(wrapper=True)
def pytest_fixture_setup(fixturedef: pytest.FixtureDef[Any]) -> Iterator[None]:
    """Note that what is opened now belongs to more tests than one."""
    is_lasting = fixturedef.scope != "function"
    STARTED.lasting += is_lasting
    try:
        return (yield)
    finally:
        STARTED.lasting -= is_lasting


@pytest.fixture(autouse=True)
def _pages_of_the_test() -> Iterator[None]:
    yield
    STARTED.close_passing()


@pytest.fixture(scope="session")
def playwright() -> Playwright:
    """Playwright, for a test that starts a browser of its own."""
    return STARTED.playwright()


@pytest.fixture(scope="module")
def browser() -> Iterator[FewPicturesBrowser]:
    """What opens the pages of a file's tests; those that stay open are closed when the file ends."""
    if PROGRAM is None:
        need("chromium", "chromium")
    expect.set_options(timeout=PATIENCE)
    chromium = STARTED.chromium()
    yield FewPicturesBrowser(chromium)
    for context in chromium.contexts:
        context.close()


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ClinicApp]:
    """Yield a clinic for the tests of one file: two calibrated patients, and an owner who is signed in."""
    with ClinicApp(tmp_path_factory.mktemp("served") / "clinic") as app:
        yield app


@pytest.fixture
def recorded(tmp_path: Path) -> Iterator[RecordedClinic]:
    """Yield a clinic with two trials that are over and have recordings."""
    with RecordedClinic(tmp_path / "recorded") as app:
        yield app


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RecordedClinic]:
    """Yield a clinic for the tests of one file, whose first person became better in four sessions."""
    with course_clinic(tmp_path_factory.mktemp("course")) as app:
        yield app


@pytest.fixture(scope="module")
def demo() -> Iterator[str]:
    """Yield the link of a demonstration that runs for the tests of one file."""
    with running_demo() as link:
        yield link


@pytest.fixture
def own_demo(tmp_path: Path) -> Iterator[str]:
    """Yield the link of a demonstration of this test alone, whose state lies in its folder."""
    with running_demo(TMPDIR=str(tmp_path)) as link:
        yield link


@pytest.fixture
def open_page(browser: FewPicturesBrowser) -> Iterator[Callable[..., Page]]:
    """Return what opens an address in a browser of its own; at the end, no page has reported what is not `allowed`.

    `sign_in` is what the cookie of a person holds, `script` runs first on each page. The clinic that serves the page
    comes before this fixture, so that it ends after its pages.
    """
    opened = []

    def open_address(
        address: str,
        size: str = "768x1024",
        *,
        allowed: str = CONTINUE,
        sign_in: str = "",
        script: str = "",
        **options: Any,
    ) -> Page:
        log = PageLog(urlsplit(address).netloc)
        page = log.watch(browser.new_page(viewport=window(size), **options))
        opened.append((page, log, allowed))
        page.add_init_script(script)
        if sign_in:
            clinic = address.partition("#")[0]
            page.context.add_cookies([{"name": "bodydrive_sign_in", "value": sign_in, "url": clinic}])
        page.goto(address)
        return page

    yield open_address
    for page, _, _ in opened:
        page.context.close()
    for _, log, allowed in opened:
        log.assert_clean(allowed)


@pytest.fixture(scope="session")
def page_log() -> Callable[[str], PageLog]:
    """Return what makes a log for pages from an address."""
    return lambda address: PageLog(urlsplit(address).netloc)


@pytest.fixture(scope="session")
def until() -> Callable[..., Any]:
    """Return what waits until an expression is true in a page, and gives its value.

    Playwright's own waiting compiles code from text, which our content policy forbids.
    """

    def wait(page: Page, expression: str, *, seconds: float = PATIENCE / 1000) -> Any:
        deadline = time.monotonic() + seconds
        while True:
            found = page.evaluate(f"() => ({expression})")
            if found:
                return found
            assert time.monotonic() < deadline, f"still not true after {seconds:g} s: {expression}"
            page.wait_for_timeout(100)

    return wait
