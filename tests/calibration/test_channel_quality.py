import numpy as np
import pytest

from app.calibration.channel_quality import channel_quality

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
    assert "never changes" in quality[1].message


def test_a_channel_that_gets_stuck_is_flat(moving):
    moving[300:, 2] = moving[300, 2]
    assert conditions(moving)[2] == "flat"


def test_a_single_missing_sample_is_reported(moving):
    moving[500, 3] = np.nan
    quality = channel_quality(moving, GROUP, FS)
    assert quality[3].condition == "nan"
    assert "1 of 1000" in quality[3].message


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
    assert "upper end" in quality[0].message
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
