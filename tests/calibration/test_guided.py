"""The guided map on bodies made for it: where it must be better, where it cannot be made."""

import numpy as np
import pytest
from wearing import Wearer, layout_of, stroke

from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import (
    Prompt,
    Stretch,
    repetitions_of_prompts,
    repetitions_of_run,
    stretch_of_run,
    stretches_of_prompts,
)
from app.calibration.guided.guided_map import features, with_guided_maps
from app.calibration.script import calibration_script
from app.cues import cue_index

LAYOUT = layout_of(("right_elbow",))


class Deceiver(Wearer):
    """A limb that also turns on its way back, which most channels feel as they feel the movement that is asked for."""

    def __init__(self, layout, sample_rate=100.0):
        super().__init__(layout, sample_rate)
        self.second[0] = self.rng.uniform(0.0, 1.5, self.second.shape[1])

    def signals(self, angles, others=None):
        away = np.maximum(0.0, -np.gradient(angles[:, 0])) * self.sample_rate
        return super().signals(angles, away[:, np.newaxis] if others is None else others)


def recorded(wearer, count=3, lag=0.3, **how):
    """Return one recording of repetitions, and prompts that lead them by `lag` (s)."""
    path, moving = stroke(wearer.sample_rate, after=1.5, **how)
    values = wearer.signals(np.tile(path, count)[:, np.newaxis])
    rate = wearer.sample_rate
    prompts = [
        Prompt((moving.start + i * len(path)) / rate - lag, (moving.stop + i * len(path)) / rate - lag, "right_elbow")
        for i in range(count)
    ]
    return np.arange(len(values)) / rate, values, prompts


def fitted(wearer, rest=True, **how):
    t, values, prompts = recorded(wearer, **how)
    resting = wearer.rest() if rest else None
    repetitions = repetitions_of_prompts(t, values, prompts, wearer.sample_rate)
    profile = fit_profile(LAYOUT, wearer.sample_rate, wearer.free(), resting, repetitions)
    return with_guided_maps(profile, stretches_of_prompts(t, values, prompts, wearer.sample_rate), resting)


def deceiver(rate=100.0):
    return Deceiver(LAYOUT, rate)


@pytest.mark.parametrize("rate", [50.0, 100.0, 200.0])
def test_it_is_offered_where_the_main_movement_is_not_the_one_that_is_meant(rate):
    joint = fitted(deceiver(rate)).profile.joints[0]
    assert joint.map == "pca"
    assert joint.guided.is_better
    assert joint.guided.guided_check.in_phase > 0.95
    assert joint.guided.guided_check.in_phase > joint.guided.pca_check.in_phase + 0.02
    assert joint.guided.repetitions == 3
    assert joint.guided.lag == pytest.approx(0.3, abs=0.15)
    assert joint.guided.full > joint.guided.dead_zone


def test_prompted_movements_are_as_fast_as_on_the_paper_s_map():
    wearer = deceiver()
    joint = fitted(wearer).profile.joints[0]
    _, values, _ = recorded(wearer)
    rate = features(values, 100.0) @ np.concatenate((joint.guided.rate, joint.guided.short, joint.guided.long))
    assert np.percentile(rate[rate > joint.guided.dead_zone], 90) == pytest.approx(joint.full, rel=0.25)


def test_where_the_map_of_the_paper_is_perfect_it_is_not_offered():
    joint = fitted(Wearer(LAYOUT, second=0.0)).profile.joints[0]
    assert joint.guided.pca_check.in_phase > 0.97
    assert not joint.guided.is_better


def test_a_channel_that_says_nothing_gets_next_to_no_weight():
    wearer = Wearer(LAYOUT, second=0.0)
    wearer.gains[0, 2] = 0.0
    guided = fitted(wearer).profile.joints[0].guided
    share = np.abs(guided.rate) * features(recorded(wearer)[1], 100.0)[:, :5].std(axis=0)
    assert share[2] < 0.1 * share.max()


def test_the_unit_of_a_channel_does_not_matter():
    plain, large = deceiver(), deceiver()
    large.gains *= 1000.0
    large.second *= 1000.0
    large.noise *= 1000.0
    one, other = fitted(plain).profile.joints[0].guided, fitted(large).profile.joints[0].guided
    assert other.guided_check.in_phase == pytest.approx(one.guided_check.in_phase, abs=0.01)
    np.testing.assert_allclose(np.array(other.rate) * 1000.0, one.rate, rtol=0.2, atol=0.02)


def test_missing_samples_are_bridged():
    wearer = deceiver()
    t, values, prompts = recorded(wearer)
    repetitions = repetitions_of_prompts(t, values, prompts, 100.0)
    profile = fit_profile(LAYOUT, 100.0, wearer.free(), wearer.rest(), repetitions)
    values[::97, 1] = np.nan
    guided = with_guided_maps(profile, stretches_of_prompts(t, values, prompts, 100.0), wearer.rest())
    assert guided.profile.joints[0].guided.guided_check.in_phase > 0.95


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ({"count": 1}, "from 1 prompted repetition: prompt at least 3"),
        ({"count": 2}, "from 2 prompted repetitions: prompt at least 3"),
    ],
)
def test_too_few_repetitions_are_said(how, words):
    guided = fitted(deceiver(), **how)
    assert guided.profile.joints[0].guided is None
    assert words in guided.reasons["right_elbow"]


def test_without_prompts_it_is_said():
    wearer = deceiver()
    profile = fit_profile(LAYOUT, 100.0, wearer.free(), wearer.rest())
    assert "never prompted" in with_guided_maps(profile, (), wearer.rest()).reasons["right_elbow"]


def test_without_any_rest_it_is_said():
    wearer = deceiver()
    path, moving = stroke(100.0, before=0.0, after=0.0)
    values = wearer.signals(np.tile(path, 4)[:, np.newaxis])
    asked = tuple(slice(moving.start + i * len(path), moving.stop + i * len(path)) for i in range(4))
    t = np.arange(len(values)) / 100
    prompts = [Prompt(t[one.start], t[one.stop], "right_elbow") for one in asked]
    repetitions = repetitions_of_prompts(t, values, prompts, 100.0)
    profile = fit_profile(LAYOUT, 100.0, wearer.free(), None, repetitions)
    guided = with_guided_maps(profile, [Stretch("right_elbow", values, asked)])
    assert "nowhere at rest" in guided.reasons["right_elbow"]


def test_the_rest_of_one_who_trembles_raises_the_dead_zone():
    calm = fitted(deceiver()).profile.joints[0]
    wearer = deceiver()
    t, values, prompts = recorded(wearer)
    resting = wearer.rest()
    resting += 0.3 * np.sin(2 * np.pi * 2.0 * np.arange(len(resting)) / 100)[:, np.newaxis] * wearer.gains[0]
    repetitions = repetitions_of_prompts(t, values, prompts, 100.0)
    profile = fit_profile(LAYOUT, 100.0, wearer.free(), resting, repetitions)
    shaky = with_guided_maps(profile, stretches_of_prompts(t, values, prompts, 100.0), resting).profile.joints[0]
    assert shaky.guided.dead_zone > 2 * calm.guided.dead_zone


def test_a_step_of_the_application_is_one_stretch():
    wearer = deceiver()
    step = next(step for step in calibration_script(LAYOUT) if step.kind == "prompt")
    count = round(step.duration * 100)
    cue = np.array([cue_index(step.cues, i / 100) for i in range(count)])
    asked = np.array([cue >= 0 and step.cues[cue].kind == "move" for cue in cue])
    path, _ = stroke(100.0, before=0.0, after=0.0)
    angle = np.zeros(count)
    for start in np.flatnonzero(np.diff(asked.astype(int)) > 0) + 31:
        angle[start : start + len(path)] = path[: count - start]
    values = wearer.signals(angle[:, np.newaxis])
    stretch = stretch_of_run(values, cue, step.cues)
    assert [one.stop - one.start for one in stretch.moving] == [100, 100, 100]
    repetitions = repetitions_of_run(values, cue, step.cues, 100.0)
    profile = fit_profile(LAYOUT, 100.0, wearer.free(), wearer.rest(), repetitions)
    guided = with_guided_maps(profile, [stretch], wearer.rest()).profile.joints[0].guided
    assert guided.repetitions == 3
    assert guided.guided_check.in_phase > 0.95
    assert guided.lag == pytest.approx(0.3, abs=0.2)


def test_prompts_far_apart_are_two_stretches_and_nothing_later_than_said_is_taken():
    t = np.arange(6000) / 100
    prompts = [Prompt(start, start + 1.0, "right_elbow") for start in (1.0, 5.0, 30.0, 33.0)]
    first, second = stretches_of_prompts(t, np.zeros((6000, 5)), prompts, 100.0, until=35.0)
    assert first.moving == (slice(100, 200), slice(500, 600))
    assert len(first.values) == 900
    assert len(second.values) == 3500 - 2700
    assert second.moving == (slice(300, 400), slice(600, 700))
