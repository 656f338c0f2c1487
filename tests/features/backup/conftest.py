"""Tests of backups do not rest between two reads."""

import pytest

from app.features.backup import quiet_files


@pytest.fixture(autouse=True)
def _without_rests(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(quiet_files, "WORKING", 1.0)
