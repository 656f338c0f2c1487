"""The figures of one trial: noise at rest, size of the strokes, time missed, blindness and silence."""

import math

import numpy as np
import pytest
from calibration.adaptation.driven_trial import known, put_on_again, trial, with_map_of
from calibration.simulated_person import JOINTS, SimulatedPerson, calibrate, layout_of

from app.calibration.adaptation.movement import Movement
from app.calibration.vocabulary import standard_parameters
from app.pipeline.replay.batch import decode_block
from app.scoring.map_losses.gesture_trial import gesture_trials
from app.scoring.map_losses.losses import PastTrial, losses_of, read_trials
from building import covariance_of_independent


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
