"""An earlier calibration is fitted to the shirt as it sits today: ranges follow, a turned ring is refused."""

import numpy as np
import pytest
from calibration.prior.simulated_wearers import RATE, Wearer, prior_of, sleeve

from app.calibration.adaptation.donning_fit import DonningError, fit_to_donning, joints_followed
from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.linear_map import Arrangement
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import with_prior_maps
from app.calibration.vocabulary import standard_parameters
from app.pipeline.replay.batch import decode_block

TEN_SECONDS = round(10 * RATE)


@pytest.fixture(scope="module")
def others():
    return MapPrior.of(prior_of(range(1, 9)))


@pytest.fixture(scope="module")
def wearer():
    return Wearer(102)


def calibrated(wearer, others=None, values=None, layout=None):
    free = (wearer.values if values is None else values)[:TEN_SECONDS]
    clean = CleanRecording.of(layout or sleeve(), RATE, free=free)
    profile = fit_profile(clean)
    return profile if others is None else with_prior_maps(profile, others, clean).profile


def active(parameters, wearer, values):
    """Return the share of frames in which the gesture acts."""
    return float((decode_block(parameters, RATE, wearer.t, values.astype(np.float32)).activation[:, 0] > 0).mean())


def test_a_shirt_put_on_again_drives_as_before(wearer):
    profile = calibrated(wearer)
    parameters = standard_parameters(profile)
    reach = np.array(profile.high) - np.array(profile.low)
    today = wearer.values + 0.9 * reach  # every channel lies where S5 takes it for a broken one
    fitted = fit_to_donning(parameters, profile, today[:TEN_SECONDS], RATE)
    before = active(parameters, wearer, wearer.values)
    assert before > 0.05
    assert active(parameters, wearer, today) < 0.2 * before
    assert active(fitted, wearer, today) == pytest.approx(before, rel=0.1)
    assert joints_followed(parameters.profile, fitted.profile) == ["right_elbow"]


def test_controls_thresholds_and_weights_stay(wearer):
    profile = calibrated(wearer)
    parameters = standard_parameters(profile)
    fitted = fit_to_donning(parameters, profile, wearer.values[:TEN_SECONDS] + 1.0, RATE)
    assert fitted.model_dump(exclude={"profile"}) == parameters.model_dump(exclude={"profile"})
    joint, other = fitted.profile.joints[0], profile.joints[0]
    kept = {"mean"}
    assert joint.model_dump(exclude=kept) == other.model_dump(exclude=kept)


def test_fitted_twice_is_fitted_once(wearer):
    profile = calibrated(wearer)
    free = wearer.values[:TEN_SECONDS] + 1.0
    once = fit_to_donning(standard_parameters(profile), profile, free, RATE)
    twice = fit_to_donning(once, profile, free, RATE)
    assert joints_followed(once.profile, twice.profile) == []
    assert np.array(twice.profile.joints[0].mean) == pytest.approx(np.array(once.profile.joints[0].mean))


def test_another_sample_rate_is_refused(wearer):
    profile = calibrated(wearer)
    with pytest.raises(DonningError, match="another rate"):
        fit_to_donning(standard_parameters(profile), profile, wearer.values[:TEN_SECONDS], 2 * RATE)


@pytest.mark.parametrize("shift", [1, 2, 3, 4])
def test_a_ring_that_was_turned_since_is_refused_with_its_way_back(wearer, others, shift):
    profile = calibrated(wearer, others)
    turned = np.roll(wearer.values[:TEN_SECONDS], shift, axis=1)
    with pytest.raises(DonningError, match=f"right elbow the shirt is turned by {min(shift, 5 - shift)} of 5 sensors"):
        fit_to_donning(standard_parameters(profile), profile, turned, RATE, others)


def test_a_ring_that_sits_as_it_was_calibrated_is_fitted_though_others_wear_it_otherwise(wearer, others):
    turned = np.roll(wearer.values, 1, axis=1)
    profile = calibrated(wearer, others, turned)
    assert profile.joints[0].prior.arrangement == {"cuff": Arrangement(shift=1)}
    fit_to_donning(standard_parameters(profile), profile, turned[:TEN_SECONDS], RATE, others)


def test_a_ring_that_was_left_as_worn_may_look_so_again(wearer, others):
    turned = np.roll(wearer.values[:TEN_SECONDS], 1, axis=1)
    clean = CleanRecording.of(sleeve(), RATE, turned)
    profile = with_prior_maps(calibrated(wearer, values=turned), others, clean, as_worn=("cuff",)).profile
    fit_to_donning(standard_parameters(profile), profile, turned, RATE, others)
    with pytest.raises(DonningError, match="is turned by 1 of 5 sensors"):
        fit_to_donning(standard_parameters(profile), profile, wearer.values[:TEN_SECONDS], RATE, others)


def test_where_the_calibration_knew_no_others_nothing_is_said_of_rings(wearer, others):
    profile = calibrated(wearer)
    turned = np.roll(wearer.values[:TEN_SECONDS], 1, axis=1)
    fit_to_donning(standard_parameters(profile), profile, turned, RATE, others)


def test_a_calibration_from_before_the_layout_had_rings_is_fitted(wearer, others):
    profile = calibrated(wearer, others, layout=sleeve(ring=False))
    fit_to_donning(standard_parameters(profile), profile, wearer.values[:TEN_SECONDS], RATE, others)
