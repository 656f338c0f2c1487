"""`python -m soak.people`: five browsers work in one clinic for some minutes; `make people-soak`.

Each round one clinician opens a patient, pairs two patient's screens, prompts a movement and drives, while the other
one and a reviewer look on, try what they may not do, and lose the network. The next round the other clinician leads,
with the other patient.

The memory is what the web process has for itself. The ring of ticks is not in it: it has its 13 MB from the start, is
shared with the control process, and becomes resident page by page in its first 160 s.
"""

import argparse
import re
import shutil
import signal
import sys
import tempfile
import time
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import psutil
from browser.conftest import CHROMIUM, FewPicturesBrowser
from browser.driving import go_on_until
from playwright.sync_api import Locator, Page, expect, sync_playwright
from processes.served_demo import bodydrive, printed_link
from soak.cables import Cables
from soak.five_browsers import PATIENCE, PATIENTS, Errors, Seat, furnish, seated

MOST_GROWTH = 50.0  # MB
CLOSED_WITHIN = 10.0  # s
WAITS = re.compile("We wait for (your clinician|the shirt)")
NO_CONNECTION = "No connection to the program"
FAST = 0.2  # m/s
LOST = "No connection to the program"
OVER = re.compile("Finished|Stopped")
PROMPT = "Bend your right elbow"


@dataclass
class Worked:
    """What was found."""

    rounds: int = 0
    memory: list[float] = field(default_factory=list)  # MB that only the web process has, after each round
    errors: list[str] = field(default_factory=list)  # of the pages, and what the program said
    sockets: int = 0  # connections to the program when every browser is closed
    refused: int = 0  # attempts of others to control the chair, each refused

    @property
    def growth(self) -> float:
        """By how much the web process was ever larger than after the first round, MB."""
        return max(self.memory) - self.memory[0]


def work(minutes: float) -> Worked:
    """Let five browsers work for this time, and for two rounds at least."""
    found = Worked()
    with ExitStack() as stack:
        state = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        furnish(state)
        process = bodydrive("serve", "--port", "0", "--state", str(state))
        stack.callback(process.kill)
        port = int(printed_link(process).rstrip("/").rpartition(":")[2])
        cables = Cables(port)
        stack.callback(cables.close)
        playwright = stack.enter_context(sync_playwright())
        launched = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=list(CHROMIUM))
        browser, errors = FewPicturesBrowser(launched), Errors()
        expect.set_options(timeout=PATIENCE)
        with ExitStack() as seats:
            names = ("Ada", "Ben", "Rhea", "screen 1", "screen 2")
            ada, ben, reviewer, *screens = (
                seats.enter_context(seated(name, browser, cables.lay, errors)) for name in names
            )
            for person in (ada, ben, reviewer):
                person.sign_in()
            ada.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
            ada.good("PUT", "/equipment/body", {"kind": "person", "skill": "practised", "seed": 1})
            until = time.monotonic() + 60 * minutes
            while found.rounds < 2 or time.monotonic() < until:
                leads, looks_on = (ada, ben) if found.rounds % 2 == 0 else (ben, ada)
                found.refused += one_round(list(PATIENTS)[found.rounds % 2], leads, looks_on, reviewer, screens)
                found.rounds += 1
                found.memory.append(psutil.Process(process.pid).memory_full_info().uss / 1e6)
                sys.stderr.write(f"Session {found.rounds}: {found.memory[-1]:.1f} MB.\n")
        found.sockets = open_connections(process.pid, port)
        launched.close()
        process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=30)
        found.errors = [*errors.found, *said.splitlines()]
        expect.set_options(timeout=5000)
    return found


def one_round(code: str, leads: Seat, looks_on: Seat, reviewer: Seat, screens: list[Seat]) -> int:
    """Do the work of one session; return how many attempts to control the chair were refused."""
    opens(leads, code)
    follows(looks_on, code)
    for screen in screens:
        offered = leads.good("POST", "/patient-screen/pairing")["code"]
        screen.page.goto("about:blank")
        screen.page.goto(f"{screen.cable.base}/patient.html#pair={offered}")
        expect(screen.page.locator(".task", has_text=WAITS)).to_be_visible()
    is_prompted(leads, screens)
    leads.go("drive")
    leads.page.get_by_role("button", name="Start trial").click()
    drives(leads, screens)
    refused = nobody_else_controls(looks_on, reviewer)
    names_nobody_else(code, leads, looks_on, screens)
    loses_the_network(looks_on, looks_on.page.get_by_text(NO_CONNECTION).first)
    loses_the_network(screens[1], screens[1].page.get_by_text(LOST))
    loses_the_network(leads, leads.page.get_by_text(NO_CONNECTION).first, stopped=screens[0])
    drives(leads, screens)
    reviewer.page.locator("#stop").dispatch_event("pointerdown")
    expect(screens[0].page.locator(".band.stopped")).to_be_visible()
    drives(leads, screens)
    leads.page.get_by_role("button", name="End trial").first.click()
    for screen in screens:  # a busy machine may stop the chair at the same time: then the stop stands there
        expect(screen.page.locator(".moment, .band.stopped").filter(has_text=OVER).first).to_be_visible()
    is_measured(leads)
    go_on_until(leads.page, partial(nobody_is_stopped, screens), "the end of the stop")
    reviews(reviewer, code)
    names_nobody_else(code, leads, looks_on, screens)
    leads.good("DELETE", "/session")
    for screen in screens:
        expect(screen.page.get_by_role("heading", name="Thank you")).to_be_visible()
    leads.page.get_by_role("button", name="Sign out").click()
    expect(leads.page.get_by_label("Password")).to_be_visible()
    assert leads.names() == set()
    leads.sign_in()
    return refused


def opens(leads: Seat, code: str) -> None:
    """Open a patient's session from the list."""
    leads.go("patients")
    row = leads.page.get_by_role("listitem").filter(has_text=code)
    row.get_by_role("button", name=re.compile("Start|Go on")).click()
    expect(leads.page.locator(".who")).to_contain_text(code)


def follows(looks_on: Seat, code: str) -> None:
    """Go on with the patient that another screen has opened; a page of an earlier patient is covered until then."""
    looks_on.go("controls")
    go_on = looks_on.page.get_by_role("button", name=f"Go on with {code}")
    here = looks_on.page.locator(".who").filter(has_text=code)
    expect(go_on.or_(here).first).to_be_visible()
    if go_on.is_visible():
        go_on.click()
    expect(here).to_be_visible()


def is_prompted(leads: Seat, screens: list[Seat]) -> None:
    """Show a cue of the calibration on the patient's screens, and cancel the step."""
    leads.go("calibrate")
    steps = leads.good("GET", "/calibration")["steps"]
    step = next(step["id"] for step in steps if step["joint"] == "right_elbow")
    leads.good("POST", f"/calibration/steps/{step}/start")
    for screen in screens:
        expect(screen.page.locator(".cue-words")).to_have_text(PROMPT)
    leads.good("POST", f"/calibration/steps/{step}/cancel")


def drives(leads: Seat, screens: list[Seat]) -> None:
    """Wait until the patient's screens show that the chair drives; whatever stopped it, Continue goes on."""
    for screen in screens:
        go_on_until(leads.page, partial(is_driven, screen.page), f"a speed on {screen.name}")


def is_driven(page: Page) -> bool:
    """Return whether a patient's screen shows a chair that drives, and not one that still rolls after a stop."""
    shown = re.match(r"[\d.]+", page.locator(".patient .speed .big").inner_text())
    return shown is not None and float(shown[0]) >= FAST and page.locator(".band.stopped").is_hidden()


def nobody_is_stopped(screens: list[Seat]) -> bool:
    """Return whether no patient's screen shows a stop any more."""
    return all(screen.page.locator(".band.stopped").is_hidden() for screen in screens)


def nobody_else_controls(looks_on: Seat, reviewer: Seat) -> int:
    """Try to end and to go on with the trial of somebody else; return the number of attempts, all refused."""
    attempts: tuple[tuple[str, dict[str, Any]], ...] = (("/trials/current/end", {}), ("/control/clear", {"stops": 0}))
    for seat, refusal in ((looks_on, 409), (reviewer, 403)):
        for path, body in attempts:
            status, answer = seat.call("POST", path, body)
            assert status == refusal, (seat.name, path, status, answer)
    return 2 * len(attempts)


def names_nobody_else(code: str, leads: Seat, looks_on: Seat, screens: list[Seat]) -> None:
    """Fail when a page shows another patient than the one who is here, or a patient's screen any."""
    for seat in (leads, looks_on):
        assert seat.names() == {code}, (seat.name, seat.names())
    for screen in screens:
        assert screen.names() == set(), (screen.name, screen.names())


def loses_the_network(seat: Seat, sentence: Locator, stopped: Seat | None = None) -> None:
    """Pull out the cable of a browser until its page says so, and plug it in again; who drives is `stopped` by it."""
    seat.cable.pull()
    expect(sentence).to_be_visible()
    if stopped is not None:
        expect(stopped.page.locator(".band.stopped")).to_be_visible()
    seat.cable.plug_in()
    expect(sentence).to_be_hidden()


def is_measured(leads: Seat) -> None:
    """Wait until the trial that was ended is closed and measured."""
    patient = leads.good("GET", "/session")["patient"]["id"]
    while any(trial["status"] == "running" for trial in leads.good("GET", f"/trials?patient={patient}")):
        leads.page.wait_for_timeout(200)


def reviews(reviewer: Seat, code: str) -> None:
    """Look at the trials of the patient who is here; others are named only where a patient is chosen."""
    reviewer.go("patients")
    reviewer.go("review")
    expect(reviewer.page.get_by_role("link", name=re.compile("Open trial")).first).to_be_visible()
    assert reviewer.names(besides="select") == {code}, reviewer.names()


def open_connections(pid: int, port: int) -> int:
    """Return the number of connections to the program that stay when the browsers are gone."""
    until = time.monotonic() + CLOSED_WITHIN
    while True:
        every = psutil.Process(pid).net_connections("tcp")
        left = [one for one in every if one.laddr.port == port and one.status == psutil.CONN_ESTABLISHED]
        if not left or time.monotonic() > until:
            return len(left)
        time.sleep(0.1)


def main() -> int:
    """Work, print what was found, and return 0 when every limit was kept."""
    parser = argparse.ArgumentParser(prog="python -m soak.people", description="Five browsers in one clinic.")
    parser.add_argument("--minutes", type=float, default=30.0)
    found = work(parser.parse_args().minutes)
    kept = not found.errors and not found.sockets and found.growth < MOST_GROWTH
    sys.stdout.write(
        f"{found.rounds} sessions of two clinicians, a reviewer and two patient's screens.\n"
        f"Web process: {found.memory[0]:.1f} MB after the first, {max(found.memory):.1f} MB at most: "
        f"{found.growth:.1f} MB more (limit {MOST_GROWTH:g}).\n"
        f"After each session, MB: {' '.join(f'{memory:.0f}' for memory in found.memory)}.\n"
        f"Attempts of others to control the chair: {found.refused}, all refused.\n"
        f"Connections left at the end: {found.sockets}.\nErrors: {len(found.errors)}.\n"
    )
    sys.stdout.writelines(f"  {error}\n" for error in found.errors)
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
