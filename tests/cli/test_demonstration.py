"""The profile and the prior that come with the program are what their commands make today."""

import pytest
from cli.demonstration_profile import calibrated
from cli.shipped_prior import released

from app.calibration.prior.documents import ReleasedPrior
from app.calibration.prior.shipped import shipped_prior
from app.calibration.profile import CalibrationProfile
from app.cli.serve import profile_file
from app.hardware.shirt.standard import standard_layout

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


def differences(shipped, fresh):
    """Return the places at which two documents differ beyond rounding, with both values."""
    one, other = (dict(leaves(document.model_dump(mode="json"))) for document in (shipped, fresh))
    assert one.keys() == other.keys()
    return {
        place: (value, other[place])
        for place, value in one.items()
        if other[place] != (pytest.approx(value, **CLOSE) if isinstance(value, float) else value)
    }


def test_the_profile_that_comes_with_the_program_is_that_of_a_calibration():
    shipped = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    assert differences(shipped, calibrated().model_copy(update={"created": shipped.created})) == {}


@pytest.mark.long
def test_the_prior_that_comes_with_the_program_is_that_of_its_simulated_people():
    fresh = ReleasedPrior.model_validate_json(released())
    assert differences(shipped_prior(standard_layout()), fresh) == {}
