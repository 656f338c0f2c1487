"""What a test of backups has: a folder for them, and no rests between two reads."""

from pathlib import Path

import pytest

from app.features.backup import quiet_files


@pytest.fixture(autouse=True)
def _without_rests(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(quiet_files, "WORKING", 1.0)


@pytest.fixture
def stick(tmp_path: Path) -> Path:
    """Return an empty folder for backups."""
    folder = tmp_path / "stick"
    folder.mkdir()
    return folder
