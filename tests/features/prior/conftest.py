"""A clinic whose prior knows four people, made once and copied for each test."""

from collections.abc import Callable
from pathlib import Path

import pytest
from api.fake_clinic import Clinic
from features.prior.calibrated_others import calibrate_others, entry


@pytest.fixture(scope="session")
def state_with_others(make_state: Callable[[Callable[[Clinic], None]], Path]) -> Path:
    return make_state(calibrate_others)


@pytest.fixture
def with_others(start_from: Callable[[Path], Clinic], state_with_others: Path) -> Clinic:
    """A clinic with its clinician and four calibrated patients, and what the next calibration adds."""
    clinic = start_from(state_with_others)
    clinic.readings["entry"] = entry()
    return clinic
