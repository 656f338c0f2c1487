"""A real clinic (no demonstration) with its pages and no control process behind it, for tests of what pages say."""

from pathlib import Path
from typing import Any

from api.fake_process import LAYOUT, profile_for
from browser.served.served_clinic import CODE, OWNER, OwnedClinic, stored
from playwright.sync_api import expect

from app.calibration.vocabulary import standard_parameters
from app.settings import Settings
from app.store.parameters import save_parameters, save_profile
from app.store.patients import add_patient, end_session, start_session
from app.store.people import add_clinic

PATIENTS = ("A-03", "B-12")


def furnish(settings: Settings) -> dict[str, int]:
    """Make two calibrated patients; return their ids by code."""
    ids = {}
    with stored(settings) as db:
        add_clinic(db, "A clinic")
        for code in PATIENTS:
            patient = add_patient(db, code, f"Bird {code}", "")
            session = start_session(db, patient.id)
            profile = profile_for(LAYOUT)
            save_parameters(db, save_profile(db, patient.id, session.id, profile), standard_parameters(profile))
            end_session(db)
            ids[code] = patient.id
    return ids


def go(page: Any, where: str) -> None:
    """Go to another page of the application, without loading it again."""
    page.evaluate("(hash) => { location.hash = hash; }", f"#/{where}")


class ClinicApp(OwnedClinic):
    """The application of this clinic, and its owner's own browser."""

    def __init__(self, folder: Path) -> None:
        settings = Settings(state=folder, setup_code=CODE)
        self.patients = furnish(settings)
        super().__init__(settings)

    def recording(self) -> str:
        """Return the name of a file of recorded signals that lies on the machine."""
        file = self._settings.files / "signals.csv"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("t,right_elbow_1\n0.0,1.0\n0.01,1.0\n")
        return file.name

    def open_session(self, code: str) -> None:
        """Open a patient's session in the owner's own browser."""
        self.be_here(self.patients[code])

    def sign_in(self, page: Any, code: str = "") -> Any:
        """Load the first page anew for the owner, who is signed in, as in a browser that was never here before.

        With a patient's code, open the session of that patient first. Return the page, which shows who is here.
        """
        if code:
            self.open_session(code)
        page.goto(f"{self.address}/icon.svg")  # the page that stood here asks for nothing more
        page.evaluate("() => { localStorage.clear(); sessionStorage.clear(); }")
        cookie = {"name": "bodydrive_sign_in", "value": self.sign_in_as(OWNER["name"]), "url": self.address}
        page.context.clear_cookies()
        page.context.add_cookies([cookie])
        page.goto(self.address)
        expect(page.locator(".who")).to_contain_text(code)
        return page

    def type_name_and_password(self, page: Any) -> None:
        """Sign a page in as the owner does, by its form."""
        page.goto(self.address)
        page.get_by_label("Name").fill(OWNER["name"])
        page.get_by_label("Password").fill(OWNER["password"])
        page.get_by_role("button", name="Sign in").click()
