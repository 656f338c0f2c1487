"""A calibrated patient, and trials that always propose something."""

from collections.abc import Callable
from typing import Any

import pytest
from api.adaptation.adapting import change
from api.fake_clinic import Clinic

from app.api.routes import drives
from app.calibration.vocabulary import DriveParameters
from app.scoring.map_losses.losses import ReadTrials
from app.session.adaptation_reading import AdaptationResult, PastRun


@pytest.fixture(autouse=True)
def _patient_with_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drives, "HEARD_WITHIN", 60.0)


@pytest.fixture
def ready(calibrated: Clinic) -> Any:
    """A calibrated patient, and trials that always propose something."""
    calibrated.asked = []  # type: ignore[attr-defined]

    def adapt(
        parameters: DriveParameters,
        _calibrated: Any,
        folders: list[Any],
        fresh: int,
        past: list[PastRun],
        _known: ReadTrials,
        _leave_off: Callable[[], bool],
    ) -> AdaptationResult:
        calibrated.past = past  # type: ignore[attr-defined]
        calibrated.asked.append((len(folders), fresh))  # type: ignore[attr-defined]
        return change(parameters)

    calibrated.readings["adapt"] = adapt
    return calibrated
