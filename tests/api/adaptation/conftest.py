"""A calibrated patient, and trials that always propose something."""

from typing import Any

import pytest
from api.adaptation.adapting import change
from api.drives.conftest import _patient_with_this_machine  # noqa: F401  (a fixture)
from api.fake_clinic import Clinic

from app.calibration.vocabulary import DriveParameters
from app.session.adaptation_reading import AdaptationResult, PastRun


@pytest.fixture
def ready(calibrated: Clinic) -> Any:
    """A calibrated patient, and trials that always propose something."""
    calibrated.asked = []  # type: ignore[attr-defined]

    def adapt(
        parameters: DriveParameters, _calibrated: Any, folders: list[Any], fresh: int, past: list[PastRun], *_: Any
    ) -> AdaptationResult:
        calibrated.past = past  # type: ignore[attr-defined]
        calibrated.asked.append((len(folders), fresh))  # type: ignore[attr-defined]
        return change(parameters)

    calibrated.readings["adapt"] = adapt
    return calibrated
