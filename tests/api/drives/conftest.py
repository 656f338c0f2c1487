"""A calibrated patient, and a real chair that may be armed."""

from typing import Any

import pytest
from api.fake_clinic import Clinic

from app.api.routes import drives


@pytest.fixture(autouse=True)
def _patient_with_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drives, "HEARD_WITHIN", 60.0)


@pytest.fixture
def calibrated(calibrated: Clinic) -> Any:
    calibrated.set_controls(mode_u1="velocity")
    return calibrated


@pytest.fixture
def ready(calibrated: Any) -> Any:
    """A chosen chair, and a practised parameter set."""
    calibrated.drive_trial()
    calibrated.choose_chair(forward=0.5)
    return calibrated
