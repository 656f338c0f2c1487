"""Ranges follow a shirt that was put on again, as ten seconds of free movement tell."""

import numpy as np
import pytest
from calibration.adaptation.driven_trial import trial
from calibration.simulated_person import JOINTS, SimulatedPerson, calibrate, layout_of
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.adaptation.donning_range import LARGEST_RATIO, fit_ranges
from app.calibration.adaptation.movement import Movement


def widths(profile):
    return np.array(profile.high) - np.array(profile.low)


def middles(profile):
    return (np.array(profile.high) + np.array(profile.low)) / 2


@pytest.fixture
def person():
    return SimulatedPerson(layout_of(), seed=3)


@pytest.fixture
def profile(person):
    return calibrate(person)


def test_levels_and_stronger_channels_are_followed(person, profile) -> None:
    width = widths(profile)
    person.offsets += 0.4
    person.gains[0, 1] *= 1.5
    fitted = fit_ranges(profile, trial(person), profile)
    moved = trial(person).values[:, :5]
    assert (moved >= np.array(fitted.low)[:5] - 0.25 * width[:5]).all()
    assert (moved <= np.array(fitted.high)[:5] + 0.25 * width[:5]).all()
    ratio = widths(fitted)[:5] / width[:5]
    assert ratio[1] == ratio.max() > 1.2
    change = middles(fitted) - middles(profile)
    for joint, other in zip(profile.joints, fitted.joints, strict=True):
        assert np.array(other.mean) - np.array(joint.mean) == pytest.approx(change[list(joint.channels)])
        assert joint.pca == other.pca


def test_the_size_of_the_movements_says_nothing_about_the_shirt(person, profile) -> None:
    ratio = widths(fit_ranges(profile, trial(person, size=0.4), profile)) / widths(profile)
    assert ratio.max() < 1.2


def test_a_loose_channel_keeps_the_range_that_finds_it(person, profile) -> None:
    driven = trial(person)
    driven.values[:, 3] = 5.0 + 0.1 * np.sin(np.arange(len(driven.values)) * 1.7)
    fitted = fit_ranges(profile, driven, profile)
    assert (fitted.low[3], fitted.high[3]) == (profile.low[3], profile.high[3])
    assert not profile.low[3] <= 5.0 <= profile.high[3]


def test_without_movement_nothing_changes(profile) -> None:
    nothing = Movement(np.zeros((0, len(profile.low))), profile.sample_rate, np.zeros(0, dtype=bool))
    assert fit_ranges(profile, nothing, profile) == profile
    still = Movement(np.ones((500, len(profile.low))), profile.sample_rate, np.zeros(500, dtype=bool))
    assert fit_ranges(profile, still, profile) == profile


@given(st.integers(0, 1000), st.floats(0.0, 1.0), st.floats(-20.0, 20.0))
@settings(max_examples=10, deadline=None)
def test_no_range_shrinks_doubles_more_than_once_or_goes_further_than_its_width(seed, share, offset) -> None:
    person = SimulatedPerson(layout_of(), seed=3)
    profile = calibrate(person)
    rng = np.random.default_rng(seed)
    person.gains = person.gains * np.exp(share * rng.normal(size=person.gains.shape))
    person.offsets += offset * rng.normal(size=person.offsets.shape)
    driven = trial(person, repetitions=1, joints=JOINTS[:2])
    once = fit_ranges(profile, driven, profile)
    ratio = widths(once) / widths(profile)
    assert (ratio >= 1.0 - 1e-9).all()
    assert (ratio <= LARGEST_RATIO + 1e-9).all()
    assert (np.abs(middles(once) - middles(profile)) <= widths(profile) * (1 + 1e-9)).all()
    again = fit_ranges(once, driven, profile)
    assert np.allclose(widths(again), widths(once))  # fitting twice adds nothing up
