"""A proposal answers what the map loses, in small steps, and nothing else."""

import math

import numpy as np
import pytest
from calibration.adaptation.driven_trial import known, put_on_again, trial, with_map_of
from calibration.simulated_person import JOINTS, SimulatedPerson, calibrate, layout_of
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.movement import Movement
from app.calibration.adaptation.proposal import AT_ITS_END, propose
from app.calibration.vocabulary import standard_parameters
from app.texts import Text

LOST = Text("calibration-loss-noise")


def losing(joints=JOINTS, **what):
    """Return that each of the joints loses the same."""
    return {joint: JointLoss(LOST, **what) for joint in joints}


TURNING = losing(turns=True)
SILENCED = losing(turns=True, silenced=True)


@pytest.fixture
def person():
    return SimulatedPerson(layout_of(), seed=3)


@pytest.fixture
def parameters(person):
    return standard_parameters(calibrate(person))


def weights_of(parameters, joint):
    return np.array(next(one.direction for one in parameters.profile.joints if one.name == joint))


def angle_of(one, other):
    return np.degrees(np.arccos(np.clip(one @ other, -1, 1)))


def test_the_map_follows_a_shirt_put_on_again_by_two_degrees_a_trial(person, parameters) -> None:
    put_on_again(person)
    truth = person.gains[0, :5] / np.linalg.norm(person.gains[0, :5])
    before = angle_of(weights_of(parameters, "right_elbow"), truth)
    assert before > 8
    first = parameters
    for _ in range(4):
        proposal = propose(parameters, [trial(person)], TURNING, calibrated=first.profile)
        assert proposal.parameters is not None
        step = angle_of(weights_of(parameters, "right_elbow"), weights_of(proposal.parameters, "right_elbow"))
        assert 1.9 < step <= 2.0 + 1e-6
        parameters = proposal.parameters
    assert angle_of(weights_of(parameters, "right_elbow"), truth) == pytest.approx(before - 8, abs=1.5)


def test_at_most_five_degrees_at_once(person, parameters) -> None:
    put_on_again(person)
    proposal = propose(parameters, [trial(person)] * 4, TURNING)
    applied = [one.angle_applied_deg for one in proposal.joints]
    assert max(applied) == pytest.approx(5.0)
    assert max(known(one.angle_proposed_deg) for one in proposal.joints) > 8


def test_only_trials_since_the_last_change_count(person, parameters) -> None:
    put_on_again(person)
    trials = [trial(person)] * 4
    assert max(one.angle_applied_deg for one in propose(parameters, trials, TURNING, fresh=1).joints) == pytest.approx(
        2.0
    )
    assert propose(parameters, trials, TURNING, fresh=0).parameters is None


def test_without_trials_there_is_nothing_to_propose(parameters) -> None:
    proposal = propose(parameters, [], TURNING)
    assert proposal.parameters is None
    assert {one.status for one in proposal.joints} == {"unchanged"}


def test_a_joint_that_loses_nothing_stays_as_it_is(person, parameters) -> None:
    put_on_again(person)
    one, *others = propose(parameters, [trial(person)], losing(JOINTS[:1], turns=True)).joints
    assert (one.status, one.angle_applied_deg) == ("applied", pytest.approx(2.0))
    assert str(one.reason).startswith(str(LOST))
    assert {(other.status, other.angle_proposed_deg) for other in others} == {("unchanged", None)}
    assert propose(parameters, [trial(person)], {}).parameters is None


@pytest.mark.parametrize(
    ("growth", "ratio"), [(math.log(0.7), 0.92), (math.log(1.3), 1.08), (math.log(0.95), 0.95), (math.log(1.02), 1.02)]
)
def test_full_follows_the_strokes_both_ways_and_at_most_by_eight_percent(person, parameters, growth, ratio) -> None:
    for one in propose(parameters, [trial(person)], losing(growth=growth)).joints:
        assert known(one.full_after) / known(one.full_before) == pytest.approx(ratio, abs=0.001)
        assert one.felt_change == pytest.approx(abs(1 / ratio - 1), abs=0.002)
        assert one.dead_zone_after == one.dead_zone_before


@pytest.mark.parametrize(("wanted", "ratio"), [(1.4, 1.4), (5.0, 2.0), (0.95, 0.95), (0.3, 0.8)])
def test_the_dead_zone_rises_faster_than_it_falls(person, parameters, wanted, ratio) -> None:
    before = parameters.gestures[0].dead_zone
    for one in propose(parameters, [trial(person)], losing(dead_zone=wanted * before)).joints:
        assert one.dead_zone_after == pytest.approx(ratio * before, abs=1e-3)
        assert one.felt_change == 0.0


def test_full_waits_while_the_direction_turns(person, parameters) -> None:
    put_on_again(person)
    for one in propose(parameters, [trial(person)], losing(turns=True, growth=-0.3, dead_zone=0.2)).joints:
        assert (one.full_after, one.dead_zone_after) == (one.full_before, 0.2)
        assert one.angle_applied_deg > 0.0


def test_a_loss_that_nothing_may_answer_is_said(person, parameters) -> None:
    end = losing(growth=math.log(0.5))
    for _ in range(20):
        proposal = propose(parameters, [trial(person)], end)
        if proposal.parameters is None:
            break
        parameters = proposal.parameters
    assert {one.status for one in proposal.joints} == {"refused"}
    assert all(str(one.reason) == f"{LOST} {AT_ITS_END}" for one in proposal.joints)


@pytest.mark.parametrize("kind", ["guided", "prior"])
def test_a_map_of_another_kind_is_never_turned_but_its_thresholds_follow(person, parameters, kind) -> None:
    put_on_again(person)
    joints = tuple(with_map_of(joint, kind) for joint in parameters.profile.joints)
    profile = parameters.profile.model_copy(update={"joints": joints})
    changed = propose(
        parameters.model_copy(update={"profile": profile}),
        [trial(person)],
        losing(turns=True, dead_zone=0.2, growth=-0.05),
    )
    assert changed.parameters is not None
    for one, joint in zip(changed.joints, changed.parameters.profile.joints, strict=True):
        assert (one.status, one.angle_applied_deg, one.dead_zone_after) == ("applied", 0.0, 0.2)
        assert known(one.full_after) < known(one.full_before)
        assert joint in joints


def test_only_movements_while_armed_count(person, parameters) -> None:
    put_on_again(person)
    driven = trial(person)
    idle = Movement(driven.values, driven.sample_rate, np.zeros(len(driven.values), dtype=bool))
    assert all(one.angle_proposed_deg is None for one in propose(parameters, [idle], TURNING).joints)


def test_a_proposal_is_ready_for_json(person, parameters) -> None:
    put_on_again(person)
    proposal = propose(parameters, [trial(person)], SILENCED)
    assert proposal.model_validate_json(proposal.model_dump_json()) == proposal
    assert set(proposal.difference["joints"]) <= set(JOINTS)


def square(person, parameters, joint=0, share=0.06):
    """Let a joint's channels move almost orthogonal to its map, where any turn is felt."""
    weights = weights_of(parameters, JOINTS[joint])
    aside = person.rng.normal(size=5)
    aside -= (aside @ weights) * weights
    aside /= np.linalg.norm(aside)
    person.gains[joint, :5] = 3.0 * (aside + share * weights)


def test_a_change_that_would_be_felt_too_much_is_refused(person, parameters) -> None:
    square(person, parameters)
    proposal = propose(parameters, [trial(person, size=2.0)], TURNING)
    elbow = proposal.joints[0]
    assert elbow.status == "refused"
    assert elbow.felt_change > 0.1
    assert elbow.angle_applied_deg == 0.0
    if proposal.parameters is not None:
        assert np.array_equal(weights_of(proposal.parameters, "right_elbow"), weights_of(parameters, "right_elbow"))


@given(
    st.lists(st.tuples(st.floats(0.0, 1.5), st.floats(-1.0, 1.0), st.floats(0.01, 3.0)), min_size=1, max_size=3),
    st.integers(0, 1000),
)
@settings(max_examples=12, deadline=None)
def test_however_the_shirt_sits_no_applied_change_is_large_or_flips_a_sign(changes, seed) -> None:
    person = SimulatedPerson(layout_of(), seed=3)
    first = parameters = standard_parameters(calibrate(person))
    person.rng = np.random.default_rng(seed)
    for share, growth, dead_zone in changes:
        put_on_again(person, share)
        losses = losing(turns=True, silenced=True, growth=growth, dead_zone=dead_zone)
        proposal = propose(parameters, [trial(person, repetitions=3)], losses, calibrated=first.profile)
        after = proposal.parameters or parameters
        assert proposal.felt_change <= 0.1
        for one in proposal.joints:
            before, new = weights_of(parameters, one.name), weights_of(after, one.name)
            assert before @ new > 0.99
            assert angle_of(before, new) <= 2.0 + 1e-6
            assert one.status == "applied" or np.array_equal(before, new)
            assert weights_of(first, one.name) @ new > np.cos(np.radians(30.001))
        for old, gesture in zip(parameters.gestures, after.gestures, strict=True):
            assert abs(gesture.full / old.full - 1.0) <= 0.0801
            assert gesture.full >= gesture.dead_zone + 0.1 or gesture == old
        parameters = after


@pytest.mark.parametrize("how", ["dead", "railed", "nan"])
def test_a_broken_channel_never_enters(person, parameters, how) -> None:
    put_on_again(person)
    driven = trial(person)
    column = driven.values[:, 2]
    column[:] = {"dead": 0.0, "railed": np.clip(column, None, np.quantile(column, 0.8)), "nan": np.nan}[how]
    proposal = propose(parameters, [driven], SILENCED)
    elbow = proposal.joints[0]
    assert elbow.status == "refused"
    assert "right_elbow_2" in str(elbow.reason)
    assert proposal.parameters is not None  # the other joints are adapted
    assert np.array_equal(weights_of(proposal.parameters, "right_elbow"), weights_of(parameters, "right_elbow"))
    assert proposal.parameters.profile.low[2] == parameters.profile.low[2]


def test_a_channel_that_was_left_out_stays_out(person) -> None:
    parameters = standard_parameters(calibrate(person, unused=["right_elbow_2"]))
    put_on_again(person)
    proposal = propose(parameters, [trial(person)], TURNING)
    assert proposal.parameters is not None
    assert 2 not in proposal.parameters.profile.joints[0].channels
    unread = parameters.profile.joints[1]
    weights = np.array([*unread.direction[:4], 0.0])
    unread = unread.with_direction(weights / np.linalg.norm(weights))
    profile = parameters.profile.model_copy(
        update={"joints": (parameters.profile.joints[0], unread, *parameters.profile.joints[2:])}
    )
    proposal = propose(parameters.model_copy(update={"profile": profile}), [trial(person)], TURNING)
    assert proposal.parameters is not None
    assert proposal.joints[1].angle_applied_deg > 0
    assert proposal.parameters.profile.joints[1].direction[4] == 0.0


def test_a_joint_that_moves_in_many_ways_is_not_turned(parameters) -> None:
    loose = SimulatedPerson(layout_of(), seed=3)
    loose.gains[0] += 0.5 * loose.gains[0] * loose.rng.normal(size=20)
    driven = trial(loose)
    rows = np.arange(len(driven.values))
    for channel in range(5):  # each channel shakes independently, as strongly as the stroke moves it
        driven.values[:, channel] += 0.5 * np.sin(rows * (0.05 + 0.013 * channel))
    elbow = propose(parameters, [driven], TURNING).joints[0]
    assert elbow.angle_applied_deg == 0.0
    assert elbow.status in ("refused", "unchanged")


def test_ranges_follow_the_shirt_but_not_a_loose_channel(person, parameters) -> None:
    person.offsets += 0.4
    moved = trial(person)
    moved.values[:, 3] = 5.0 + 0.1 * np.sin(np.arange(len(moved.values)) * 1.7)  # loose, and trembling
    proposed = propose(parameters, [moved], SILENCED).parameters
    assert proposed is not None
    profile = proposed.profile
    before = parameters.profile
    assert moved.values[:, 0].max() > before.high[0] + 0.1
    assert profile.low[0] - 0.1 <= moved.values[:, 0].min() <= moved.values[:, 0].max() <= profile.high[0] + 0.1
    assert profile.high[0] - profile.low[0] == pytest.approx(before.high[0] - before.low[0])
    assert (profile.low[3], profile.high[3]) == (before.low[3], before.high[3])


def test_ranges_go_no_further_than_their_own_width_from_the_calibration(person, parameters) -> None:
    first = parameters.profile
    width = first.high[0] - first.low[0]
    for _ in range(3):
        person.offsets += 0.8 * width
        proposal = propose(parameters, [trial(person)], SILENCED, calibrated=first)
        parameters = proposal.parameters or parameters
    assert parameters.profile.low[0] - first.low[0] == pytest.approx(width)
