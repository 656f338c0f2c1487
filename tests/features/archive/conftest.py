"""What a test of archives has: an archive, a clinic for it, and an import that is made in the process of the test."""

from pathlib import Path

import pytest
from features.archive.archive_clinics import archived_clinic, empty_clinic
from session.same_process import SameProcess

from app.features.archive import archive_import, routes
from app.settings import Settings


@pytest.fixture(autouse=True)
def _imported_here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(routes, "ComputingProcess", SameProcess)
    monkeypatch.setattr(archive_import, "limit_memory", lambda: None)


@pytest.fixture(scope="session")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the archive of a patient of another clinic."""
    return archived_clinic(tmp_path_factory.mktemp("from"))


@pytest.fixture
def other(tmp_path: Path) -> Settings:
    """Return a clinic to which archives are brought."""
    return empty_clinic(tmp_path / "other")
