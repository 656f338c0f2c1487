"""The web process loads no slow library: pages that are opened for the first time while a chair drives stop none."""

import math
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import pytest
from drills.results import Watcher, waited
from processes.served_demo import InView, Served, printed_link, running_program, until
from recorded_trial import record_trial, store_trial

from app.api.sign_in.identity import COOKIE
from app.cli.serve import furnish
from app.clock import monotonic, utc_now
from app.features.consents.service import give_consent
from app.settings import Settings, data_folder
from app.source import Source
from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.parameters import current_parameters
from app.store.patients import open_session
from app.store.people import add_person, find_person, the_clinic
from app.store.runs import close_run
from app.world.floorplan import load_floorplan
from building import make_parameters

PLAN = load_floorplan(data_folder() / "floorplans" / "apartment.json")
WORD = "the-screen-of-this-test"
SIMULATED = Source(shirt="simulator", body="person", chair="virtual", simulated=True)
TRIALS = 12  # enough for curves
PAGES = (
    "/trials/1",
    "/trials/1/verdicts",
    "/trials/1/timeline",
    f"/patients/1/learning?floorplan={PLAN.name}&path={PLAN.paths[0].name}&source=simulated",
    "/patients/1/quality?source=simulated",
    "/patients/1/maps",
    "/adaptation",
    "/log/check",
    "/sessions/1/story",
    "/patients/1/report?form=pdf",
    "/patients/1/export?form=fhir",
)
SLOW = ("pyarrow", "scipy", "sklearn")  # libraries that answers are computed with
BUSY = 0.1  # s: a machine that is late by so much may stop the chair
ATTEMPTS = 4


def furnish_with_trials(settings: Settings) -> str:
    """Make a clinic whose patient has driven, and return the token of a sign-in."""
    database = Database(settings.database)
    furnish(database)
    with database.transaction() as db:
        clinic = the_clinic(db)
        assert clinic is not None
        add_person(db, clinic, "Ada", "owner", None)
        session = open_session(db)
        assert session is not None
        row, _ = current_parameters(db, session.patient_id)
        for number in range(TRIALS):
            measures = {"reached": True, "e_diff": 1.0 + math.exp(-number / 3), "time": 60.0}
            store_trial(db, f"run{number}", (session, row), PLAN, SIMULATED, measures)
            close_run(db, f"run{number}", None, None)
        give_consent(db, session.patient_id, "sharing", utc_now().date(), "Ada")
        person = find_person(db, "Ada")
        assert person is not None
        token = sign_in(db, person, "test")
    database.close()
    record_trial(settings.runs / "run0", make_parameters(n_channels=8), seconds=20.0, plan=PLAN)
    return token


@contextmanager
def served(state: Path, token: str) -> Iterator[Served]:
    """Yield a program that serves the clinic, in which nothing was loaded before, and a client that is signed in."""
    with running_program("serve", "--port", "0", "--state", str(state)) as process:
        running = Served(process, printed_link(process).rstrip("/"))
        running.client.cookies.set(COOKIE, token)
        yield running
        running.client.close()
    assert process.returncode == 0


def shared_objects(pid: int) -> set[str]:
    """Return the files of compiled code that a process has loaded."""
    lines = Path(f"/proc/{pid}/maps").read_text().splitlines()
    return {line.split()[-1] for line in lines if line.endswith(".so")}


def libraries(pid: int) -> set[str]:
    """Return which slow libraries a process has loaded."""
    return {name for name in SLOW if any(f"/{name}/" in file for file in shared_objects(pid))}


def drive_and_open(clinic: Served) -> tuple[Any, float]:
    """Drive, open every page, and return the first message that tells of a stop, None without one; and the lateness."""
    with ExitStack() as stack:
        live = stack.enter_context(clinic.socket("live"))
        screen = InView(clinic, WORD)
        stack.callback(screen.close)
        watcher = Watcher()
        stack.callback(watcher.close)
        for path, choice in (("/equipment/shirt", {"kind": "simulator"}), ("/equipment/body", {"kind": "person"})):
            assert clinic.client.put(path, json=choice).is_success
        until(live, lambda message: message["values"] is not None)
        begun, before = monotonic(), waited(clinic.process.pid)
        assert libraries(clinic.process.pid) == set()
        where = {"floorplan": PLAN.name, "path": PLAN.paths[0].name, "screen": WORD}
        assert clinic.client.post("/trials", json=where).status_code == 201
        until(live, lambda message: message["state"] == "fault" or abs(message["v"]) > 0.1)
        loaded = shared_objects(clinic.process.pid)
        for page in PAGES:
            answer = clinic.client.get(page)
            assert answer.status_code == 200, f"{page}: {answer.text}"
        ended = monotonic()
        assert libraries(clinic.process.pid) == set()
        assert shared_objects(clinic.process.pid) - loaded == set()
        assert clinic.client.post("/trials/current/end", json={}).is_success
        assert libraries(clinic.process.pid) == set()
        message = until(live, lambda message: message["state"] == "fault" or message["t"] > ended)
        late = max(watcher.late(begun, ended), waited(clinic.process.pid) - before)
        return (message if message["state"] == "fault" else None), late


@pytest.mark.long  # on a slow machine a chair stops for other reasons
def test_pages_that_are_opened_for_the_first_time_stop_no_chair(tmp_path: Path) -> None:
    token = furnish_with_trials(Settings(state=tmp_path))
    for _ in range(ATTEMPTS):
        with served(tmp_path, token) as clinic:
            stop, late = drive_and_open(clinic)
        if stop is None:
            return
        assert late > BUSY, stop["fault"]
    raise AssertionError("this machine was too busy at every attempt")
