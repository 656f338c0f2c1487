"""The guided map on simulated joints: its labels, its checks, where it must be better, and where it cannot be made."""

import numpy as np
import pytest
from calibration.simulated_person import SimulatedPerson, layout_of, stroke
from hypothesis import given, settings
from hypothesis import strategies as st

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
from app.calibration.guided.check import check, dead_zone_of
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.guided.labels import CuedMovement, labels, lags_of
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
    return guided(cleaned(person, *recorded(person, **how), person.rest() if rest else None))


def cleaned(person, t, values, prompts, resting):
    repetitions = repetitions_of_prompts(t, values, prompts, person.sample_rate)
    stretches = stretches_of_prompts(t, values, prompts, person.sample_rate)
    return CleanRecording.of(LAYOUT, person.sample_rate, person.free(), resting, repetitions, stretches)


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
    ("count", "words"),
    [(1, "from 1 prompted repetition: prompt at least 3"), (2, "from 2 prompted repetitions: prompt at least 3")],
)
def test_too_few_repetitions_are_a_reason(count, words):
    guided = fitted(misleading_limb(), count=count)
    assert guided.profile.joints[0].guided is None
    assert words in str(guided.reasons["right_elbow"])


def test_missing_prompts_are_a_reason():
    person = misleading_limb()
    clean = CleanRecording.of(LAYOUT, 100.0, person.free(), person.rest())
    assert "never prompted" in str(guided(clean).reasons["right_elbow"])


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
    assert "nowhere at rest" in str(guided(clean).reasons["right_elbow"])


def test_tremor_at_rest_raises_the_dead_zone():
    calm = fitted(misleading_limb()).profile.joints[0]
    person = misleading_limb()
    t, values, prompts = recorded(person)
    resting = person.rest()
    resting += 0.3 * np.sin(2 * np.pi * 2.0 * np.arange(len(resting)) / 100)[:, np.newaxis] * person.gains[0]
    shaky = guided(cleaned(person, t, values, prompts, resting)).profile.joints[0]
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


RATE = 100.0


def movements(count=4, move=0.8, hold=0.0, back=1.2, pause=2.0, before=1.5):
    """Return the rate of a joint (n,) that goes there and back, and the rows in which it rises."""
    place, rising = [np.zeros(round(before * RATE))], []
    for _ in range(count):
        start = sum(map(len, place))
        rising.append((start, start + round(move * RATE)))
        there = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, round(move * RATE)))
        home = 0.5 + 0.5 * np.cos(np.linspace(0, np.pi, round(back * RATE)))
        place += [there, np.ones(round(hold * RATE)), home, np.zeros(round(pause * RATE))]
    return np.gradient(np.concatenate(place)) * RATE, rising


@given(
    lead=st.floats(-0.15, 0.9),
    apart=st.lists(st.floats(-0.15, 0.15), min_size=4, max_size=4),
    gain=st.floats(0.01, 100.0),
)
@settings(max_examples=40, deadline=None)
def test_the_lag_of_every_repetition_is_found(lead, apart, gain):
    rate, rising = movements()
    lags = [round(RATE * (lead + one)) for one in apart]
    asked = [CuedMovement(start - lag, stop - lag) for (start, stop), lag in zip(rising, lags, strict=True)]
    assert lags_of(gain * rate, asked, RATE) == pytest.approx(lags, abs=3)


def test_noise_does_not_move_the_lag_far():
    rate, rising = movements()
    asked = [CuedMovement(start - 30, stop - 30) for start, stop in rising]
    noisy = rate + np.random.default_rng(1).normal(scale=0.3, size=len(rate))
    assert lags_of(noisy, asked, RATE) == pytest.approx([30] * 4, abs=8)


def test_the_movement_is_plus_one_the_way_back_minus_one_and_rest_zero():
    rate, rising = movements()
    found = labels(rate, [CuedMovement(*one) for one in rising], [0] * 4, RATE)
    for start, stop in rising:
        assert (found[start:stop] == 1).all()
        assert (found[stop : stop + 110] == -1).all()
        assert (found[stop + 130 : stop + 300] == 0).all()
    assert (found[:150] == 0).all()


def test_the_way_back_after_a_held_posture_is_where_it_falls():
    rate, rising = movements(hold=1.8)
    found = labels(rate, [CuedMovement(*one) for one in rising], [0] * 4, RATE)
    for _, stop in rising:
        assert (found[stop : stop + 150] == 0).all()
        assert (found[stop + 190 : stop + 290] == -1).all()


def test_what_lies_outside_of_the_recording_is_cut_off():
    rate, rising = movements(count=1, pause=0.0)
    asked = [CuedMovement(rising[0][0] - 140, rising[0][1] - 140)]
    found = labels(rate[:240], asked, [140], RATE)
    assert found.shape == (240,)
    assert (found[230:] == -1).all()
    assert len(labels(rate[:100], [CuedMovement(0, 90)], [-50], RATE)) == 100


def test_movements_that_follow_at_once_leave_the_next_one_its_place():
    rate, rising = movements(pause=0.0, back=0.6)
    found = labels(rate, [CuedMovement(*one) for one in rising], [0] * 4, RATE)
    for start, stop in rising:
        assert (found[start:stop] == 1).all()


# 2 s rest, 1 s there, 1 s back, 2 s rest
LABEL = np.repeat([0, 1, -1, 0], [200, 100, 100, 200]).astype(np.int8)
ONE = np.zeros(600, dtype=np.int_)


def measures(rate, dead_zone=0.2, full=1.0, label=LABEL, repetition=ONE):
    return check(rate, label, repetition, dead_zone, full, RATE)


@pytest.mark.parametrize(
    ("rate", "expected"),
    [
        (np.where(LABEL > 0, 1.0, 0.0), {"in_phase": 1.0, "hit_rate": 1.0, "false_per_minute": 0.0, "false_count": 0}),
        (np.where(LABEL != 0, 0.6, 0.0), {"in_phase": 0.5}),
        (np.where(LABEL > 0, 9.0, 0.0) + np.where(LABEL < 0, 0.6, 0.0), {"in_phase": 1.0 / 1.5}),
        (np.where(np.arange(600) // 25 == 8, 1.0, 0.0), {"hit_rate": 0.25}),
        (np.zeros(600), {"in_phase": 0.0, "hit_rate": 0.0}),
    ],
    ids=["a perfect map", "half on the way back", "not above full", "hits in time", "no activation"],
)
def test_the_measures_of_a_known_rate(rate, expected):
    found = measures(rate)
    assert {name: getattr(found, name) for name in expected} == pytest.approx(expected)


def test_false_activations_are_counted_once_each_and_not_beside_a_movement():
    rate = np.zeros(600)
    rate[[50, 51, 52, 100, 500]] = 1.0  # three at rest
    rate[[190, 420]] = 1.0  # within 0.3 s of a labelled movement
    found = measures(rate)
    assert found.false_count == 3
    assert found.false_per_minute == pytest.approx(60 * 3 / (4.0 - 0.6))


def test_the_edge_of_a_movement_is_neither_in_phase_nor_outside():
    rate = np.where(LABEL > 0, 1.0, 0.0)
    rate[190:200] = rate[400:410] = 1.0  # within 0.3 s of a labelled movement
    assert measures(rate).in_phase == 1.0
    rate[100:110] = 1.0
    assert measures(rate).in_phase == pytest.approx(100 / 110)


def test_the_end_of_one_repetition_is_not_the_beginning_of_the_next():
    rate = np.where(np.arange(1200) % 600 == 0, 1.0, 0.0)
    found = measures(rate, label=np.tile(LABEL, 2), repetition=np.repeat([0, 1], 600))
    assert found.false_count == 2


def test_the_dead_zone_lets_the_same_share_through():
    rate = np.random.default_rng(1).normal(size=600)
    for share in (0.1, 0.5, 0.9):
        dead_zone = dead_zone_of(rate, LABEL, share)
        assert (rate[LABEL > 0] > dead_zone).mean() == pytest.approx(share, abs=0.011)
