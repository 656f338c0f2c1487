"""A recorded trial, decoded with another parameter set."""

import pytest
from session.test_adaptation_reading import AS_CALIBRATED, parameters, trial  # noqa: F401

from app.faults import State
from app.recording.reader import read_run
from app.scoring.trial_forecast import predicted_effect


def test_equal_parameters_give_an_equal_trial(parameters, trial) -> None:  # noqa: F811
    effect = predicted_effect(read_run(trial("a", AS_CALIBRATED)), parameters, parameters)
    assert effect is not None
    assert (effect.alike, effect.felt_change) == (1.0, 0.0)
    assert effect.activations_before == effect.activations_after == 20  # a stroke every 1.5 s
    assert effect.false_before == effect.false_after == 0


def test_a_dead_zone_within_the_noise_is_found_before_driving(parameters, trial) -> None:  # noqa: F811
    low = tuple(gesture.model_copy(update={"dead_zone": 0.01}) for gesture in parameters.gestures)
    effect = predicted_effect(
        read_run(trial("a", AS_CALIBRATED)), parameters, parameters.model_copy(update={"gestures": low})
    )
    assert effect is not None
    assert effect.activations_after > 5 * effect.activations_before
    assert effect.false_after > 20
    assert effect.alike < 0.9


def test_a_gesture_without_effect_is_found_too(parameters, trial) -> None:  # noqa: F811
    high = tuple(gesture.model_copy(update={"dead_zone": 50.0, "full": 60.0}) for gesture in parameters.gestures)
    effect = predicted_effect(
        read_run(trial("a", AS_CALIBRATED)), parameters, parameters.model_copy(update={"gestures": high})
    )
    assert effect is not None
    assert (effect.activations_after, effect.felt_change) == (0, pytest.approx(1.0))


def test_a_trial_without_motion_has_no_forecast(parameters, trial) -> None:  # noqa: F811
    run = read_run(trial("still", state=State.DISARMED))
    assert predicted_effect(run, parameters, parameters) is None


def test_another_shirt_is_refused_in_a_sentence(parameters, trial) -> None:  # noqa: F811
    fewer = parameters.profile.layout.model_copy(update={"channels": parameters.profile.layout.channels[:2]})
    other = parameters.model_copy(update={"profile": parameters.profile.model_copy(update={"layout": fewer})})
    with pytest.raises(ValueError, match="channels"):
        predicted_effect(read_run(trial("a")), other, parameters)
