"""A real clinic (no demonstration) with its pages and no control process behind it, for tests of what pages say."""

from pathlib import Path
from typing import Any

from api.fake_process import LAYOUT, profile_for
from browser.served.served_clinic import ServedClinic
from processes.served_demo import SessionClient

from app.calibration.vocabulary import standard_parameters
from app.settings import Settings
from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.parameters import save_parameters, save_profile
from app.store.patients import add_patient, end_session, start_session
from app.store.people import add_clinic, find_person

CODE = "the-set-up-code-of-the-tests"
OWNER = {"code": CODE, "name": "Ada", "password": "correct horse battery"}
PATIENTS = ("A-03", "B-12")


def assert_quiet(log: Any) -> None:
    """Fail when a page threw an error or asked another machine; what the server refuses, it may report."""
    assert [error for error in log.errors if error.startswith("uncaught")] == []
    assert log.outside == []


def furnish(settings: Settings) -> dict[str, int]:
    """Make two calibrated patients; return their ids by code."""
    database = Database(settings.database)
    ids = {}
    with database.transaction() as db:
        add_clinic(db, "A clinic")
        for code in PATIENTS:
            patient = add_patient(db, code, f"Bird {code}", "")
            session = start_session(db, patient.id)
            profile = profile_for(LAYOUT)
            save_parameters(db, save_profile(db, patient.id, session.id, profile), standard_parameters(profile))
            end_session(db)
            ids[code] = patient.id
    database.close()
    return ids


def go(page: Any, where: str) -> None:
    """Go to another page of the application, without loading it again."""
    page.evaluate("(hash) => { location.hash = hash; }", f"#/{where}")


class ClinicApp(ServedClinic):
    """The application of this clinic in a thread of this process, and its owner's own browser (`client`)."""

    def __init__(self, folder: Path) -> None:
        settings = Settings(state=folder, setup_code=CODE)
        self.patients = furnish(settings)
        self._files = settings.files
        super().__init__(settings)
        self.client = SessionClient(self.address)

    def start(self) -> None:
        """Return when it serves and its owner is signed in."""
        super().start()
        self.good("POST", "/auth/setup", OWNER)

    def stop(self) -> None:
        """End it and wait for that."""
        self.client.close()
        super().stop()

    def good(self, method: str, path: str, body: Any = None) -> Any:
        """Send a request that must be answered well, from the owner's own browser."""
        answer = self.client.request(method, path, json=body)
        assert answer.is_success, answer.text
        return answer.json()

    def recording(self) -> str:
        """Return the name of a file of recorded signals that lies on the machine."""
        file = self._files / "signals.csv"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("t,right_elbow_1\n0.0,1.0\n0.01,1.0\n")
        return file.name

    def open_session(self, code: str) -> None:
        """Open a patient's session in the owner's own browser."""
        now = self.good("GET", "/session")["session"]
        self.good("POST", "/session", {"patient_id": self.patients[code], "ends": now and now["id"]})

    def sign_in(self, page: Any) -> None:
        """Load the first page anew for the owner, who is signed in, as in a browser that was never here before."""
        page.goto(f"{self.address}/icon.svg")  # the page that stood here asks for nothing more
        page.evaluate("() => { localStorage.clear(); sessionStorage.clear(); }")
        with self.app.state.parts[Database].transaction() as db:
            owner = find_person(db, OWNER["name"])
            assert owner is not None
            token = sign_in(db, owner, "test")
        page.context.clear_cookies()
        page.context.add_cookies([{"name": "bodydrive_sign_in", "value": token, "url": self.address}])
        page.goto(self.address)

    def type_name_and_password(self, page: Any) -> None:
        """Sign a page in as the owner does, by its form."""
        page.goto(self.address)
        page.get_by_label("Name").fill(OWNER["name"])
        page.get_by_label("Password").fill(OWNER["password"])
        page.get_by_role("button", name="Sign in").click()
