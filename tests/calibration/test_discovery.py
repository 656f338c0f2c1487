"""The gestures of a simulated body are found from its calibration, and what is predicted of them is right."""

import numpy as np
import pytest
from calibration.cued_calibration import profile_of, record_steps, runs_of, simulated_participant
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.cued_runs import CuedRun
from app.calibration.gestures.discovery import discover, discovery_from_profile
from app.calibration.gestures.numbers import ratios, score_of
from app.layout import ShirtLayout
from app.texts import Text
from building import guided_map

GONE = Text("calibration-recordings-gone")
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
    assert "of 100 movements" in str(found.suggestion.reason)
    assert "(95 %)" in str(found.suggestion.reason)


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
    discovery = discovery_from_profile(profile_of(participant.layout, steps), GONE)
    assert (discovery.source, discovery.message) == ("profile", GONE)
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
