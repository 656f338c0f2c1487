"""Joints proposed by what moves together: found whatever gains and order are, and not where nothing is clear."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.cues import Cue
from app.features.layouts.joint_groups import JointGroups, joint_groups
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.shirt.standard import standard_layout
from app.signals.signals import read_signals
from app.study.participant import Participant
from app.texts import LANGUAGES, reader_language
from folders import SHARED

RATE = 50.0
SECONDS = 20.0
KNIT = SHARED / "data" / "knit_shirt" / "signals.csv"


def movements(count, seconds=SECONDS):
    """Return the angles (n, count) of joints that move at different frequencies."""
    t = np.arange(round(seconds * RATE)) / RATE
    return np.sin(2 * np.pi * (0.3 + 0.13 * np.arange(count)) * t[:, np.newaxis] + np.arange(count))


def channels(joints, rng, noise=0.01, seconds=SECONDS):
    """Return the signals of channels, of each of which `joints` has its joint, with gains of either sign."""
    gains = rng.uniform(0.3, 2.0, len(joints)) * rng.choice((-1.0, 1.0), len(joints))
    moved = movements(max(joints) + 1, seconds)[:, joints] * gains
    return moved + noise * rng.normal(size=moved.shape) + rng.normal(size=len(joints))


def planted(joints):
    """Return the groups that are to be found, by their first channels."""
    return tuple(tuple(np.flatnonzero(np.array(joints) == joint).tolist()) for joint in dict.fromkeys(joints))


JOINTS = st.lists(st.integers(2, 5), min_size=2, max_size=5).flatmap(
    lambda sizes: st.permutations([joint for joint, size in enumerate(sizes) for _ in range(size)])
)


@settings(max_examples=25, deadline=None)
@given(JOINTS, st.integers(0, 2**32 - 1))
def test_the_channels_of_each_joint_are_a_group_whatever_their_gains_and_their_order(joints, seed):
    found = joint_groups(channels(joints, np.random.default_rng(seed)), RATE)
    assert (found.verdict, found.groups, found.still) == ("groups", planted(joints), ())
    assert 0.5 < found.silhouette <= 1.0


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 6), st.floats(-1e3, 1e3), st.floats(1e-2, 1e3))
def test_each_channel_that_moves_is_in_one_group_at_most_and_units_do_not_matter(seed, count, offset, unit):
    rng = np.random.default_rng(seed)
    values = np.cumsum(rng.normal(size=(600, 3)), axis=0) @ rng.normal(size=(3, count))
    values[:, 0] = np.where(rng.random(600) < 0.02, np.nan, values[:, 0])
    found = joint_groups(values, RATE)
    grouped = [index for group in found.groups for index in group]
    assert len(grouped) == len(set(grouped))
    assert set(grouped) | set(found.still) <= set(range(count))
    assert set(grouped) & set(found.still) == set()
    again = joint_groups(unit * values + offset, RATE)
    assert (again.verdict, again.groups, again.still) == (found.verdict, found.groups, found.still)


def test_channels_that_do_not_move_or_are_broken_are_in_no_group():
    rng = np.random.default_rng(1)
    values = channels([0, 0, 1, 1, 0, 1, 0], rng)
    values[:, 4] = rng.normal(size=len(values))  # noise
    values[:, 5] = 1.5  # constant
    values[:400, 6] = np.nan
    found = joint_groups(values, RATE)
    assert (found.verdict, found.groups, found.still) == ("groups", ((0, 1), (2, 3)), (4, 5, 6))


@pytest.mark.parametrize(
    ("values", "verdict"),
    [
        (movements(3, 9.9), "short"),
        (np.random.default_rng(2).normal(size=(1000, 6)), "still"),
        (np.full((1000, 3), np.nan), "still"),
        (np.zeros((1000, 2)), "still"),
        (movements(1), "still"),  # one channel alone
        (movements(8), "unclear"),  # each for itself
        (movements(2), "unclear"),
    ],
)
def test_where_nothing_is_clear_there_are_no_groups_and_a_sentence_says_what_to_do(values, verdict):
    found = joint_groups(values, RATE)
    assert (found.verdict, found.groups) == (verdict, ())
    for language in LANGUAGES:
        with reader_language(language):
            assert str(found.text).endswith(".")


def test_channels_that_all_move_alike_are_one_joint():
    rng = np.random.default_rng(3)
    found = joint_groups(channels([0, 0, 0, 0, 0], rng, noise=0.03), RATE)
    assert (found.verdict, found.groups) == ("one", ((0, 1, 2, 3, 4),))
    assert str(found.text) == "All sensors that moved, moved together: they make one joint."


def test_how_many_groups_there_are_stands_in_the_sentence():
    assert str(JointGroups("groups", ((0,), (1, 2))).text) == "2 groups of sensors move together."


@pytest.mark.skipif(not KNIT.exists(), reason="the recordings of the knit are not on this machine")
@pytest.mark.parametrize("start", [0.0, 10.0, 30.0])
def test_the_four_joints_of_a_real_knit_are_found(start):
    signals = read_signals(KNIT)
    found = joint_groups(signals.values[signals.between(start, start + SECONDS)], signals.sample_rate)
    names = [{signals.channel_names[i].rpartition("_")[0] for i in group} for group in found.groups]
    assert names == [{"right_elbow"}, {"left_elbow"}, {"right_shoulder"}, {"left_shoulder"}]
    assert [len(group) for group in found.groups] == [5, 5, 5, 5]


def test_no_group_of_a_simulated_person_mixes_two_joints():
    layout, rate = standard_layout(), 100.0
    participant = Participant(SimulatedPerson(PRACTISED, 1), layout, rate, 1)
    cue = Cue(start=0.0, end=SECONDS, kind="free")
    values = np.array([participant.follow(cue, i / rate).values for i in range(round(SECONDS * rate))])
    found = joint_groups(values, rate)
    joints = [{layout.channels[i].joint for i in group} for group in found.groups]
    assert [len(names) for names in joints] == [1] * len(joints)
    assert set().union(*joints) == set(layout.joint_names)
    assert len(joints) <= len(layout.joints) + 2  # a shoulder moves in two ways
