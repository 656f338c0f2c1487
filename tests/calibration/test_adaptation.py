"""A map follows its person in small steps, and nothing else than the person."""

import numpy as np
import pytest
from wearing import JOINTS, Wearer, calibrate, layout_of

from app.calibration.adaptation import Movement, propose
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
