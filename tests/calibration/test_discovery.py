"""The gestures of a simulated body are found from its calibration, and what is predicted of them is right."""

import numpy as np
import pytest
from calibration.cued_calibration import profile_of, record_steps, runs_of, simulated_participant
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.cued_runs import CuedRun
from app.calibration.gestures.discovery import discover, discovery_from_profile
from app.calibration.gestures.numbers import ratios, score_of
from app.calibration.gestures.prediction import (
    at_least_share,
    at_most_per_minute,
    count_crossings,
    false_per_minute,
    hit_probability,
    rest_statistics,
)
from app.layout import ShirtLayout
from app.signals.smoothing import smooth
from building import guided_map

CHANNELS = simulated_participant().layout.channels_of_joint
PAPER = {"u1+": "right_elbow", "u1-": "left_elbow", "u2+": "right_shoulder", "u2-": "left_shoulder"}


@pytest.fixture(scope="module")
def participant():
    return simulated_participant()


@pytest.fixture(scope="module")
def steps():
    return record_steps(simulated_participant())


@pytest.fixture(scope="module")
def found(participant, steps):
    return discover(profile_of(participant.layout, steps), runs_of(steps))


def found_with(participant, steps, change):
    changed = [(step, change(step, values.astype(np.float64)), cue) for step, values, cue in steps]
    return discover(profile_of(participant.layout, changed), runs_of(changed))


def by_name(discovery):
    return {gesture.name: gesture for gesture in discovery.gestures}


def bound(discovery):
    return {binding.control: binding.gestures for binding in discovery.suggestion.bindings}


def used(discovery):
    return {name for names in bound(discovery).values() for name in names}


def test_every_joint_is_ranked_there_and_back_with_its_four_numbers(participant, found):
    assert {(one.joint, one.direction) for one in found.gestures} == {
        (joint, way) for joint in participant.layout.joint_names for way in (1, -1)
    }
    scores = [one.score for one in found.gestures]
    assert scores == sorted(scores, reverse=True)
    for one in found.gestures:
        assert None not in (one.repeatability, one.cross_talk, one.effort, one.prediction)
        assert one.score == pytest.approx(score_of(ratios(one)))


def test_the_way_back_is_a_gesture_that_costs_twice_the_effort(found):
    gestures = by_name(found)
    for joint in CHANNELS:
        there, back = gestures[joint], gestures[f"{joint}_back"]
        assert there.score > back.score
        assert back.effort > 1.3 * there.effort
        assert back.full < there.full  # nobody was asked to hurry back


def test_an_able_body_gets_the_vocabulary_of_the_paper_with_numbers(found):
    assert bound(found) == {
        **{control: (joint,) for control, joint in PAPER.items()},
        "stop": ("right_elbow", "left_elbow"),
    }
    assert "of 100 movements" in found.suggestion.reason
    assert "(95 %)" in found.suggestion.reason


def test_the_suggestions_gestures_have_the_profiles_handles(participant, steps, found):
    profile = profile_of(participant.layout, steps)
    gestures = {gesture.name: gesture for gesture in found.suggestion.gestures}
    for joint in profile.joints:
        assert (gestures[joint.name].dead_zone, gestures[joint.name].full) == (joint.pca.dead_zone, joint.pca.full)


@pytest.mark.parametrize("noisy", ["left_wrist", "left_elbow"])
def test_a_noisy_joint_is_not_suggested(participant, steps, noisy):
    random = np.random.default_rng(5)

    def shake(_step, values):
        values[:, CHANNELS[noisy]] += random.normal(0.0, 0.08, (len(values), len(CHANNELS[noisy])))
        return values

    discovery = found_with(participant, steps, shake)
    assert not {noisy, f"{noisy}_back"} & used(discovery)
    assert by_name(discovery)[noisy].weakest == "signal_to_noise"
    assert discovery.gestures[-1].joint == noisy


def test_a_joint_that_moves_with_another_is_not_suggested_beside_it(participant, steps):
    """The right elbow always moves with the right shoulder: one of the two is suggested, and a wrist."""
    channels = CHANNELS["right_shoulder"]
    alone = next(values for step, values, _cue in steps if step.joint == "right_shoulder")

    def tie(step, values):
        if step.joint == "right_elbow":
            values[:, channels] += alone[:, channels] - alone[0, channels]
        return values

    discovery = found_with(participant, steps, tie)
    assert by_name(discovery)["right_shoulder"].appears_with.joint == "right_elbow"
    assert by_name(discovery)["right_elbow"].brings.joint == "right_shoulder"
    assert by_name(discovery)["right_shoulder"].cross_talk > 0.3
    assert not {"right_elbow", "right_shoulder"} <= used(discovery)


def test_no_two_bound_gestures_read_one_joint(participant, steps):
    """Only the right arm has signals: three joints, each with a way back."""

    def one_sided(_step, values):
        for joint, channels in CHANNELS.items():
            if joint.startswith("left"):
                values[:, channels] = 1.0
        return values

    discovery = found_with(participant, steps, one_sided)
    assert set(discovery.not_found) == {"left_shoulder", "left_elbow", "left_wrist"}
    assert len(used(discovery)) == 3
    assert len({name.removesuffix("_back") for name in used(discovery)}) == 3


def test_a_joint_that_was_not_prompted_is_ranked_without_the_numbers_of_prompts(participant, steps):
    without = [one for one in steps if one[0].joint != "right_wrist"]
    discovery = discover(profile_of(participant.layout, without), runs_of(without))
    skipped = by_name(discovery)["right_wrist"]
    assert (skipped.repeatability, skipped.cross_talk, skipped.effort) == (None, None, None)
    assert skipped.prediction.hit_rate is None
    assert skipped.prediction.rest_check.seconds > 5
    assert "right_wrist" not in used(discovery)


def test_without_recordings_the_profile_ranks_and_reports_what_is_missing(participant, steps):
    discovery = discovery_from_profile(profile_of(participant.layout, steps), "They are gone.")
    assert (discovery.source, discovery.message) == ("profile", "They are gone.")
    assert {one.direction for one in discovery.gestures} == {1}
    assert all(one.prediction is None and one.effort is None for one in discovery.gestures)
    assert len(used(discovery)) == 4


def test_with_a_prompt_table_the_way_back_follows_the_prompt(participant, steps):
    """A file without rest and pauses: the numbers that need them are None."""
    discovery = discover(
        profile_of(participant.layout, steps),
        [CuedRun(run.values, tuple(p for p in run.phases if p.kind in {"move", "return"})) for run in runs_of(steps)],
    )
    one = by_name(discovery)["left_elbow_back"]
    assert one.repeatability is not None
    assert one.prediction.false_per_minute is None
    assert one.prediction.counted_at_most is None
    assert one.prediction.hit_check.repetitions == 3


@settings(max_examples=8, deadline=None)
@given(st.floats(0.01, 100.0), st.randoms(use_true_random=False))
def test_unit_and_order_of_the_channels_change_nothing(found, steps, scale, random):
    layout = simulated_participant().layout
    order = list(range(len(layout.channels)))
    random.shuffle(order)
    turned = ShirtLayout(name=layout.name, channels=tuple(layout.channels[i] for i in order), joints=layout.joints)
    changed = [(step, scale * values.astype(np.float64)[:, order], cue) for step, values, cue in steps]
    again = discover(profile_of(turned, changed), runs_of(changed))
    assert bound(again) == bound(found)
    before = by_name(found)
    assert len(again.gestures) == len(before)
    for one in again.gestures:
        other = before[one.name]
        assert one.score == pytest.approx(other.score, rel=1e-3)
        for number in ("signal_to_noise", "repeatability", "cross_talk", "effort"):
            assert getattr(one, number) == pytest.approx(getattr(other, number), rel=5e-3, abs=1e-3)
        assert one.prediction.counted == other.prediction.counted


def test_a_guided_map_is_judged_by_what_it_decodes(participant, steps, found):
    """A guided map with the PCA map's weights gives the same numbers, one that is twice as fast does not."""
    profile = profile_of(participant.layout, steps)

    def guided(faster):
        joints = []
        for joint in profile.joints:
            rate = tuple(faster * weight for weight in joint.pca.rates[0])
            candidate = guided_map((rate,), faster * joint.pca.dead_zone, faster * joint.pca.full, lag=0.0)
            joints.append(joint.model_copy(update={"map": "guided", "guided": candidate}))
        return profile.model_copy(update={"joints": tuple(joints)})

    before = by_name(found)
    for one in discover(guided(1.0), runs_of(steps)).gestures:
        assert one.score == pytest.approx(before[one.name].score, rel=1e-3)
    for one in discover(guided(2.0), runs_of(steps)).gestures:
        assert (one.dead_zone, one.full) == pytest.approx(
            (2 * before[one.name].dead_zone, 2 * before[one.name].full), abs=2e-4
        )
        assert one.signal_to_noise == pytest.approx(before[one.name].signal_to_noise, rel=0.02)


RATE = 100.0


def rest(seconds, seed, noise=1.0):
    """Return the rate (FS/s) of white noise filtered by the chain's low-pass, as of a joint at rest."""
    place = smooth(noise * np.random.default_rng(seed).normal(size=round(seconds * RATE) + 100), 3.0, RATE)
    return (np.diff(place) * RATE)[100:]


def test_rices_formula_counts_what_long_noise_does():
    quiet = rest_statistics([rest(600, 1)], RATE)
    later = rest(6000, 2)
    for z in (2.0, 3.0, 3.5):
        counted = count_crossings([later], z * quiet.noise) / 100.0
        assert false_per_minute(quiet, z * quiet.noise) == pytest.approx(counted, rel=0.35)


def test_what_short_noise_predicts_is_right_on_average():
    """Rests of 3 s each, with a dead-zone of three times the measured noise."""
    predicted, counted = [], []
    for seed in range(150):
        quiet = rest_statistics([rest(3, seed)], RATE)
        predicted.append(false_per_minute(quiet, 3.0 * quiet.noise))
        counted.append(count_crossings([rest(60, 1000 + seed)], 3.0 * quiet.noise))
    assert np.mean(predicted) == pytest.approx(np.mean(counted), rel=0.35)


def test_less_data_predict_more_false_activations():
    short, long = rest_statistics([rest(3, 4)], RATE), rest_statistics([rest(3, 4)] * 20, RATE)
    assert short.noise == pytest.approx(long.noise)
    assert false_per_minute(short, 4 * short.noise) > false_per_minute(long, 4 * long.noise)


@settings(max_examples=30, deadline=None)
@given(st.floats(0.01, 10.0), st.floats(0.01, 10.0), st.floats(1e-3, 1e3))
def test_a_larger_dead_zone_is_never_worse_and_the_unit_does_not_matter(one, other, scale):
    quiet = rest_statistics([rest(3, 7)], RATE)
    low, high = sorted((one * quiet.noise, other * quiet.noise))
    assert false_per_minute(quiet, low) >= false_per_minute(quiet, high)
    scaled = rest_statistics([scale * rest(3, 7)], RATE)
    assert false_per_minute(scaled, scale * low) == pytest.approx(false_per_minute(quiet, low), rel=1e-6)


def test_no_rest_gives_no_statistics_and_a_silent_rest_no_false_activations():
    assert rest_statistics([], RATE) is None
    assert rest_statistics([np.zeros(2)], RATE) is None
    assert false_per_minute(rest_statistics([np.zeros(300)], RATE), 0.15) == 0.0
    assert at_most_per_minute(0, 0.0) is None


def test_each_crossing_is_counted_once():
    assert count_crossings([np.array([0, 2, 2, 0, 2]), np.array([2, 2]), np.array([0.0])], 1.0) == 3


def test_the_count_alone_proves_three_per_time():
    assert at_most_per_minute(0, 3.0) == pytest.approx(59.9, abs=0.1)  # 2.996 in 3 s
    assert at_most_per_minute(0, 9.0) == pytest.approx(20.0, abs=0.1)  # below 20 a minute it takes nine seconds
    assert at_most_per_minute(3, 60.0) == pytest.approx(7.75, abs=0.01)
    assert at_least_share(3, 3) == pytest.approx(0.05 ** (1 / 3))
    assert at_least_share(0, 3) == 0.0


def test_hits_are_right_on_average_for_few_repetitions():
    """Each person has another spread; three movements predict a hundred."""
    random = np.random.default_rng(3)
    predicted, made = [], []
    for _ in range(300):
        spread = random.uniform(0.05, 0.4)
        peaks = np.exp(random.normal(0.0, spread, 3))
        others = [np.exp(random.normal(0.0, spread, 3)) for _ in range(5)]
        level = 0.8 * np.median(peaks)  # a share of the median peak, like half of full
        predicted.append(hit_probability(peaks, level, others))
        made.append(np.mean(np.exp(random.normal(0.0, spread, 100)) >= level))
    assert np.mean(predicted) == pytest.approx(np.mean(made), abs=0.04)


@settings(max_examples=30, deadline=None)
@given(st.lists(st.floats(0.1, 10.0), min_size=1, max_size=5), st.floats(0.05, 20.0), st.floats(1.01, 3.0))
def test_a_hit_is_a_probability_that_falls_with_the_level(peaks, level, factor):
    low, high = hit_probability(peaks, level), hit_probability(peaks, factor * level)
    assert 0.0 <= high <= low <= 1.0
