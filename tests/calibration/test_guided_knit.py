"""The guided map on a real knit: cues lead by 0.3 +- 0.15 s; fitted on 20 s, checked on the rest."""

import numpy as np
import pytest

from bench.learning.guided_map import FOLDER, Knit

GAIN, LOSS = 0.05, 0.03

pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="the recordings of the knit are not on this machine")


@pytest.fixture(scope="module")
def knit():
    return Knit()


def better(knit, profile, **where):
    """Return how much larger the medians over the joints are than PCA's: in-phase share, hit rate."""
    pca, guided = knit.measures(profile, "pca", **where), knit.measures(profile, "guided", **where)
    return np.median(guided, axis=0) - np.median(pca, axis=0), np.median(guided - pca, axis=0)


@pytest.mark.parametrize("seed", range(4))
def test_with_leading_cues_the_guided_map_beats_the_pca_map(knit, seed):
    fitted = knit.fit(knit.prompts(seed))
    assert fitted.reasons == {}
    of_medians, of_differences = better(knit, fitted.profile)
    for gain, change in (of_medians, of_differences):
        assert gain >= GAIN
        assert change >= -LOSS


@pytest.mark.parametrize(
    ("seed", "lag", "part"),
    [
        (1, {}, {"start": 20.0, "end": 40.0}),
        (1, {}, {"start": 70.0, "end": 90.0}),
        (1, {}, {"start": 98.0, "end": 118.0}),
        (2, {"lead": 0.0}, {}),
        (2, {"lead": 0.6}, {}),
    ],
)
def test_the_guided_map_is_better_on_other_parts_of_the_recording_and_with_another_lag(knit, seed, lag, part):
    fitted = knit.fit(knit.prompts(seed, **part, **lag), **part)
    (gain, change), _ = better(knit, fitted.profile, **part)
    assert gain >= GAIN
    assert change >= -LOSS


@pytest.mark.parametrize("rate", [50.0, 250.0])
def test_the_guided_map_is_better_at_another_sample_rate(rate):
    other = Knit(rate)
    (gain, change), _ = better(other, other.fit(other.prompts(3)).profile)
    assert gain >= GAIN
    assert change >= -LOSS


def test_the_unit_and_the_polarity_of_a_channel_change_nothing(knit):
    rows = knit.prompts(1)
    plain = knit.fit(rows).profile
    turned = knit.values * np.where(np.arange(20) % 2, 1.0, -1.0)
    other = knit.fit(rows, values=turned).profile
    np.testing.assert_allclose(knit.measures(other, "guided", values=turned), knit.measures(plain, "guided"), atol=0.02)
    large = knit.values * np.where(np.arange(20) % 5 == 0, 1000.0, 1.0)  # PCA then sees this channel only
    scaled = knit.fit(rows, values=large).profile
    assert np.median(knit.measures(scaled, "guided", values=large)[:, 0]) > 0.9


def test_a_dead_channel_does_not_enter(knit):
    values = knit.values.copy()
    values[:, [1, 6]] = 3.0
    profile = knit.fit(knit.prompts(1), values=values).profile
    assert {"right_elbow_1", "left_elbow_1"} <= set(profile.left_out)
    (gain, _), _ = better(knit, profile, values=values)
    assert gain > 0.0


def test_two_repetitions_are_too_few(knit):
    fitted = knit.fit(knit.prompts(0, most=2))
    assert all(joint.guided is None for joint in fitted.profile.joints)
    assert all("2 prompted repetitions" in str(reason) for reason in fitted.reasons.values())
