"""Prompts that lead or trail the movement are shifted to it; the way back is found."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.guided.labels import CuedMovement, labels, lags_of

RATE = 100.0


def movements(count=4, move=0.8, hold=0.0, back=1.2, pause=2.0, before=1.5):
    """Return the rate of a joint (n,) that goes there and back, and the rows in which it rises."""
    place, rising = [np.zeros(round(before * RATE))], []
    for _ in range(count):
        start = sum(map(len, place))
        rising.append((start, start + round(move * RATE)))
        there = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, round(move * RATE)))
        home = 0.5 + 0.5 * np.cos(np.linspace(0, np.pi, round(back * RATE)))
        place += [there, np.ones(round(hold * RATE)), home, np.zeros(round(pause * RATE))]
    return np.gradient(np.concatenate(place)) * RATE, rising


@given(
    lead=st.floats(-0.15, 0.9),
    apart=st.lists(st.floats(-0.15, 0.15), min_size=4, max_size=4),
    gain=st.floats(0.01, 100.0),
)
@settings(max_examples=40, deadline=None)
def test_the_lag_of_every_repetition_is_found(lead, apart, gain):
    rate, rising = movements()
    lags = [round(RATE * (lead + one)) for one in apart]
    asked = [CuedMovement(start - lag, stop - lag) for (start, stop), lag in zip(rising, lags, strict=True)]
    assert lags_of(gain * rate, asked, RATE) == pytest.approx(lags, abs=3)


def test_noise_does_not_move_the_lag_far():
    rate, rising = movements()
    asked = [CuedMovement(start - 30, stop - 30) for start, stop in rising]
    noisy = rate + np.random.default_rng(1).normal(scale=0.3, size=len(rate))
    assert lags_of(noisy, asked, RATE) == pytest.approx([30] * 4, abs=8)


def test_the_movement_is_plus_one_the_way_back_minus_one_and_rest_zero():
    rate, rising = movements()
    found = labels(rate, [CuedMovement(*one) for one in rising], [0] * 4, RATE)
    for start, stop in rising:
        assert (found[start:stop] == 1).all()
        assert (found[stop : stop + 110] == -1).all()
        assert (found[stop + 130 : stop + 300] == 0).all()
    assert (found[:150] == 0).all()


def test_the_way_back_after_a_held_posture_is_where_it_falls():
    rate, rising = movements(hold=1.8)
    found = labels(rate, [CuedMovement(*one) for one in rising], [0] * 4, RATE)
    for _, stop in rising:
        assert (found[stop : stop + 150] == 0).all()
        assert (found[stop + 190 : stop + 290] == -1).all()


def test_what_lies_outside_of_the_recording_is_cut_off():
    rate, rising = movements(count=1, pause=0.0)
    asked = [CuedMovement(rising[0][0] - 140, rising[0][1] - 140)]
    found = labels(rate[:240], asked, [140], RATE)
    assert found.shape == (240,)
    assert (found[230:] == -1).all()
    assert len(labels(rate[:100], [CuedMovement(0, 90)], [-50], RATE)) == 100


def test_movements_that_follow_at_once_leave_the_next_one_its_place():
    rate, rising = movements(pause=0.0, back=0.6)
    found = labels(rate, [CuedMovement(*one) for one in rising], [0] * 4, RATE)
    for start, stop in rising:
        assert (found[start:stop] == 1).all()
