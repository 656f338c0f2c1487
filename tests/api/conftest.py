"""A web application of its own for each test."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from fake_clinic import Clinic, running
from pairing import code_of, only, pair

from app.api.sign_in import hashing
from app.session import calibration, run_watch
from app.settings import Settings
from app.store.database import Database
from app.store.files import ballast
from app.store.people import add_clinic


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    return Settings(state=tmp_path / "state", demo_code="the-code-of-the-link")


@pytest.fixture(autouse=True)
def _light_passwords(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hashing, "COST", hashing.Cost(time=1, memory=8, lanes=1))


@pytest.fixture(autouse=True)
def _little_ballast(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ballast, "SIZE", 65_536)  # each test keeps its folder for a while


@pytest.fixture(autouse=True)
def _quick_looks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(calibration, "LOOK_EVERY", 0.002)
    monkeypatch.setattr(run_watch, "LOOK_EVERY", 0.002)


@pytest.fixture
def clinic(settings: Settings) -> Iterator[Clinic]:
    """A demonstration, nobody signed in."""
    database = Database(settings.database)
    with database.transaction() as db:
        add_clinic(db, "Demonstration")
    database.close()
    yield from running(settings)


@pytest.fixture
def signed_in(clinic: Clinic) -> Clinic:
    """A demonstration with its clinician."""
    clinic.good("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
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
