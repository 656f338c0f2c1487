"""How a page is opened: by its address, by taps, with everything open, with another answer of the server."""

from collections.abc import Callable
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from playwright.sync_api import expect

Open = Callable[[Any, EyesClinic], None]


def leave(page: Any, clinic: EyesClinic) -> None:
    """Leave the page that stands here for a picture of the clinic, which asks for nothing.

    The browser's process for the page, and what that has read of our scripts, stays alive, as it does not at another
    site: to open the next page from there takes less than half as long.
    """
    page.unroute_all()
    page.goto(f"{clinic.address}/icon.svg")


def go(page: Any, clinic: EyesClinic, where: str) -> None:
    """Load a page of the application anew, and wait for its heading."""
    page.unroute_all()
    # At another address, because the page that stands here could still lead elsewhere before a reload begins. The
    # browser's process for the page stays alive.
    query = "" if "?" in page.url else "?again"
    page.goto(f"{clinic.address}/{query}#/{where}")
    expect(page.locator("main h1")).to_be_attached()


def tap(page: Any, name: str) -> None:
    """Press the first button, link or summary of this name."""
    button, link = page.get_by_role("button", name=name), page.get_by_role("link", name=name)
    button.or_(link).or_(page.locator("summary", has_text=name)).first.click()


def at(where: str, *taps: str) -> Open:
    """Return what opens a page and taps what has these names."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        go(page, clinic, where)
        for name in taps:
            tap(page, name)

    return open_place


def opened(where: str) -> Open:
    """Return what opens a page, and on it everything that opens."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        go(page, clinic, where)
        for _ in range(2):  # what opens may hold what opens
            open_all(page)
            page.wait_for_timeout(200)

    return open_place


def open_all(page: Any) -> None:
    """Open everything on the page that opens."""
    page.evaluate("() => document.querySelectorAll('main details').forEach((one) => (one.open = true))")


def answered(path: str, where: str, change: Callable[[Any], Any]) -> Open:
    """Return what opens a page whose request gets another answer."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        other = change(clinic.good("GET", path))
        page.route(f"**/api/v1{path}", lambda route: route.fulfill(json=other))
        page.goto(f"{clinic.address}/#/{where}")
        expect(page.locator("main h1")).to_be_attached()

    return open_place


def start_with(**changes: Any) -> Open:
    """Return what opens the application for somebody else than its owner."""
    return answered("/start", "patients", lambda start: {**start, "me": {**start["me"], **changes}})


def patient_screen(page: Any, clinic: EyesClinic) -> None:
    link = clinic.good("POST", "/patient-screen/pairing")["url"]
    leave(page, clinic)
    page.goto(f"{clinic.address}/{link[link.index('patient.html') :]}")
    expect(page.get_by_text("We wait for your clinician")).to_be_visible()
