"""A clinic with something on every page: the shirt of 52 sensors, recorded trials, people, and a control process that
the tests make say what they need.
"""

import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from urllib.parse import urlsplit

import numpy as np
from api.fake_process import FakeProcess, profile_for
from browser.served.recorded_clinic import furnish
from browser.served.served_clinic import OWNER, OwnedClinic, stored
from processes.served_demo import SessionClient
from sqlalchemy import delete
from stored_interface_test import store_interface_test

from app.api.live.live_picture import ClinicLive
from app.api.live.message import LiveMessage
from app.api.patient_screen.patient_picture import PatientLive, PatientMessage, PatientPicture
from app.arrivals import Arrivals
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.faults import Fault, State
from app.features.comments.service import add_comment
from app.hardware.shirt.standard import standard_layout
from app.session.calibration.calibration_flow import CalibrationFlow
from app.settings import Settings
from app.store.calibrations import calibration_steps
from app.store.parameters import save_parameters, save_profile
from app.store.patients import end_session, start_session
from app.store.people import find_person
from app.store.tables import InterfaceTest, PatientSession, Trial
from app.texts import to_document

LAYOUT = standard_layout()
# What is stored of all that a place may change, and that has to be put back.
STORED = (
    "SELECT id, patient_id, ended, script, current_step, result, accepted, goal FROM session",
    "SELECT * FROM calibration_step",
    "SELECT * FROM session_note",
    "SELECT * FROM session_sign_off",
    "SELECT id, revoked FROM share_link",
    "SELECT id, deleted FROM patient",
    "SELECT id, status FROM interface_test",
    "SELECT * FROM chair",
    "SELECT chair FROM clinic",
)


class StandIn(FakeProcess):
    """A control process whose shirt has the 52 sensors of the standard one."""

    def __init__(self) -> None:
        super().__init__()
        self.says |= {"n_channels": len(LAYOUT.channels), "n_gestures": 8}
        self.layout = LAYOUT

    def since(self, number: int) -> Any:
        """Return one tick in which every channel has a value, so that most lamps are lit."""
        ticks = super().since(number)
        ticks["values"][0, : len(LAYOUT.channels)] = 0.5 + 0.1 * np.sin(self.number / 9)
        return ticks


class EyesClinic(OwnedClinic):
    """The application of this clinic; `client` is its owner's own browser, `trials` are the recorded ones."""

    def __init__(self, folder: Path) -> None:
        settings = Settings(state=folder, setup_code=OWNER["code"])
        self.trials = self._furnish(settings)
        super().__init__(settings, StandIn)
        self.shown: dict[str, Any] = {}  # fields of the live picture that are other than in truth
        self.shown_to_patient: dict[str, Any] = {}  # the same of the patient's picture
        self.lamps: dict[int, str] = {}  # conditions of sensors that are other than in truth, by the sensor's number
        self.when_left: list[Callable[[], Any]] = []  # what puts back what a place has changed in the browser or here
        self.put_back_to: Any = None  # what was stored, and under way, when it was last put back
        self._others: dict[type[EyesClinic], EyesClinic] = {}  # clinics of another kind that a place has asked for

    def _furnish(self, settings: Settings) -> list[int]:
        """Make what is there before it serves; return the ids of the recorded trials."""
        trials = furnish(settings)
        with stored(settings) as db:
            profile = profile_for(LAYOUT)
            session = start_session(db, 1)
            save_parameters(db, save_profile(db, 1, session.id, profile), standard_parameters(profile))
            end_session(db)
        return trials

    def start(self) -> None:
        """Return when it serves, its owner is signed in, and its patient wears a simulated shirt."""
        super().start()
        self._change_pictures()
        self.good("POST", "/auth/introduction")  # the sentences of a first time do not stand above every page
        self._admit()
        self.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
        self.be_here()

    def _admit(self) -> None:
        """Add a patient and a clinician by the routes of the application."""
        self.good("POST", "/patients", {"code": "P-2", "pseudonym": "Otter"})
        self.good("POST", "/people", {"name": "Ben", "role": "clinician", "patients": None})

    def stop(self) -> None:
        """End it, and the other clinics, and wait for that."""
        for other in self._others.values():
            other.stop()
        super().stop()

    def _change_pictures(self) -> None:
        """Let `shown` and `shown_to_patient` replace fields of what the live sockets send."""
        parts = self.app.state.parts
        live, patient = parts[ClinicLive], parts[PatientPicture]
        true, patients = live._picture, patient.picture
        live._picture = lambda: LiveMessage.model_validate({**true().model_dump(), **self.shown})
        quality = live._quality
        live._quality = lambda: self._with_lamps(quality())
        patient._live = SimpleNamespace(picture=live._picture)
        parts[PatientLive]._picture = lambda: PatientMessage.model_validate(
            {**patients().model_dump(), **self.shown_to_patient}
        )

    def _with_lamps(self, message: Any) -> Any:
        lamps = [self.lamps.get(number, lamp) for number, lamp in enumerate(message.quality)]
        return message.model_copy(update={"quality": lamps})

    def visit(self, page: Any, role: str) -> None:
        """Sign a page's browser in as somebody of another role, until the place is left."""
        name, password = f"The {role}", "battery horse correct"
        client = SessionClient(self.address)
        if any(one["name"] == name for one in self.good("GET", "/people")):
            answer = client.request("POST", "/auth/sign-in", json={"name": name, "password": password})
        else:
            link = self.good("POST", "/people", {"name": name, "role": role, "patients": None})["url"]
            code = link.partition("#invite=")[2]
            answer = client.request("POST", "/auth/invitation/accept", json={"code": code, "password": password})
        assert answer.is_success, answer.text
        client.request("POST", "/auth/introduction")
        self._sign_in(page, client)
        client.close()
        self.when_left.append(lambda: self._sign_in(page, self.client))

    def other(self, page: Any, kind: type["EyesClinic"]) -> "EyesClinic":
        """Sign a page's browser in at a clinic of another kind, until the place is left; its first visit starts it."""
        if kind not in self._others:
            self._others[kind] = kind(self._settings.state / kind.__name__)
            self._others[kind].start()
        other = self._others[kind]
        # A sign-in is locked when nothing was done for ten minutes; between two visits it may be longer.
        other.good("POST", "/auth/unlock", {"password": OWNER["password"]})
        self._sign_in(page, other.client)
        self.when_left += [lambda: self._sign_in(page, self.client), other.leave]
        return other

    def serves(self, url: str) -> bool:
        """Return whether an address (http or ws) is one of this clinic, or of another one that it has started."""
        hosts = {urlsplit(one.address).netloc for one in (self, *self._others.values())}
        return urlsplit(url.removeprefix("blob:")).netloc in hosts

    def leave(self) -> None:
        """Put back what a place has changed."""
        self.shown.clear()
        self.shown_to_patient.clear()
        self.lamps.clear()
        while self.when_left:
            self.when_left.pop()()

    def _sign_in(self, page: Any, client: SessionClient) -> None:
        page.context.clear_cookies()
        page.context.add_cookies(self._cookies(client))

    def set_calibration(
        self, step: str, change: Callable[[CalibrationProfile], CalibrationProfile] = lambda profile: profile
    ) -> None:
        """Let the open session's calibration be at a step; at "result" every step is done, and there is one."""
        session_id = self.good("GET", "/session")["session"]["id"]
        with stored(self._settings) as db:
            self.app.state.parts[CalibrationFlow]._begin_new(db, session_id)
            session = db.get_one(PatientSession, session_id)
            session.current_step, session.accepted = step, False
            for row in calibration_steps(db, session_id).values():
                row.status = "done" if step == "result" else "waiting"
            session.result = change(profile_for(LAYOUT)).model_dump(mode="json") if step == "result" else None

    def add_tests(self) -> None:
        """Store six two-minute tests of the open session in place of earlier ones, the newest better than noise."""
        session_id = self.good("GET", "/session")["session"]["id"]
        with stored(self._settings) as db:
            db.execute(delete(InterfaceTest))  # the result of a test on a page of these tests is a matter of chance
            for throughput in (0.7, 0.72, 0.69, 0.71, 0.7, 1.2):
                store_interface_test(db, session_id, throughput=throughput)

    def add_comment(self, t: float, text: str) -> None:
        """Store a comment of Ben, the second person of the clinic, on a moment (s) of the first trial."""
        with stored(self._settings) as db:
            ben = find_person(db, "Ben")
            assert ben is not None
            add_comment(db, db.get_one(Trial, self.trials[0]), ben.id, t, text)

    def fault(self, fault: Fault) -> None:
        """Let the control process stop the chair for a reason."""
        self.process.stops += 1
        self.process.state, self.process.fault = State.FAULT, fault

    def silence(self, words: str, arrivals: Arrivals | None = None) -> None:
        """Let no frame come from the shirt, whose state these words are, until the place is left."""
        process = self.process

        def sends(is_sending: bool, words: str) -> None:
            process.sends, process.shirt_words, process.arrivals = is_sending, words, None

        before = process.shirt_words
        sends(False, words)
        if arrivals is not None:
            process.arrivals = {**arrivals._asdict(), "message": to_document(arrivals.message)}
        self.when_left.append(lambda: sends(True, before))

    def stored(self) -> Any:
        """Return what is stored, and under way, of all that a place may change."""
        with closing(sqlite3.connect(self._settings.database)) as db:
            rows = [db.execute(query).fetchall() for query in STORED]
        return rows, self.process.run, self.app.state.parts[CalibrationFlow].running

    def clear(self) -> None:
        """Take the reason back."""
        self.process.state = State.ARMED if self.process.run else State.DISARMED
        self.process.fault = Fault.NONE

    def storage(self) -> Any:
        """Return what makes a browser the owner's: the cookies of a sign-in."""
        return {"cookies": self._cookies(self.client), "origins": []}

    def _cookies(self, client: SessionClient) -> list[Any]:
        host = self.address.removeprefix("http://").split(":")[0]
        return [{"name": name, "value": value, "domain": host, "path": "/"} for name, value in client.cookies.items()]
