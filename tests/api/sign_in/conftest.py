"""A real clinic with its first owner, whose browser is used."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from api.fake_clinic import Clinic
from api.people_of_clinic import OWNER
from api.running_app import running

from app.settings import Settings


@pytest.fixture
def owned(tmp_path: Path) -> Iterator[Clinic]:
    for clinic in running(Settings(state=tmp_path / "owned", setup_code="set-up-code")):
        clinic.good("POST", "/auth/setup", json=OWNER)
        yield clinic
