"""The guided map on simulated joints: where it must be better, and where it cannot be made."""

import numpy as np
import pytest
from calibration.simulated_person import SimulatedPerson, layout_of, stroke

from app.calibration.clean_recording import CleanRecording
from app.calibration.features import features
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import (
    Prompt,
    Stretch,
    repetitions_of_prompts,
    repetitions_of_run,
    stretch_of_run,
    stretches_of_prompts,
)
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.script import calibration_script
from app.cues import cue_index

LAYOUT = layout_of(("right_elbow",))


class Deceiver(SimulatedPerson):
    """A limb that also rotates on its way back, which most channels measure like the prompted movement."""

    def __init__(self, layout, sample_rate=100.0):
        super().__init__(layout, sample_rate)
        self.second[0] = self.rng.uniform(0.0, 1.5, self.second.shape[1])

    def signals(self, angles, others=None):
        away = np.maximum(0.0, -np.gradient(angles[:, 0])) * self.sample_rate
        return super().signals(angles, away[:, np.newaxis] if others is None else others)


def recorded(person, count=3, lag=0.3, **how):
    """Return one recording of repetitions, and prompts that lead them by `lag` (s)."""
    path, moving = stroke(person.sample_rate, after=1.5, **how)
    values = person.signals(np.tile(path, count)[:, np.newaxis])
    rate = person.sample_rate
    prompts = [
        Prompt((moving.start + i * len(path)) / rate - lag, (moving.stop + i * len(path)) / rate - lag, "right_elbow")
        for i in range(count)
    ]
    return np.arange(len(values)) / rate, values, prompts


def fitted(person, rest=True, **how):
    t, values, prompts = recorded(person, **how)
    resting = person.rest() if rest else None
    repetitions = repetitions_of_prompts(t, values, prompts, person.sample_rate)
    stretches = stretches_of_prompts(t, values, prompts, person.sample_rate)
    return guided(CleanRecording.of(LAYOUT, person.sample_rate, person.free(), resting, repetitions, stretches))


def guided(recording):
    """Return the profile of a recording with guided maps, and why joints have none."""
    return with_guided_maps(fit_profile(recording), recording)


def misleading_limb(rate=100.0):
    return Deceiver(LAYOUT, rate)


@pytest.mark.parametrize("rate", [50.0, 100.0, 200.0])
def test_a_guided_map_is_offered_where_the_main_movement_is_not_the_prompted_one(rate):
    joint = fitted(misleading_limb(rate)).profile.joints[0]
    assert joint.map == "pca"
    assert joint.guided.is_better
    assert joint.guided.check.in_phase > 0.95
    assert joint.guided.check.in_phase > joint.guided.pca_check.in_phase + 0.02
    assert joint.guided.repetitions == 3
    assert joint.guided.lag == pytest.approx(0.3, abs=0.15)
    assert joint.guided.full > joint.guided.dead_zone


def test_prompted_movements_are_as_fast_as_on_the_paper_s_map():
    person = misleading_limb()
    joint = fitted(person).profile.joints[0]
    _, values, _ = recorded(person)
    rate = features(values, 100.0) @ np.concatenate(joint.guided.parts)
    assert np.percentile(rate[rate > joint.guided.dead_zone], 90) == pytest.approx(joint.pca.full, rel=0.25)


def test_no_guided_map_is_offered_where_the_pca_map_is_perfect():
    joint = fitted(SimulatedPerson(LAYOUT, second=0.0)).profile.joints[0]
    assert joint.guided.pca_check.in_phase > 0.97
    assert not joint.guided.is_better


def test_a_channel_without_signal_gets_nearly_no_weight():
    person = SimulatedPerson(LAYOUT, second=0.0)
    person.gains[0, 2] = 0.0
    guided = fitted(person).profile.joints[0].guided
    share = np.abs(guided.rates[0]) * features(recorded(person)[1], 100.0)[:, :5].std(axis=0)
    assert share[2] < 0.1 * share.max()


def test_the_unit_of_a_channel_does_not_matter():
    plain, large = misleading_limb(), misleading_limb()
    large.gains *= 1000.0
    large.second *= 1000.0
    large.noise *= 1000.0
    one, other = fitted(plain).profile.joints[0].guided, fitted(large).profile.joints[0].guided
    assert other.check.in_phase == pytest.approx(one.check.in_phase, abs=0.01)
    np.testing.assert_allclose(np.array(other.rates) * 1000.0, one.rates, rtol=0.2, atol=0.02)


def test_missing_samples_are_bridged():
    person = misleading_limb()
    t, values, prompts = recorded(person)
    repetitions = repetitions_of_prompts(t, values, prompts, 100.0)
    values[::97, 1] = np.nan
    stretches = stretches_of_prompts(t, values, prompts, 100.0)
    fit = guided(CleanRecording.of(LAYOUT, 100.0, person.free(), person.rest(), repetitions, stretches))
    assert fit.profile.joints[0].guided.check.in_phase > 0.95


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ({"count": 1}, "from 1 prompted repetition: prompt at least 3"),
        ({"count": 2}, "from 2 prompted repetitions: prompt at least 3"),
    ],
)
def test_too_few_repetitions_are_a_reason(how, words):
    guided = fitted(misleading_limb(), **how)
    assert guided.profile.joints[0].guided is None
    assert words in guided.reasons["right_elbow"]


def test_missing_prompts_are_a_reason():
    person = misleading_limb()
    clean = CleanRecording.of(LAYOUT, 100.0, person.free(), person.rest())
    assert "never prompted" in guided(clean).reasons["right_elbow"]


def test_missing_rest_is_a_reason():
    person = misleading_limb()
    path, moving = stroke(100.0, before=0.0, after=0.0)
    values = person.signals(np.tile(path, 4)[:, np.newaxis])
    asked = tuple(slice(moving.start + i * len(path), moving.stop + i * len(path)) for i in range(4))
    t = np.arange(len(values)) / 100
    prompts = [Prompt(t[one.start], t[one.stop], "right_elbow") for one in asked]
    repetitions = repetitions_of_prompts(t, values, prompts, 100.0)
    stretches = [Stretch("right_elbow", values, asked)]
    clean = CleanRecording.of(LAYOUT, 100.0, person.free(), None, repetitions, stretches)
    assert "nowhere at rest" in guided(clean).reasons["right_elbow"]


def test_tremor_at_rest_raises_the_dead_zone():
    calm = fitted(misleading_limb()).profile.joints[0]
    person = misleading_limb()
    t, values, prompts = recorded(person)
    resting = person.rest()
    resting += 0.3 * np.sin(2 * np.pi * 2.0 * np.arange(len(resting)) / 100)[:, np.newaxis] * person.gains[0]
    repetitions = repetitions_of_prompts(t, values, prompts, 100.0)
    stretches = stretches_of_prompts(t, values, prompts, 100.0)
    shaky = guided(CleanRecording.of(LAYOUT, 100.0, person.free(), resting, repetitions, stretches)).profile.joints[0]
    assert shaky.guided.dead_zone > 2 * calm.guided.dead_zone


def test_a_step_of_the_application_is_one_stretch():
    person = misleading_limb()
    step = next(step for step in calibration_script(LAYOUT) if step.kind == "prompt")
    count = round(step.duration * 100)
    cue = np.array([cue_index(step.cues, i / 100) for i in range(count)])
    asked = np.array([cue >= 0 and step.cues[cue].kind == "move" for cue in cue])
    path, _ = stroke(100.0, before=0.0, after=0.0)
    angle = np.zeros(count)
    for start in np.flatnonzero(np.diff(asked.astype(int)) > 0) + 31:
        angle[start : start + len(path)] = path[: count - start]
    values = person.signals(angle[:, np.newaxis])
    stretch = stretch_of_run(values, cue, step.cues)
    assert [one.stop - one.start for one in stretch.moving] == [100, 100, 100]
    repetitions = repetitions_of_run(values, cue, step.cues, 100.0)
    clean = CleanRecording.of(LAYOUT, 100.0, person.free(), person.rest(), repetitions, [stretch])
    learnt = guided(clean).profile.joints[0].guided
    assert learnt.repetitions == 3
    assert learnt.check.in_phase > 0.95
    assert learnt.lag == pytest.approx(0.3, abs=0.2)


def test_prompts_far_apart_are_two_stretches_which_end_at_the_given_time():
    t = np.arange(6000) / 100
    prompts = [Prompt(start, start + 1.0, "right_elbow") for start in (1.0, 5.0, 30.0, 33.0)]
    first, second = stretches_of_prompts(t, np.zeros((6000, 5)), prompts, 100.0, until=35.0)
    assert first.moving == (slice(100, 200), slice(500, 600))
    assert len(first.values) == 900
    assert len(second.values) == 3500 - 2700
    assert second.moving == (slice(300, 400), slice(600, 700))
