"""The channels of a calibration: their quality, their statistics, and those that are named and left out."""

import numpy as np
import pytest
from calibration.simulated_person import SimulatedPerson, calibrate, layout_of
from hypothesis import example, given, settings
from hypothesis import strategies as st

from app.calibration.channel_quality import channel_quality
from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import channel_noise, fit_profile, joints_without_map, movement_covariance
from app.calibration.fit.repetitions import Stretch
from app.calibration.profile import CalibrationProfile

LAYOUT = layout_of()


@pytest.fixture
def person():
    return SimulatedPerson(LAYOUT)


@settings(max_examples=15, deadline=None)
@example(bad={0, 1, 2, 3, 4}, how="some")
@given(bad=st.sets(st.integers(0, 19), max_size=6), how=st.sampled_from(["all", "some", "dead"]))
def test_broken_channels_are_named_and_kept_out(bad, how):
    person = SimulatedPerson(LAYOUT, seed=5)
    free = person.free()
    columns = sorted(bad)
    if how == "dead":
        free[:, columns] = 7.5
    else:
        free[slice(None) if how == "all" else slice(300, 330), columns] = np.nan
    profile = calibrate(person, free=free)
    without_good = {name: set(channels) for name, channels in LAYOUT.channels_of_joint.items() if set(channels) <= bad}
    if how == "some":  # few samples are missing: a joint that has no better channels keeps these
        bad = bad.difference(*without_good.values())
        without_good = {}
    assert sorted(profile.left_out) == sorted(LAYOUT.channels[i].name for i in bad)
    for joint in profile.joints:
        assert not set(joint.channels) & bad
        assert np.isfinite(joint.direction).all()
    assert set(joints_without_map(profile)) == set(without_good)


def test_lost_frames_do_no_harm(person):
    free = person.free()
    whole = calibrate(person, free=free)
    free[400:410] = np.nan
    holed = calibrate(person, free=free)
    assert holed.left_out == {}
    for one, other in zip(whole.joints, holed.joints, strict=True):
        assert other.span == pytest.approx(one.span, rel=0.02)


def test_channels_marked_as_unused_are_left_out(person):
    profile = calibrate(person, unused={"left_elbow_2"})
    assert {name: str(reason) for name, reason in profile.left_out.items()} == {"left_elbow_2": "marked as unused"}
    assert "Sensors left out: 1 of 5" in str(profile.joints[1].description)


def test_near_railed_channels_stay_only_when_the_joint_has_no_better_one(person):
    free = person.free()
    reach = np.abs(free).max(axis=0)
    free *= np.where(np.arange(20) < 5, 80.0, 20.0) / reach
    free[:, 5] *= 4
    profile = fit_profile(CleanRecording.of(LAYOUT, 100.0, free=free, full_scale=100.0))
    assert list(profile.left_out) == ["left_elbow_0"]
    assert profile.joints[0].channels == (0, 1, 2, 3, 4)


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


def test_every_piece_is_without_gaps_and_a_channel_with_too_many_is_left_out():
    person = SimulatedPerson(LAYOUT)
    free, rest, repetitions = person.free(), person.rest(), person.repetitions()
    free[100:105, 1] = np.nan
    free[:, 3] = np.nan
    stretch = Stretch("right_elbow", free[50:150], (slice(10, 60),))
    clean = CleanRecording.of(LAYOUT, 100.0, free, rest, repetitions, [stretch])
    pieces = [clean.free, clean.rest, *(one.values for one in (*clean.repetitions, *clean.stretches))]
    assert all(np.isfinite(piece).all() for piece in pieces)
    np.testing.assert_array_equal(np.diff(clean.free[99:106, 1], n=2), pytest.approx(0.0, abs=1e-9))
    assert list(clean.left_out) == [LAYOUT.channel_names[3]]
    assert np.isnan(free[100:105, 1]).all(), "the recording itself stays as it was"


def test_the_pieces_of_a_joint_are_found_by_its_name_and_prompts_can_be_cut_anew():
    person = SimulatedPerson(LAYOUT)
    clean = CleanRecording.of(LAYOUT, 100.0, person.free(), None, person.repetitions())
    assert {one.joint for one in clean.repetitions_of("left_elbow")} == {"left_elbow"}
    assert clean.stretches_of("left_elbow") == []
    values = person.free()
    values[7, 0] = np.nan
    again = clean.with_stretches([Stretch("left_elbow", values, (slice(0, 50),))])
    assert np.isfinite(again.stretches_of("left_elbow")[0].values).all()
    assert again.left_out is clean.left_out


FS = 100.0
GROUP = [[0, 1, 2, 3, 4]]


@pytest.fixture
def moving():
    """Return ten seconds of one joint with five channels that follow it."""
    rng = np.random.default_rng(3)
    t = np.arange(1000) / FS
    return np.sin(3 * t)[:, np.newaxis] * np.array([1, 0.8, -0.6, 0.3, 0.1]) + 0.005 * rng.normal(size=(1000, 5))


def conditions(values, **how):
    return [quality.condition for quality in channel_quality(values, GROUP, FS, **how)]


def test_channels_that_follow_are_good(moving):
    assert conditions(moving) == ["good"] * 5
    assert conditions(moving, full_scale=10.0) == ["good"] * 5


def test_a_dead_channel_is_flat_with_its_reason(moving):
    moving[:, 1] = 0.25
    quality = channel_quality(moving, GROUP, FS)
    assert [one.condition for one in quality] == ["good", "flat", "good", "good", "good"]
    assert "never changes" in str(quality[1].message)


def test_a_channel_that_gets_stuck_is_flat(moving):
    moving[300:, 2] = moving[300, 2]
    assert conditions(moving)[2] == "flat"


def test_a_single_missing_sample_is_reported(moving):
    moving[500, 3] = np.nan
    quality = channel_quality(moving, GROUP, FS)
    assert quality[3].condition == "nan"
    assert "1 of 1000" in str(quality[3].message)


def test_lost_frames_are_no_channels_fault(moving):
    moving[500:520] = np.nan
    assert conditions(moving) == ["good"] * 5


def test_nothing_but_missing_numbers():
    assert conditions(np.full((100, 5), np.nan)) == ["nan"] * 5


def test_rails_by_the_shirts_own_range(moving):
    scaled = moving / np.abs(moving).max(axis=0) * np.array([95, 80, 70, 10, 1])
    assert conditions(scaled, full_scale=100.0) == ["railed", "near", "good", "good", "good"]


def test_clipping_shows_without_knowing_the_range(moving):
    moving[:, 0] = np.minimum(moving[:, 0], 0.8)
    quality = channel_quality(moving, GROUP, FS)
    assert quality[0].condition == "railed"
    assert "upper end" in str(quality[0].message)
    assert [one.condition for one in quality[1:]] == ["good"] * 4


def test_noise_that_matters_is_named_and_weak_noise_is_not(moving):
    rng = np.random.default_rng(5)
    moving[:, 1] = 0.5 * rng.normal(size=1000)
    moving[:, 4] = 0.005 * rng.normal(size=1000)
    assert conditions(moving) == ["good", "noisy", "good", "good", "good"]


def test_no_channel_is_marked_when_the_joint_did_not_move():
    assert conditions(np.random.default_rng(1).normal(size=(1000, 5))) == ["good"] * 5


def test_a_rest_without_any_noise_is_not_flat(moving):
    """A recording made by a program has no noise, and all channels are still together."""
    t = np.arange(1000) / FS
    clean = np.maximum(0, np.sin(t))[:, np.newaxis] * np.array([1, 0.8, 0.6, 0.3, 0.1])
    assert conditions(clean) == ["good"] * 5


def test_coarse_steps_are_not_clipping(moving):
    assert conditions(np.round(moving * 8) / 8 + 0.0)[0] == "good"
