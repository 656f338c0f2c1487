"""A real chair needs the person's own movement, whatever other people have taught."""

from typing import Any

import pytest
from calibration.prior.simulated_wearers import Wearer, prior_of
from calibration.prior.test_prior_map import fitted

from app.calibration.linear_map import MapCheck
from app.calibration.own_movement import agrees, own_movement_refusal
from app.calibration.prior.map_prior import MapPrior
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.cli.serve import profile_file
from building import taught_by_others

GOOD = MapCheck(in_phase=0.95, hit_rate=0.7, false_per_minute=0.0, false_count=0)
WRONG_WAY = MapCheck(in_phase=0.1, hit_rate=0.7, false_per_minute=0.0, false_count=0)
TOO_SMALL = MapCheck(in_phase=1.0, hit_rate=0.1, false_per_minute=0.0, false_count=0)


def parameters(**of_prior: Any) -> DriveParameters:
    """Return the demonstration's parameters, with the first joint's map learnt from other people."""
    profile = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    first = profile.joints[0].name
    return standard_parameters(taught_by_others(profile, 3 if of_prior else 0, [first], **of_prior))


@pytest.mark.parametrize("repetitions", [1, 3])
@pytest.mark.parametrize("seed", [101, 102, 103])
def test_repetitions_agree_with_a_map_of_the_right_way_and_not_with_the_opposite_one(
    repetitions: int, seed: int
) -> None:
    """A person whose sensors answer the other way round turns every rate of other people's map round."""
    prior, wearer = MapPrior.of(prior_of(range(1, 9))), Wearer(seed)
    for values, right in ((wearer.values, True), (-wearer.values, False)):
        own = fitted(wearer, prior, values, prompts=repetitions).profile.joints[0].prior
        assert agrees(own) is right


def test_own_repetitions_that_agree_are_enough() -> None:
    assert own_movement_refusal(parameters(check=GOOD, pca_check=GOOD)) is None


@pytest.mark.parametrize("check", [None, WRONG_WAY, TOO_SMALL])
def test_without_them_the_joint_is_named(check: MapCheck | None) -> None:
    given = parameters() if check is None else parameters(check=check, pca_check=GOOD)
    words = str(own_movement_refusal(given))
    assert words.startswith("Other people taught the movement of right shoulder")
    assert "Calibrate page" in words


def test_a_joint_that_drives_by_the_own_calibration_needs_nothing() -> None:
    own = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    assert own_movement_refusal(standard_parameters(own)) is None
