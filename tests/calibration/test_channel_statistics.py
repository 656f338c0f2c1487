"""The covariance of a joint's channels, and the noise of each channel, as a profile keeps them."""

import numpy as np
import pytest
from calibration.simulated_person import SimulatedPerson, calibrate, layout_of

from app.calibration.fit.profile_fit import channel_noise, movement_covariance
from app.calibration.profile import CalibrationProfile


def test_the_covariance_is_that_of_movement_and_not_of_drift_between_pieces():
    rng = np.random.default_rng(1)
    mixing = rng.normal(size=(2, 4))
    pieces = [rng.normal(size=(3000, 2)) @ mixing + level for level in (0.0, 50.0)]
    covariance = np.array(movement_covariance((0, 1, 2, 3), pieces))
    np.testing.assert_allclose(covariance, mixing.T @ mixing, atol=0.15 * np.abs(mixing.T @ mixing).max())
    np.testing.assert_array_equal(covariance, covariance.T)


@pytest.mark.parametrize("sample_rate", [20.0, 100.0, 500.0])
def test_noise_is_measured_also_while_somebody_moves_and_drifts(sample_rate):
    t = np.arange(round(10 * sample_rate)) / sample_rate
    noise = np.array([0.01, 0.2])
    moving = np.outer(np.sin(2 * np.pi * 0.1 * t) + 0.3 * t, [1.0, 2.0])
    measured = channel_noise(moving + noise * np.random.default_rng(2).normal(size=(len(t), 2)), sample_rate)
    assert measured == pytest.approx(noise, rel=0.4)
    assert channel_noise(np.ones((300, 2)), sample_rate) == (0.0, 0.0)


def test_a_calibration_stores_both():
    profile = calibrate(SimulatedPerson(layout_of()))
    assert profile.noise == pytest.approx([0.006] * 20, rel=0.4)
    for joint in profile.joints:
        deviation = np.sqrt(np.diag(np.array(joint.covariance)))
        assert (deviation > 0.1).all()
    assert CalibrationProfile.model_validate_json(profile.model_dump_json()) == profile


@pytest.mark.parametrize(
    ("covariance", "words"),
    [
        ([[1.0, 0.0]], "must have 5 rows of 5 numbers"),
        ([[1.0, 0.5, 0, 0, 0], *([[0.0] * 5] * 4)], "must be symmetric"),
        ([[-1.0, 0, 0, 0, 0], *([[0.0] * 5] * 4)], "has a variance below 0"),
    ],
)
def test_a_covariance_that_cannot_be_one_is_refused(covariance, words):
    document = calibrate(SimulatedPerson(layout_of())).model_dump(mode="json")
    document["joints"][1]["covariance"] = [[float(value) for value in row] for row in covariance]
    with pytest.raises(ValueError, match=words):
        CalibrationProfile.model_validate(document)


def test_noise_of_another_number_of_channels_is_refused():
    document = calibrate(SimulatedPerson(layout_of())).model_dump(mode="json")
    document["noise"] = [0.1] * 19
    with pytest.raises(ValueError, match="noise must have 20 numbers"):
        CalibrationProfile.model_validate(document)
