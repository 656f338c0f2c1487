"""A running web application with a stand-in for the control process."""

import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from api.fake_process import FakeProcess
from clinic_rows import ClinicRows

from app.api.live.screens import Screen, Screens
from app.api.parts import Parts, parts_of
from app.clock import monotonic
from app.news import What
from app.session.open_session import SessionFlow
from app.settings import Settings
from app.speed_limits import Speeds
from app.store.database import Database
from app.store.tables import LogEntry, Patient

with warnings.catch_warnings():
    # Starlette announces the successor of httpx, which is not needed here.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

WORD = "the-screen-of-the-tests"
BASE = "http://127.0.0.1:8080"
SOCKETS = f"{BASE.replace('http', 'ws')}/api/v1"
WHERE = {"floorplan": "apartment", "path": "main", "screen": WORD}  # what starts a trial


def until(true: Callable[[], Any], patience: float = 60.0) -> Any:
    """Wait until something is true, and return it; `patience` in s."""
    end = time.monotonic() + patience
    while not (found := true()):
        assert time.monotonic() < end
        time.sleep(0.005)
    return found


def next_message(socket: Any, is_it: Callable[[Any], bool], most: int = 5000) -> Any:
    """Return the next message of a socket that is the one, and fail after so many others."""
    for _ in range(most):
        message = socket.receive_json()
        if is_it(message):
            return message
    raise AssertionError("no such message came")


def is_news(what: What) -> Callable[[Any], bool]:
    """Return what tells whether a message of a live socket has this news."""
    return lambda message: message.get("news", {}).get("what") == what


def sentence_of(answer: Any, status: int, asked: str = "") -> str:
    """Return the sentence of a refusal that must have this status; `asked` names the request in a failure."""
    assert answer.status_code == status, f"{asked}{answer.text}"
    detail = answer.json()["detail"]
    assert isinstance(detail, str), f"{asked}{detail}"
    assert detail.endswith("."), f"{asked}{detail}"
    assert not detail.endswith(".."), f"{asked}{detail}"
    assert "/tmp/" not in detail, f"{asked}{detail}"
    assert len(detail) < 300, f"{asked}{detail}"
    return detail


class Clinic:
    """One running web application, its control processes, and a browser that knows its own origin."""

    def __init__(self, client: TestClient, processes: list[FakeProcess], readings: dict[str, Any]) -> None:
        self.client = client
        self.processes = processes
        self.readings = readings
        self.patient: Any = None  # who is here from the start

    @property
    def process(self) -> FakeProcess:
        return self.processes[-1]

    def __call__(self, method: str, path: str, **more: Any) -> Any:
        headers = {"Origin": BASE, "Patient-Session": self.session, **more.pop("headers", {})}
        return self.client.request(method, f"/api/v1{path}", headers=headers, **more)

    def good(self, method: str, path: str, **more: Any) -> Any:
        answer = self(method, path, **more)
        assert answer.status_code in {200, 201}, answer.text
        return answer.json()

    def until(self, path: str, good: Callable[[Any], bool]) -> Any:
        """Repeat a request until its answer is good; a test that never gets one fails by its time limit."""
        while True:
            answer = self.good("GET", path)
            if good(answer):
                return answer
            time.sleep(0.02)

    def refused(self, status: int, method: str, path: str, **more: Any) -> str:
        """Send a request that must be refused with this status, and return the sentence of the answer."""
        return sentence_of(self(method, path, **more), status, f"{method} {path}: ")

    def socket(self, path: str, origin: str | None = BASE) -> Any:
        """Open a websocket of the API, as a page of `origin` does."""
        headers = {} if origin is None else {"Origin": origin}
        return self.client.websocket_connect(f"{SOCKETS}{path}", headers=headers)

    @contextmanager
    def screen(self, word: str = WORD) -> Iterator[Any]:
        """Open the socket of a screen that is in view, of the first person who signed in."""
        with self.socket("/screen") as socket:
            socket.send_json({"screen": word, "visible": True, "silence": 0.0})
            while self.parts[Screens].age(Screen(1, word), monotonic()) is None:
                time.sleep(0.002)
            yield socket

    @property
    def parts(self) -> Parts:
        """The long-lived parts of the web process."""
        return parts_of(self.client.app)  # type: ignore[arg-type]

    @property
    def database(self) -> Database:
        return self.parts[Database]

    @property
    def settings(self) -> Settings:
        return self.parts[Settings]

    @property
    def session(self) -> str:
        """The header of a page that shows the open session."""
        return str(self.parts[SessionFlow].session_id or "none")

    def log(self) -> list[LogEntry]:
        """Return the rows of the log, the newest last."""
        with self.database.transaction() as db:
            return list(db.query(LogEntry).order_by(LogEntry.id))

    @contextmanager
    def rows(self) -> Iterator[ClinicRows]:
        """Build rows in the application's own database."""
        with self.database.transaction() as db:
            yield ClinicRows(db)

    def cookies_of(self, name: str, role: str = "clinician", patients: list[int] | None = None) -> dict[str, str]:
        """Sign a person in, who is added unless the name is known; return the cookies of a browser of their own."""
        with self.rows() as rows:
            return {"bodydrive_sign_in": rows.sign_in(name, role, patients)}

    @contextmanager
    def as_person(self, cookies: dict[str, str]) -> Iterator[None]:
        """Use the browser of another person, and put back the cookies of before."""
        before = dict(self.client.cookies)
        self.client.cookies.clear()
        self.client.cookies.update(cookies)
        yield
        self.client.cookies.clear()
        self.client.cookies.update(before)

    def add_patient(self, code: str = "P-1", pseudonym: str = "Heron") -> int:
        """Add a patient, and return the id."""
        return int(self.good("POST", "/patients", json={"code": code, "pseudonym": pseudonym})["id"])

    def rename_patient(self, code: str, pseudonym: str) -> None:
        """Give the patient who is here from the start another code and pseudonym."""
        with self.rows() as rows:
            patient = rows.db.get_one(Patient, self.patient["id"])
            patient.code, patient.pseudonym = code, pseudonym

    def begin_session(self, code: str = "P-1") -> Any:
        """Add a patient and open a session; return the patient."""
        return self.open_session(self.add_patient(code))["patient"]

    def open_session(self, patient_id: int) -> Any:
        """Open a patient's session, and end the one that is open."""
        ends = self.parts[SessionFlow].session_id
        return self.good("POST", "/session", json={"patient_id": patient_id, "ends": ends})

    def record(self, *steps: str) -> Any:
        """Record steps of the calibration to their ends, one after the other; return the calibration."""
        for step in steps:
            self.good("POST", f"/calibration/steps/{step}/start")
            self.end_step()
        return self.good("GET", "/calibration")

    def end_step(self) -> Any:
        """Let the step of the calibration that is being recorded come to its end; return the calibration."""
        self.process.run_t = 1000.0
        return self.until("/calibration", lambda calibration: calibration["running"] is None)

    def calibrate(self) -> Any:
        """Record every step, and accept the result."""
        self.record(*(step["id"] for step in self.good("GET", "/calibration")["steps"][:-1]))
        self.until("/calibration", lambda c: c["result"] is not None and c["running"] is None)
        return self.good("POST", "/calibration/accept")

    def set_controls(self, **changed: Any) -> Any:
        """Set the controls as they are, but for what is changed."""
        now = self.good("GET", "/controls")["parameters"]
        del now["profile"]
        return self.good("PUT", "/controls", json={**now, **changed})

    def choose_chair(self, **speeds: float) -> Any:
        """Pair a real chair, and choose it."""
        chair = {"name": "Blue", "host": "10.0.0.7", "port": 5354, "speeds": {**Speeds().model_dump(), **speeds}}
        chairs = self.good("POST", "/chairs", json=chair)["chairs"]
        return self.good("PUT", "/chairs/chosen", json={"id": chairs[-1]["id"], "dynamics": "unicycle"})

    def start_trial(self, **where: Any) -> Any:
        """Start a trial in the apartment, unless `where` names another place, screen or picture."""
        return self.good("POST", "/trials", json={**WHERE, **where})

    def end_trial(self) -> Any:
        """End the trial by hand."""
        return self.good("POST", "/trials/current/end", json={"reason": "by hand"})

    def drive_trial(self) -> Any:
        """Start a trial and end it at once; return the finished trial."""
        self.start_trial()
        return self.end_trial()


def arm(clinic: Clinic, **headers: str) -> Any:
    """Arm the real chair with what the page of the drive shows."""
    digest = clinic.good("GET", "/drives/summary")["hash"]
    return clinic("POST", "/drives", json={"hash": digest, "screen": WORD}, headers=headers)
