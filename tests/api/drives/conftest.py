"""A calibrated patient, and a real chair that may be armed."""

from typing import Any

import pytest
from api.drives.chair_drives import choose_chair, practise, velocity
from api.fake_clinic import WORD, Clinic

from app.api.routes import drives


@pytest.fixture(autouse=True)
def _patient_with_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drives, "HEARD_WITHIN", 60.0)


@pytest.fixture
def calibrated(calibrated: Clinic) -> Any:
    plan = calibrated.good("GET", "/floorplans/apartment")
    calibrated.where = {  # type: ignore[attr-defined]
        "floorplan": plan["name"],
        "path": plan["paths"][0]["name"],
        "screen": WORD,
    }
    velocity(calibrated)
    return calibrated


@pytest.fixture
def ready(calibrated: Any) -> Any:
    """A chosen chair, and a practised parameter set."""
    practise(calibrated)
    choose_chair(calibrated)
    return calibrated
