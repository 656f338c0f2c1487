"""Two clinicians, a reviewer and two patient's screens in one clinic, each in a browser and on a cable of its own."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from argon2 import PasswordHasher
from browser.conftest import FewPicturesBrowser
from browser.served.served_clinic import stored
from playwright.sync_api import Page, Response, ViewportSize
from soak.cables import Cable

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.cli.serve import profile_file
from app.settings import Settings
from app.store.parameters import save_parameters, save_profile
from app.store.patients import add_patient, end_session, start_session
from app.store.people import add_clinic, add_person

PASSWORD = "correct horse battery"
PEOPLE = {"Ada": "owner", "Ben": "clinician", "Rhea": "reviewer"}
PATIENTS = {"A-03": "Kingfisher", "B-12": "Oystercatcher"}
SIZE: ViewportSize = {"width": 800, "height": 600}
PATIENCE = 60_000  # ms: five browsers draw in software
PAGE = """(besides) => {
  const page = document.documentElement.cloneNode(true);
  if (besides) page.querySelectorAll(besides).forEach((one) => one.remove());
  return page.outerHTML + document.title + location.href;
}"""


def furnish(state: Path) -> None:
    """Make a clinic with three people and two calibrated patients."""
    profile = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    hashed = PasswordHasher(time_cost=1, memory_cost=8192, parallelism=1).hash(PASSWORD)
    with stored(Settings(state=state)) as db:
        clinic = add_clinic(db, "A clinic")
        for name, role in PEOPLE.items():
            add_person(db, clinic, name, role, hashed)
        for code, pseudonym in PATIENTS.items():
            patient = add_patient(db, code, pseudonym, "")
            session = start_session(db, patient.id)
            row = save_profile(db, patient.id, session.id, profile, simulated=True)
            save_parameters(db, row, standard_parameters(profile))
            end_session(db)


@dataclass
class Errors:
    """What went wrong in any browser."""

    found: list[str] = field(default_factory=list)

    def watch(self, who: str, page: Page) -> None:
        """Keep uncaught errors of a page, and answers of 500 or more."""
        page.on("pageerror", lambda error: self.found.append(f"{who}: {error}"))
        page.on("response", lambda answer: self._answered(who, answer))

    def _answered(self, who: str, answer: Response) -> None:
        if answer.status >= 500:
            self.found.append(f"{who}: {answer.request.method} {answer.url} {answer.status}")


@dataclass
class Seat:
    """One browser: its page and its cable."""

    name: str
    page: Page
    cable: Cable

    def call(self, method: str, path: str, body: Any = None) -> tuple[int, Any]:
        """Send a request as this page does; return status and answer."""
        calls, base = self.page.context.request, self.cable.base
        session = calls.get(f"{base}/api/v1/session").json().get("session")
        headers = {"Origin": base, "Patient-Session": str(session["id"]) if session else "none"}
        answer = calls.fetch(f"{base}/api/v1{path}", method=method, headers=headers, data=body)
        return answer.status, answer.json()

    def good(self, method: str, path: str, body: Any = None) -> Any:
        """Send a request that must be answered well."""
        status, answer = self.call(method, path, body)
        assert status in {200, 201}, (self.name, path, status, answer)
        return answer

    def go(self, where: str) -> None:
        """Go to another page of the application, without loading it again."""
        self.page.evaluate("(hash) => { location.hash = hash; }", f"#/{where}")

    def sign_in(self) -> None:
        """Sign in by name and password."""
        if not self.page.url.startswith(self.cable.base):
            self.page.goto(self.cable.base)
        self.page.get_by_label("Name").fill(self.name)
        self.page.get_by_label("Password").fill(PASSWORD)
        self.page.get_by_role("button", name="Sign in").click()
        self.page.get_by_role("button", name="Sign out").wait_for()

    def names(self, besides: str = "") -> set[str]:
        """Return the patients whose code or pseudonym stands anywhere in the page, `besides` in these elements."""
        held = self.page.evaluate(PAGE, besides)
        return {code for code, pseudonym in PATIENTS.items() if code in held or pseudonym in held}


@contextmanager
def seated(name: str, browser: FewPicturesBrowser, lay: Callable[[], Cable], errors: Errors) -> Iterator[Seat]:
    """Yield a browser with a profile and a cable of its own, and close both."""
    cable = lay()
    context = browser.new_context(viewport=SIZE, has_touch=True)
    page = context.new_page()
    page.set_default_timeout(PATIENCE)
    errors.watch(name, page)
    try:
        yield Seat(name, page, cable)
    finally:
        context.close()
        cable.close()
