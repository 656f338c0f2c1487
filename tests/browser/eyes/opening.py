"""How a page is opened: by its address, by taps, with everything open, with another answer of the server.

A place is opened step by step; each step is a function of the page and the clinic.
"""

from collections.abc import Callable
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from playwright.sync_api import expect

Open = Callable[[Any, EyesClinic], object]
OPEN_ALL = """() => {
  const closed = document.querySelectorAll("main details:not([open])");
  for (const one of closed) one.open = true;
  return closed.length;
}"""


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


def open_all(page: Any) -> int:
    """Open everything on the page that opens; return how many were closed."""
    return int(page.evaluate(OPEN_ALL))


def steps(*each: Open) -> Open:
    """Return what takes one step after the other."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        for step in each:
            step(page, clinic)

    return open_place


def at(where: str, *taps: str) -> Open:
    """Return what opens a page and taps what has these names."""
    return steps(lambda page, clinic: go(page, clinic, where), *(tapped(name) for name in taps))


def tapped(name: str) -> Open:
    """Return what presses the first button, link or summary of this name."""
    return lambda page, _: tap(page, name)


def chosen(words: str) -> Open:
    """Return what presses the first of these words, as a choice has them."""
    return lambda page, _: page.get_by_text(words, exact=True).first.click()


def filled(label: str, words: str) -> Open:
    """Return what writes into the first field of this label."""
    return lambda page, _: page.get_by_label(label).first.fill(words)


def pressed(key: str) -> Open:
    """Return what presses a key where the focus is."""
    return lambda page, _: page.keyboard.press(key)


def named(role: str, name: str) -> str:
    """Return the selector of what has a role, and these words in its name."""
    return f'role={role}[name*="{name}"i]'


def shows(selector: str) -> Open:
    """Return what waits until the page shows what Playwright finds by a selector: of CSS, `text=` or `role=`."""
    return lambda page, _: expect(page.locator(selector).first).to_be_visible()


def pauses(milliseconds: float) -> Open:
    """Return what waits for so long, until a chart is drawn or a scene has moved."""
    return lambda page, _: page.wait_for_timeout(milliseconds)


def opened(where: str) -> Open:
    """Return what opens a page, and on it everything that opens."""

    def open_everything(page: Any, _clinic: EyesClinic) -> None:
        open_all(page)
        page.wait_for_timeout(200)
        if open_all(page):  # what opens may hold what opens
            page.wait_for_timeout(200)

    return steps(at(where), open_everything)


def addressed(where: str) -> Open:
    """Return what goes to an address of the application, with the answers of the server that were put in place."""
    return lambda page, clinic: page.goto(f"{clinic.address}/#/{where}")


def answers(page: Any, pattern: str, document: Any) -> None:
    """Let requests get another answer from now on."""
    page.route(pattern, lambda route: route.fulfill(json=document))


def answered(path: str, where: str, change: Callable[[Any], Any]) -> Open:
    """Return what opens a page whose request gets another answer."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        answers(page, f"**/api/v1{path}", change(clinic.good("GET", path)))
        addressed(where)(page, clinic)
        expect(page.locator("main h1")).to_be_attached()

    return open_place


def refusing(pattern: str, status: int, words: str) -> Open:
    """Return what lets requests be refused with these words from now on."""
    return lambda page, _: page.route(pattern, lambda route: route.fulfill(status=status, json={"detail": words}))


def document(name: str) -> Open:
    """Return what opens a page of its own."""
    return steps(leave, lambda page, clinic: page.goto(f"{clinic.address}/{name}"))


def start_with(**changes: Any) -> Open:
    """Return what opens the application for somebody else than its owner."""
    return answered("/start", "patients", lambda start: {**start, "me": {**start["me"], **changes}})


def patient_screen(page: Any, clinic: EyesClinic) -> None:
    link = clinic.good("POST", "/patient-screen/pairing")["url"]
    steps(document(link[link.index("patient.html") :]), shows("text=We wait for your clinician"))(page, clinic)
