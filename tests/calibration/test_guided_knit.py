"""The guided map on a real knit: cues lead by 0.3 +- 0.15 s; fitted on 20 s, checked on the rest."""

import numpy as np
import pytest
from test_knit_shirt import FOLDER, JOINTS, LAYOUT, RISING

from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Prompt, repetitions_of_prompts, stretches_of_prompts
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.vocabulary import standard_parameters
from app.pipeline.replay.batch import decode_block
from app.signals.columns import read_columns
from app.signals.signals import read_signals
from app.signals.smoothing import smooth

LARGE = 0.3  # of the angle's span: what is counted as a movement when hits are
GAIN, LOSS = 0.05, 0.03

pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="the recordings of the knit are not on this machine")


class Knit:
    """The recordings at a sample rate, the measured rising phases, and prompts made from them."""

    def __init__(self, rate=100.0):
        signals = read_signals(FOLDER / "signals.csv", LAYOUT)
        angles = read_columns(FOLDER / "joint_angles.csv", only=JOINTS)
        self.rate = rate
        self.t = np.arange(0.0, signals.t[-1], 1 / rate)
        self.values = np.stack([np.interp(self.t, signals.t, one) for one in signals.values.T], axis=1)
        self.rising, self.phases = {}, {}
        for joint in JOINTS:
            angle = np.interp(self.t, signals.t, angles[joint])
            smoothed = smooth(angle, 3.0, rate)
            rising = np.diff(smoothed, prepend=smoothed[0]) * rate / np.ptp(angle) > RISING
            edges = np.flatnonzero(np.diff(np.concatenate(([0], rising, [0]))))
            phases = [(a, b) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a > 0.1 * rate]
            self.rising[joint] = rising
            self.phases[joint] = [(a, b, (smoothed[b - 1] - smoothed[a]) / np.ptp(angle)) for a, b in phases]

    def prompts(self, seed, start=0.0, end=20.0, lead=0.3, spread=0.15, most=None):
        rng = np.random.default_rng(seed)
        rows = []
        for joint in JOINTS:
            within = [(a / self.rate, b / self.rate) for a, b, _ in self.phases[joint]]
            for a, b in [(a, b) for a, b in within if a > start + lead and b < end][:most]:
                by = rng.normal(lead, spread)
                rows.append(Prompt(max(start, a - by), b - by, joint))
        return rows

    def fit(self, rows, start=0.0, end=20.0, values=None):
        values = self.values if values is None else values
        window = (self.t >= start) & (self.t < end)
        repetitions = repetitions_of_prompts(self.t, values, rows, self.rate)
        profile = fit_profile(LAYOUT, self.rate, free=values[window], repetitions=repetitions)
        return with_guided_maps(profile, stretches_of_prompts(self.t, values, rows, self.rate, until=end))

    def measures(self, profile, kind, start=0.0, end=20.0, values=None):
        """Return per joint in-phase share, and hit rate in time, outside of the window, as `decode` gives them."""
        joints = [joint.model_copy(update={"map": kind if joint.guided else "pca"}) for joint in profile.joints]
        parameters = standard_parameters(profile.model_copy(update={"joints": tuple(joints)}))
        values = self.values if values is None else values
        decoded = decode_block(parameters, self.rate, self.t, values.astype(np.float32))
        outside = (self.t < start) | (self.t >= end)
        shares = []
        for gesture, activation in zip(parameters.gestures, decoded.activation.T, strict=True):
            measures = np.where(outside, activation, 0.0)
            moving = np.zeros(len(self.t), dtype=bool)
            for a, b, size in self.phases[gesture.joint]:
                moving[a:b] = size > LARGE and outside[a] and outside[b - 1]
            shares.append((measures[self.rising[gesture.joint]].sum() / measures.sum(), (measures[moving] > 0).mean()))
        return np.array(shares)


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


@pytest.mark.parametrize(("start", "end"), [(20.0, 40.0), (70.0, 90.0), (98.0, 118.0)])
def test_the_guided_map_is_better_on_other_parts_of_the_recording(knit, start, end):
    fitted = knit.fit(knit.prompts(1, start, end), start, end)
    (gain, change), _ = better(knit, fitted.profile, start=start, end=end)
    assert gain >= GAIN
    assert change >= -LOSS


@pytest.mark.parametrize("lead", [0.0, 0.6])
def test_the_guided_map_is_better_with_another_lag(knit, lead):
    fitted = knit.fit(knit.prompts(2, lead=lead))
    (gain, change), _ = better(knit, fitted.profile)
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
    assert all("2 prompted repetitions" in reason for reason in fitted.reasons.values())
