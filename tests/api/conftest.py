"""A clinic of its own for each test: a copy of one that was made once, opened by the web application."""

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from api.fake_clinic import Clinic
from api.pairing import code_of, only, pair
from api.people_of_clinic import OWNER
from api.running_app import running
from clinic_rows import rows_in
from session.same_process import SameProcess
from session.same_reader import read_in_this_process

from app.api import package_download
from app.api.sign_in import hashing
from app.session import run_watch
from app.session.calibration import calibration_flow
from app.settings import Settings
from app.store import database
from app.store.files import ballast

CODE = "the-code-of-the-link"


def demonstration(state: Path) -> Settings:
    return Settings(state=state, demo_code=CODE)


def new_demonstration(state: Path) -> Settings:
    """Make a demonstration that nobody used yet."""
    settings = demonstration(state)
    with rows_in(settings, "Demonstration"):
        return settings


def sign_in(clinic: Clinic) -> None:
    clinic.good("POST", "/auth/demo", json={"code": CODE})


def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take the time out of what a test waits for: hashes, the ballast, the disk, looking again, processes."""
    monkeypatch.setattr(hashing, "COST", hashing.Cost(time=1, memory=8, lanes=1))
    monkeypatch.setattr(ballast, "SIZE", 65_536)  # each test keeps its folder for a while
    monkeypatch.setattr(database, "PRAGMAS", (*database.PRAGMAS, "synchronous=OFF"))  # no test cuts the power
    monkeypatch.setattr(os, "fsync", lambda _descriptor: None)
    monkeypatch.setattr(calibration_flow, "WATCH_EVERY", 0.002)
    monkeypatch.setattr(run_watch, "WATCH_EVERY", 0.002)
    read_in_this_process(monkeypatch)
    monkeypatch.setattr(package_download, "ComputingProcess", SameProcess)


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    return demonstration(tmp_path / "state")


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    quick(monkeypatch)


@pytest.fixture(scope="session")
def new_state(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a demonstration that nobody used yet."""
    return new_demonstration(tmp_path_factory.mktemp("new") / "state").state


@pytest.fixture(scope="session")
def make_state(new_state: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[[Callable[[Clinic], None]], Path]:
    """Return a function that lets a clinician do something in a demonstration, and returns the folder that is left."""

    def make(work: Callable[[Clinic], None]) -> Path:
        settings = demonstration(tmp_path_factory.mktemp("made") / "state")
        shutil.copytree(new_state, settings.state)
        with pytest.MonkeyPatch.context() as monkeypatch:
            quick(monkeypatch)
            for clinic in running(settings):
                sign_in(clinic)
                work(clinic)
                clinic.good("POST", "/auth/sign-out")
        return settings.state

    return make


@pytest.fixture(scope="session")
def calibrated_state(make_state: Callable[[Callable[[Clinic], None]], Path]) -> Path:
    """The folder of a demonstration whose first patient is here and was calibrated just now."""

    def work(clinic: Clinic) -> None:
        clinic.begin_session()
        clinic.calibrate()

    return make_state(work)


@pytest.fixture
def clinic(settings: Settings, new_state: Path) -> Iterator[Clinic]:
    """A demonstration, nobody signed in."""
    shutil.copytree(new_state, settings.state)
    yield from running(settings)


@pytest.fixture
def real_settings(tmp_path: Path) -> Settings:
    return Settings(state=tmp_path / "real", setup_code=OWNER["code"])


@pytest.fixture
def real(real_settings: Settings) -> Iterator[Clinic]:
    """A real clinic, as `serve` opens it, without an owner yet."""
    yield from running(real_settings)


@pytest.fixture
def owned(real: Clinic) -> Clinic:
    """A real clinic with its first owner, whose browser is used."""
    real.good("POST", "/auth/setup", json=OWNER)
    return real


@pytest.fixture
def start_from(settings: Settings) -> Iterator[Callable[[Path], Clinic]]:
    """Return a function that starts a copy of a made folder, with its clinician."""
    with ExitStack() as ends:

        def start(state: Path) -> Clinic:
            shutil.copytree(state, settings.state)
            clinic = ends.enter_context(contextmanager(running)(settings))
            sign_in(clinic)
            return clinic

        yield start


@pytest.fixture
def calibrated(start_from: Callable[[Path], Clinic], calibrated_state: Path) -> Clinic:
    """A demonstration with its clinician, and a calibrated patient who is here."""
    clinic = start_from(calibrated_state)
    clinic.patient = clinic.good("GET", "/session")["patient"]
    return clinic


@pytest.fixture
def signed_in(clinic: Clinic) -> Clinic:
    """A demonstration with its clinician."""
    sign_in(clinic)
    return clinic


@pytest.fixture
def in_session(signed_in: Clinic) -> Clinic:
    """A demonstration with its clinician, and a patient who is here."""
    signed_in.begin_session()
    return signed_in


@pytest.fixture
def paired(in_session: Clinic) -> Clinic:
    """A browser that is signed in and the patient's screen as well."""
    assert pair(in_session, code_of(in_session)).status_code == 200
    return in_session


@pytest.fixture
def screen(paired: Clinic) -> Clinic:
    """A browser that is the patient's screen and nothing else."""
    only(paired, "bodydrive_screen")
    return paired


@pytest.fixture
def trial(calibrated: Clinic) -> int:
    """Drive one trial, and return its id."""
    return int(calibrated.drive_trial()["id"])


@pytest.fixture
def consented(calibrated: Clinic) -> Clinic:
    """A clinic whose patient has consented to sharing today."""
    with calibrated.rows() as rows:
        rows.consent(calibrated.patient["id"], "sharing")
    return calibrated
