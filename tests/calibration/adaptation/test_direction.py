"""The turn of a direction never flips its sign and never exceeds its limit, whatever the covariance."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from app.calibration.adaptation.direction import (
    angle,
    exponential_covariance,
    felt_change,
    principal,
    share_along,
    turn_towards,
)

SIZES = st.sampled_from([1e-12, 1e-3, 1.0, 1e6, 1e12])


@st.composite
def directions(draw, k):
    vector = draw(arrays(np.float64, k, elements=st.floats(-1, 1)))
    assume(np.linalg.norm(vector) > 1e-3)
    return vector / np.linalg.norm(vector)


@st.composite
def covariances(draw, k):
    """Covariances of all kinds: of rank one, with equal eigenvalues, huge, tiny, nothing at all, and any other."""
    scale = draw(SIZES)
    kind = draw(st.sampled_from(["rank one", "equal", "zero", "any", "two equal"]))
    if kind == "zero":
        return np.zeros((k, k))
    if kind == "equal":
        return scale * np.eye(k)
    if kind == "rank one":
        one = draw(directions(k))
        return scale * np.outer(one, one)
    if kind == "two equal":
        return scale * np.diag([1.0, 1.0, *([0.5] * (k - 2))])
    rows = draw(arrays(np.float64, (k + 1, k), elements=st.floats(-1, 1)))
    return scale * rows.T @ rows


@given(st.data(), st.integers(2, 9), st.floats(0.1, 5.0))
def test_over_any_updates_no_step_is_too_long_and_no_sign_flips(data, k, most) -> None:
    weights = data.draw(directions(k))
    for covariance in data.draw(st.lists(covariances(k), min_size=1, max_size=6)):
        found = principal(covariance, weights)
        if found is None:
            continue
        assert found.weights @ weights > 0.0
        assert 0.0 <= found.share <= 1.0
        step = turn_towards(weights, found.weights, most)
        assert np.linalg.norm(step) == pytest.approx(1.0)
        assert angle(weights, step) <= most + 1e-6
        assert step @ weights > 0.99
        assert angle(step, found.weights) <= angle(weights, found.weights) + 1e-6
        weights = step


@given(st.data(), st.integers(1, 6), SIZES)
@settings(max_examples=40, deadline=None)
def test_a_covariance_has_no_more_than_what_moved(data, k, scale) -> None:
    moved = scale * data.draw(arrays(np.float64, (20, k), elements=st.floats(-1, 1)))
    still = data.draw(st.integers(0, k - 1))
    moved[:, still] = 0.0
    covariance = exponential_covariance(moved, 10.0, 1.0)
    assert np.isfinite(covariance).all()
    assert not covariance[still].any()
    assert np.linalg.eigvalsh(covariance).min() >= -1e-9


def test_the_newest_movement_weighs_most() -> None:
    moved = np.concatenate([np.tile([1.0, 0.0], (100, 1)), np.tile([0.0, 1.0], (100, 1))])
    covariance = exponential_covariance(moved, 100.0, half_life=0.5)
    assert covariance[1, 1] / covariance[0, 0] == pytest.approx(4.0, rel=0.02)  # a second is two half-lives


def test_a_number_that_is_not_finite_changes_nothing() -> None:
    assert not exponential_covariance(np.array([[np.nan, 1.0]]), 100.0).any()
    assert not exponential_covariance(np.empty((0, 2)), 100.0).any()
    assert principal(np.full((2, 2), np.nan), np.array([1.0, 0.0])) is None


def test_orthogonal_to_the_old_direction_there_is_no_sign() -> None:
    assert principal(np.diag([0.0, 1.0]), np.array([1.0, 0.0])) is None


def test_the_felt_change_is_that_of_the_definition() -> None:
    x = np.array([[1.0, 0.0], [2.0, 0.0], [0.0, 1.0]])
    before, after = np.array([1.0, 0.0]), np.array([1.1, 0.0])
    assert felt_change(before, after, x, 100.0) == pytest.approx(0.1)
    assert felt_change(before, before, x, 100.0) == 0.0
    assert felt_change(np.array([0.0, 0.0]), after, x, 100.0) == math.inf
    old = np.tile([0.0, 1.0], (100, 1))  # more than a minute ago, at one row a second
    late = np.concatenate([old, np.tile([1.0, 0.0], (60, 1))])
    assert felt_change(np.array([1.0, 1.0]), np.array([1.0, 2.0]), late, 1.0) == 0.0


def test_the_share_of_the_variance_along_a_direction() -> None:
    assert share_along(np.diag([3.0, 1.0]), np.array([1.0, 0.0])) == pytest.approx(0.75)
    assert share_along(np.zeros((2, 2)), np.array([1.0, 0.0])) == 0.0
