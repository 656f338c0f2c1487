"""The figures of a trial, and a loss told from the person's own noise.

Small changes and single trials are left unsaid.
"""

import math

import numpy as np
import pytest
from calibration.adaptation.driven_trial import known, put_on_again, trial, with_map_of
from calibration.simulated_person import JOINTS, SimulatedPerson, calibrate, layout_of
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.adaptation.movement import Movement
from app.calibration.vocabulary import standard_parameters
from app.pipeline.replay.batch import decode_block
from app.scoring.map_losses.losses import (
    MOST_BLIND,
    GestureTrial,
    PastTrial,
    TrialEvidence,
    gesture_trials,
    joint_losses,
    losses_of,
    read_trials,
)
from building import covariance_of_independent

PROFILE = calibrate(SimulatedPerson(layout_of(), seed=3))
PARAMETERS = standard_parameters(PROFILE)
GESTURE = PARAMETERS.gestures[0]
JOINT = GESTURE.joint
CALM = math.log(GESTURE.dead_zone / 8)
USUAL = math.log(GESTURE.full)


def losses(trials, parameters=PARAMETERS, fulls=None):
    """Return what the first joint loses after trials, each a dictionary of the figures that differ from usual ones."""
    rows = []
    for number, differing in enumerate(trials):
        usual = {"noise": CALM, "size": USUAL, "missed": 0.0, "blind": 0.01, "silent": 0.0}
        full = GESTURE.full if fulls is None else fulls[number]
        rows.append(TrialEvidence({GESTURE.name: GestureTrial(**usual | differing)}, {GESTURE.name: full}))
    return joint_losses(parameters, PROFILE, rows).get(JOINT)


def of(figure, values):
    return [{figure: value} for value in values]


def test_a_steady_person_loses_nothing() -> None:
    rng = np.random.default_rng(1)
    for _ in range(20):
        assert losses(of("size", USUAL + rng.normal(0, 0.1, 20))) is None
        assert losses(of("noise", CALM + rng.normal(0, 0.2, 20))) is None
        assert losses(of("blind", 0.05 + rng.normal(0, 0.02, 20))) is None


def test_a_tremor_that_grows_from_session_to_session_raises_the_dead_zone_before_it_drives() -> None:
    # Dead-zone over noise in ten sessions of one trial each, as in a simulated person who deteriorates.
    margins = [10.8, 6.7, 4.1, 2.7, 2.15, 1.8, 1.55, 1.45, 1.3, 1.1]
    noises = [math.log(GESTURE.dead_zone / margin) for margin in margins]
    said = [losses(of("noise", noises[:count])) for count in range(1, 11)]
    assert said[:3] == [None] * 3
    first = next(number for number, loss in enumerate(said, start=1) if loss)
    assert first <= 6
    assert said[first - 1].dead_zone == pytest.approx(4 * math.exp(noises[first - 1]), rel=1e-6)
    assert all(loss is not None for loss in said[first - 1 :])  # as long as nothing follows


def test_one_restless_trial_changes_no_dead_zone() -> None:
    wild = math.log(GESTURE.dead_zone / 1.5)
    assert losses(of("noise", [CALM] * 5 + [wild])) is None
    assert losses(of("noise", [CALM] * 5 + [wild] + [CALM] * 3)) is None


def test_a_dead_zone_that_the_noise_does_not_need_falls_only_where_movements_are_missed() -> None:
    gestures = (GESTURE.model_copy(update={"dead_zone": 3 * GESTURE.dead_zone}), *PARAMETERS.gestures[1:])
    high = PARAMETERS.model_copy(update={"gestures": gestures})
    assert losses(of("missed", [0.05] * 10), high) is None
    loss = losses(of("missed", [0.3] * 6), high)
    assert loss is not None
    assert loss.dead_zone < 3 * GESTURE.dead_zone


@pytest.mark.parametrize(("way", "word"), [(-1, "weaker"), (1, "stronger")])
def test_strokes_that_change_by_more_than_a_tenth_change_full(way, word) -> None:
    rng = np.random.default_rng(2)
    sizes = USUAL + rng.normal(0, 0.05, 16) + way * np.repeat([0.0, 0.3], 8)
    assert losses(of("size", sizes[:8])) is None
    loss = losses(of("size", sizes))
    assert loss is not None
    assert loss.growth == pytest.approx(way * 0.3, abs=0.1)
    assert word in str(loss.message)
    assert losses(of("size", USUAL + rng.normal(0, 0.05, 16) + way * np.repeat([0.0, 0.08], 8))) is None


def test_strokes_are_compared_with_those_of_the_same_full() -> None:
    sizes = [USUAL] * 6 + [USUAL - 0.4] * 6
    assert losses(of("size", sizes)) is not None
    assert losses(of("size", sizes), fulls=[2 * GESTURE.full] * 6 + [GESTURE.full] * 6) is None


def test_the_direction_is_compared_with_the_first_trials() -> None:
    assert losses(of("blind", [0.12] * 12)) is None
    loss = losses(of("blind", [0.01] * 5 + [0.01 + MOST_BLIND + 0.1] * 4))
    assert loss is not None
    assert loss.turns


def test_time_that_s5_took_is_a_loss_at_once() -> None:
    loss = losses([{}, {"silent": 0.3, "noise": None, "size": None, "missed": None, "blind": None}])
    assert loss is not None
    assert loss.silenced
    assert "30 %" in str(loss.message)
    assert losses([{"silent": 0.3}, {}]) is None


def test_a_channel_that_drifts_out_of_its_range_now_and_then_is_no_loss() -> None:
    assert losses(of("silent", [0.07, 0.1, 0.0, 0.03, 0.04, 0.0, 0.08])) is None
    again_and_again = losses(of("silent", [0.15] * 6))
    assert again_and_again is not None
    assert again_and_again.silenced


@given(
    st.sampled_from(["noise", "size", "missed", "blind"]),
    st.lists(st.floats(-3.0, 3.0), min_size=1, max_size=12),
    st.lists(st.booleans(), min_size=12, max_size=12),
)
def test_whatever_the_figures_are_a_loss_has_words_and_something_to_do(figure, values, seen) -> None:
    trials = of(figure, [value if there else None for value, there in zip(values, seen, strict=False)])
    loss = losses(trials)
    if loss is not None:
        assert str(loss.message).endswith(".")
        assert loss.silenced or loss.turns or loss.dead_zone is not None or loss.growth is not None
        assert loss.dead_zone is None or 0.0 < loss.dead_zone <= max(GESTURE.dead_zone, GESTURE.full / 2)
    assert losses(trials) == loss


@pytest.fixture
def person():
    return SimulatedPerson(layout_of(), seed=3)


@pytest.fixture
def parameters(person):
    return standard_parameters(calibrate(person))


def test_louder_rest_and_larger_strokes_are_measured(person, parameters) -> None:
    usual = gesture_trials(parameters, trial(person))
    larger = gesture_trials(parameters, trial(person, size=1.3))
    louder = gesture_trials(parameters, trial(person, noise=3.0))
    assert set(usual) == set(JOINTS)
    for name, one in usual.items():
        assert known(larger[name].size) - known(one.size) == pytest.approx(math.log(1.3), abs=0.08)
        assert known(louder[name].noise) - known(one.noise) == pytest.approx(math.log(3.0), abs=0.2)
        assert (one.missed, one.silent) == (0.0, 0.0)
        assert known(one.blind) < 0.02


def twice_as_fast(joint, kind):
    first, *earlier = joint.linear.rates
    rates = (tuple(2 * rate for rate in first), *earlier)
    return joint.model_copy(update={kind: joint.linear.model_copy(update={"rates": rates})})


@pytest.mark.parametrize("kind", ["guided", "prior"])
def test_the_figures_are_those_of_the_map_that_decodes(person, parameters, kind) -> None:
    driven = trial(person)
    joints = tuple(with_map_of(joint, kind) for joint in parameters.profile.joints)
    linear = parameters.model_copy(update={"profile": parameters.profile.model_copy(update={"joints": joints})})
    for name, one in gesture_trials(linear, driven).items():
        usual = gesture_trials(parameters, driven)[name]
        assert one.blind is None
        assert (one.noise, one.size) == pytest.approx((usual.noise, usual.size), abs=1e-6)
    doubled = tuple(twice_as_fast(joint, kind) for joint in joints)
    twice = linear.model_copy(update={"profile": linear.profile.model_copy(update={"joints": doubled})})
    for name, one in gesture_trials(twice, driven).items():
        single = gesture_trials(linear, driven)[name]
        assert known(one.noise) - known(single.noise) == pytest.approx(math.log(2.0), abs=1e-6)


def test_a_dead_zone_above_the_noise_misses_a_part_of_the_strokes(person, parameters) -> None:
    high = parameters.model_copy(
        update={"gestures": tuple(one.model_copy(update={"dead_zone": 0.6 * one.full}) for one in parameters.gestures)}
    )
    assert all(known(one.missed) > 0.2 for one in gesture_trials(high, trial(person)).values())


def out_of_range(person, parameters):
    """Return a trial in which the first channel lies out of its range."""
    driven = trial(person)
    driven.values[:, 0] += 10 * (parameters.profile.high[0] - parameters.profile.low[0])
    return driven


def test_a_channel_that_others_cannot_stand_in_for_silences_its_gesture_alone(person, parameters) -> None:
    alone = tuple(
        joint.model_copy(update={"covariance": covariance_of_independent(joint.direction)})
        for joint in parameters.profile.joints
    )
    lonely = parameters.model_copy(update={"profile": parameters.profile.model_copy(update={"joints": alone})})
    found = gesture_trials(lonely, out_of_range(person, parameters))
    assert found[JOINTS[0]] == (None, None, None, None, 1.0)
    assert found[JOINTS[1]].silent == 0.0


def test_a_channel_that_others_stand_in_for_silences_nothing_and_measures_nothing(person, parameters) -> None:
    driven = out_of_range(person, parameters)
    t = np.arange(len(driven.values)) / driven.sample_rate
    decoded = decode_block(parameters, driven.sample_rate, t, driven.values.astype(np.float32))
    assert decoded.activation[:, 0].max() == 1.0  # the movements count
    assert gesture_trials(parameters, driven)[JOINTS[0]] == (None, None, None, None, 0.0)


def test_a_trial_that_never_began_tells_the_noise_only(person, parameters) -> None:
    resting = person.rest(10.0)
    found = gesture_trials(parameters, Movement(resting, person.sample_rate, np.zeros(len(resting), dtype=bool)))
    assert all(one.noise is not None and one.size is None and one.blind is None for one in found.values())
    assert gesture_trials(parameters, Movement(resting[:0], person.sample_rate, np.zeros(0, dtype=bool))) == {}


def test_a_shirt_that_sits_otherwise_is_seen_as_blindness(person, parameters) -> None:
    before = gesture_trials(parameters, trial(person))
    put_on_again(person, share=0.4)
    after = gesture_trials(parameters, trial(person))
    told = [name for name in JOINTS if after[name].blind is not None]
    assert max(known(after[name].blind) - known(before[name].blind) for name in told) > 0.02


def test_what_was_read_with_the_same_set_is_not_read_again(person, parameters) -> None:
    driven = trial(person)
    asked = []

    def reading(name):
        return PastTrial(name, lambda: asked.append(name) or driven, {})

    first = read_trials(parameters, [reading("a")])
    second = read_trials(parameters, [reading("a"), reading("b")], first)
    assert asked == ["a", "b"]
    other = parameters.model_copy(update={"cutoff": 2.0})
    read_trials(other, [reading("a")], second)
    assert asked == ["a", "b", "a"]
    gone = [PastTrial("gone", lambda: None, {})]
    assert losses_of(parameters, parameters.profile, gone, read_trials(parameters, gone)) == {}
