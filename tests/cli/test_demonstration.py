"""The profile that comes with the program is what a calibration gives today."""

import pytest
from cli.demonstration_profile import calibrated

from app.calibration.profile import CalibrationProfile
from app.cli.demonstration import profile_file

# Beyond rounding by another processor or another release of LAPACK; a change of the fit is larger.
CLOSE = {"rel": 1e-6, "abs": 1e-9}


def leaves(value, place="profile"):
    """Yield each number, text and truth value of a document with its place."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from leaves(inner, f"{place}.{name}")
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from leaves(inner, f"{place}[{index}]")
    else:
        yield place, value


def test_the_profile_that_comes_with_the_program_is_that_of_a_calibration():
    shipped = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    fresh = calibrated().model_copy(update={"created": shipped.created})
    both = [dict(leaves(one.model_dump(mode="json"))) for one in (shipped, fresh)]
    assert both[0].keys() == both[1].keys()
    wrong = {
        place: (value, both[1][place])
        for place, value in both[0].items()
        if both[1][place] != (pytest.approx(value, **CLOSE) if isinstance(value, float) else value)
    }
    assert wrong == {}
