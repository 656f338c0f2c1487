"""The hits that a person's own repetitions let expect: by the time that each was asked for, if it lasted so long."""

import numpy as np
import pytest

from app.calibration.prior.forecasts import share_of_own
from app.calibration.prior.solving import OwnFrames


def own(label, asked):
    """Return the frames of repetitions of 100 rows each."""
    repetition = np.arange(len(label)) // 100
    return OwnFrames(np.zeros((len(label), 1)), np.asarray(label, np.int8), repetition, np.array(asked))


def label_of(*lengths):
    return np.concatenate([np.arange(100) < length for length in lengths]).astype(np.int8)


def test_what_is_not_labelled_of_a_movement_counts_as_missed():
    label = label_of(40)
    assert share_of_own(label.astype(float), 0.5, own(label, [50])) == pytest.approx(0.8)
    assert share_of_own(label.astype(float), 0.5, own(label, [40])) == 1.0


def test_a_cue_that_is_much_longer_than_the_movement_does_not_count_in_full():
    label = label_of(40)
    assert share_of_own(label.astype(float), 0.5, own(label, [90])) == pytest.approx(1 / 1.25)


def test_repetitions_are_counted_by_their_time():
    label = label_of(40, 20)
    rate = np.where(np.arange(200) < 100, label, 0.0)
    assert share_of_own(rate, 0.5, own(label, [40, 20])) == pytest.approx(40 / 60)
    assert share_of_own(-rate, 0.5, own(label, [40, 20])) == 0.0


def test_activation_outside_of_the_movements_is_no_hit():
    label = label_of(40)
    assert share_of_own(np.ones(100), 0.5, own(label, [40])) == 1.0
