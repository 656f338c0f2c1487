"""What a test of archives has: an import is made in the process of the test."""

import pytest
from session.same_process import SameProcess

from app.features.archive import archive_import, routes


@pytest.fixture(autouse=True)
def _imported_here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(routes, "ComputingProcess", SameProcess)
    monkeypatch.setattr(archive_import, "limit_memory", lambda: None)
