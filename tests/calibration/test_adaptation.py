"""A map follows its person in small steps, and nothing else than the person."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from wearing import JOINTS, Wearer, calibrate, layout_of

from app.calibration.adaptation.proposal import Movement, propose
from app.calibration.vocabulary import standard_parameters

ALL = ("map", "dead_zones", "full")


def trial(wearer, size=1.0, noise=1.0, repetitions=4, joints=JOINTS):
    """Return a trial in which each joint makes `repetitions` strokes, one joint after the other."""
    wearer.noise, before = wearer.noise * noise, wearer.noise
    pieces = [wearer.rest(3.0)]
    for _ in range(repetitions):
        for joint in joints:
            pieces += [wearer.repetition(joint, size=size).values, wearer.rest(1.0)]
    wearer.noise = before
    values = np.concatenate(pieces)
    return Movement(values, wearer.sample_rate, np.ones(len(values), dtype=bool))


@pytest.fixture
def wearer():
    return Wearer(layout_of(), seed=3)


@pytest.fixture
def parameters(wearer):
    return standard_parameters(calibrate(wearer))


def weights_of(parameters, joint):
    return np.array(next(one.weights for one in parameters.profile.joints if one.name == joint))


def angle_of(one, other):
    return np.degrees(np.arccos(np.clip(one @ other, -1, 1)))


def redressed(wearer, share=0.25):
    wearer.gains = wearer.gains * (1 + share * wearer.rng.normal(size=wearer.gains.shape))


def test_a_shirt_put_on_again_is_followed_two_degrees_a_trial(wearer, parameters) -> None:
    redressed(wearer)
    truth = wearer.gains[0, :5] / np.linalg.norm(wearer.gains[0, :5])
    before = angle_of(weights_of(parameters, "right_elbow"), truth)
    assert before > 8
    first = parameters
    for _ in range(4):
        proposal = propose(parameters, [trial(wearer)], ("map",), calibrated=first.profile)
        assert proposal.parameters is not None
        step = angle_of(weights_of(parameters, "right_elbow"), weights_of(proposal.parameters, "right_elbow"))
        assert 1.9 < step <= 2.0 + 1e-6
        parameters = proposal.parameters
    assert angle_of(weights_of(parameters, "right_elbow"), truth) == pytest.approx(before - 8, abs=1.5)


def test_at_most_five_degrees_at_once(wearer, parameters) -> None:
    redressed(wearer)
    proposal = propose(parameters, [trial(wearer)] * 4, ("map",))
    applied = [one.angle_applied_deg for one in proposal.joints]
    assert max(applied) == pytest.approx(5.0)
    assert max(one.angle_proposed_deg for one in proposal.joints) > 8


def test_only_trials_since_the_last_change_count(wearer, parameters) -> None:
    redressed(wearer)
    trials = [trial(wearer)] * 4
    assert max(one.angle_applied_deg for one in propose(parameters, trials, fresh=1).joints) == pytest.approx(2.0)
    assert propose(parameters, trials, fresh=0).parameters is None


def test_without_trials_there_is_nothing_to_propose(parameters) -> None:
    proposal = propose(parameters, [])
    assert proposal.parameters is None
    assert {one.status for one in proposal.joints} == {"unchanged"}


def test_what_is_not_to_be_adapted_is_shown(wearer, parameters) -> None:
    redressed(wearer)
    proposal = propose(parameters, [trial(wearer)], ())
    assert proposal.parameters is None
    assert proposal.joints[0].status == "shown"
    assert proposal.joints[0].angle_proposed_deg > 8


@pytest.mark.parametrize(("size", "falls"), [(0.7, True), (1.3, False)])
def test_full_follows_the_strokes_both_ways(wearer, parameters, size, falls) -> None:
    proposal = propose(
        parameters, [trial(wearer, size=size), trial(wearer, size=size), trial(wearer, size=size)], ("full",)
    )
    for one in proposal.joints:
        ratio = one.full_after / one.full_before
        assert ratio == pytest.approx(0.92 if falls else 1.08, abs=0.001)
        assert one.felt_change < 0.1


def test_the_dead_zone_follows_the_noise_both_ways(wearer, parameters) -> None:
    louder = propose(parameters, [trial(wearer, noise=12.0)] * 2, ("dead_zones",))
    assert all(one.dead_zone_after == pytest.approx(1.2 * one.dead_zone_before, abs=1e-3) for one in louder.joints)
    assert louder.parameters is not None
    calmer = propose(louder.parameters, [trial(wearer)] * 2, ("dead_zones",))
    assert all(one.dead_zone_after < one.dead_zone_before for one in calmer.joints)


def test_only_what_was_permitted_counts(wearer, parameters) -> None:
    redressed(wearer)
    driven = trial(wearer)
    idle = Movement(driven.values, driven.sample_rate, np.zeros(len(driven.values), dtype=bool))
    assert all(one.angle_proposed_deg is None for one in propose(parameters, [idle], ("map",)).joints)


def test_a_proposal_is_ready_for_json(wearer, parameters) -> None:
    redressed(wearer)
    proposal = propose(parameters, [trial(wearer)])
    assert proposal.model_validate_json(proposal.model_dump_json()) == proposal
    assert set(proposal.difference["joints"]) <= set(JOINTS)


def square(wearer, parameters, joint=0, share=0.06):
    """Let a joint's channels move almost square to its map: whatever is turned there is felt."""
    weights = weights_of(parameters, JOINTS[joint])
    aside = wearer.rng.normal(size=5)
    aside -= (aside @ weights) * weights
    aside /= np.linalg.norm(aside)
    wearer.gains[joint, :5] = 3.0 * (aside + share * weights)


def test_what_would_be_felt_too_much_is_refused(wearer, parameters) -> None:
    square(wearer, parameters)
    proposal = propose(parameters, [trial(wearer, size=2.0)], ("map",))
    elbow = proposal.joints[0]
    assert elbow.status == "refused"
    assert elbow.felt_change > 0.1
    assert elbow.angle_applied_deg == 0.0
    if proposal.parameters is not None:
        assert np.array_equal(weights_of(proposal.parameters, "right_elbow"), weights_of(parameters, "right_elbow"))


@given(
    st.lists(st.tuples(st.floats(0.0, 1.5), st.floats(0.3, 2.0), st.floats(0.2, 15.0)), min_size=1, max_size=3),
    st.integers(0, 1000),
)
@settings(max_examples=12, deadline=None)
def test_over_any_wearings_nothing_applied_is_felt_much_turns_far_or_flips(changes, seed) -> None:
    wearer = Wearer(layout_of(), seed=3)
    first = parameters = standard_parameters(calibrate(wearer))
    wearer.rng = np.random.default_rng(seed)
    for share, size, noise in changes:
        redressed(wearer, share)
        proposal = propose(parameters, [trial(wearer, size=size, noise=noise, repetitions=3)], calibrated=first.profile)
        after = proposal.parameters or parameters
        assert proposal.felt_change <= 0.1
        for one in proposal.joints:
            before, new = weights_of(parameters, one.name), weights_of(after, one.name)
            assert before @ new > 0.99
            assert angle_of(before, new) <= 2.0 + 1e-6
            assert one.status == "applied" or np.array_equal(before, new)
            assert weights_of(first, one.name) @ new > np.cos(np.radians(30.001))
        for old, gesture in zip(parameters.gestures, after.gestures, strict=True):
            assert abs(gesture.full / old.full - 1.0) <= 0.0401
            assert gesture.full >= gesture.dead_zone + 0.1 or gesture == old
        assert [j.sign for j in after.profile.joints] == [j.sign for j in first.profile.joints]
        parameters = after


@pytest.mark.parametrize("how", ["dead", "railed", "nan"])
def test_a_broken_channel_never_enters(wearer, parameters, how) -> None:
    redressed(wearer)
    driven = trial(wearer)
    column = driven.values[:, 2]
    column[:] = {"dead": 0.0, "railed": np.clip(column, None, np.quantile(column, 0.8)), "nan": np.nan}[how]
    proposal = propose(parameters, [driven])
    elbow = proposal.joints[0]
    assert elbow.status == "refused"
    assert "right_elbow_2" in elbow.reason
    assert proposal.parameters is not None  # the other joints are well
    assert np.array_equal(weights_of(proposal.parameters, "right_elbow"), weights_of(parameters, "right_elbow"))
    assert proposal.parameters.profile.low[2] == parameters.profile.low[2]


def test_a_channel_that_was_left_out_stays_out(wearer) -> None:
    parameters = standard_parameters(calibrate(wearer, unused=["right_elbow_2"]))
    redressed(wearer)
    proposal = propose(parameters, [trial(wearer)])
    assert proposal.parameters is not None
    assert 2 not in proposal.parameters.profile.joints[0].channels
    unread = parameters.profile.joints[1]
    weights = np.array([*unread.weights[:4], 0.0])
    unread = unread.model_copy(update={"weights": tuple(weights / np.linalg.norm(weights))})
    profile = parameters.profile.model_copy(
        update={"joints": (parameters.profile.joints[0], unread, *parameters.profile.joints[2:])}
    )
    proposal = propose(parameters.model_copy(update={"profile": profile}), [trial(wearer)])
    assert proposal.parameters is not None
    assert proposal.joints[1].angle_applied_deg > 0
    assert proposal.parameters.profile.joints[1].weights[4] == 0.0


def test_a_joint_that_moves_in_many_ways_is_not_turned(parameters) -> None:
    loose = Wearer(layout_of(), seed=3)
    loose.gains[0] += 0.5 * loose.gains[0] * loose.rng.normal(size=20)
    driven = trial(loose)
    rows = np.arange(len(driven.values))
    for channel in range(5):  # each shakes for itself, as strongly as the stroke moves it
        driven.values[:, channel] += 0.5 * np.sin(rows * (0.05 + 0.013 * channel))
    elbow = propose(parameters, [driven], ("map",)).joints[0]
    assert elbow.angle_applied_deg == 0.0
    assert elbow.status in ("refused", "unchanged")


def test_ranges_follow_the_shirt_but_not_a_loose_channel(wearer, parameters) -> None:
    wearer.offsets += 0.4
    moved = trial(wearer)
    moved.values[:, 3] = 5.0 + 0.1 * np.sin(np.arange(len(moved.values)) * 1.7)  # hangs loose, and trembles
    profile = propose(parameters, [moved]).parameters.profile
    before = parameters.profile
    assert moved.values[:, 0].max() > before.high[0] + 0.1
    assert profile.low[0] - 0.1 <= moved.values[:, 0].min() <= moved.values[:, 0].max() <= profile.high[0] + 0.1
    assert profile.high[0] - profile.low[0] == pytest.approx(before.high[0] - before.low[0])
    assert (profile.low[3], profile.high[3]) == (before.low[3], before.high[3])


def test_ranges_go_no_further_than_their_own_width_from_the_calibration(wearer, parameters) -> None:
    first = parameters.profile
    width = first.high[0] - first.low[0]
    for _ in range(3):
        wearer.offsets += 0.8 * width
        proposal = propose(parameters, [trial(wearer)], calibrated=first)
        parameters = proposal.parameters or parameters
    assert parameters.profile.low[0] - first.low[0] == pytest.approx(width)
