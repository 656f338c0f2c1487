"""A real chair needs the person's own movement, whatever other people have taught."""

from typing import Any

import pytest

from app.calibration.own_movement import own_movement_refusal
from app.calibration.profile import RATE_LAGS, CalibrationProfile, MapCheck, PriorMap
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.cli.demonstration import profile_file

GOOD = MapCheck(in_phase=0.95, hit_rate=0.7, false_per_minute=0.0, false_count=0)
WRONG_WAY = MapCheck(in_phase=0.1, hit_rate=0.7, false_per_minute=0.0, false_count=0)
TOO_SMALL = MapCheck(in_phase=1.0, hit_rate=0.1, false_per_minute=0.0, false_count=0)


def parameters(**of_prior: Any) -> DriveParameters:
    """Return the demonstration's parameters, with the first joint's map learnt from other people."""
    profile = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    first, *others = profile.joints
    part = (0.1,) * len(first.channels)
    prior = PriorMap(
        rate=part,
        earlier=(part,) * (len(RATE_LAGS) - 1),
        short=part,
        long=part,
        dead_zone=first.dead_zone,
        full=first.full,
        people=8,
        repetitions=3 if of_prior else 0,
        **of_prior,
    )
    joint = first.model_copy(update={"map": "prior", "prior": prior, "prompted": bool(of_prior)})
    return standard_parameters(profile.model_copy(update={"joints": (joint, *others)}))


def test_own_repetitions_that_agree_are_enough() -> None:
    assert own_movement_refusal(parameters(prior_check=GOOD, pca_check=GOOD)) == ""


@pytest.mark.parametrize("check", [None, WRONG_WAY, TOO_SMALL])
def test_without_them_the_joint_is_named(check: MapCheck | None) -> None:
    given = parameters() if check is None else parameters(prior_check=check, pca_check=GOOD)
    words = own_movement_refusal(given)
    assert words.startswith("Other people taught the movement of Right shoulder")
    assert "Calibrate page" in words


def test_a_joint_that_drives_by_the_own_calibration_needs_nothing() -> None:
    own = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    assert own_movement_refusal(standard_parameters(own)) == ""
