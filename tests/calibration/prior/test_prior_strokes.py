"""Strokes, landmarks and features of a prior's map: found where they are, and alike at every sample rate."""

import numpy as np
import pytest
from calibration.prior.simulated_wearers import RATE, Wearer, prior_of
from calibration.prior.test_prior_map import decoded, fitted
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.features import features
from app.calibration.guided.labels import CuedMovement
from app.calibration.linear_map import KINDS
from app.calibration.prior.frames import movement_lags, prompted_frames, stroke_labels
from app.calibration.prior.landmarks import Landmarks, landmarks
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.moments import Moments, mean_of
from app.hardware.shirt.standard import standard_layout
from app.layout import Channel, Joint, ShirtLayout


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("early", [0.0, 0.3, 0.8])
def test_the_lag_behind_the_cue_is_found(seed, early):
    wearer = Wearer(seed)
    rows = round(early * RATE)
    cued = [CuedMovement(start - rows, stop - rows) for start, stop in wearer.strokes if start > rows]
    lags = np.array(movement_lags(wearer.values, cued, RATE))
    assert np.abs(lags / RATE - early).max() < 0.25
    assert abs(np.median(lags) / RATE - early) < 0.15


@pytest.mark.parametrize("seed", range(5))
def test_labels_cover_the_strokes_and_nothing_at_rest(seed):
    wearer = Wearer(seed)
    stretch = wearer.stretch()
    frames = prompted_frames([stretch], range(5), np.ones(5), RATE)
    truth = np.roll(wearer.moving, round(0.075 * RATE))[: len(frames.label)]  # the low-pass delays the features
    assert (frames.label[truth] > 0).mean() > 0.7
    assert truth[frames.label > 0].mean() > 0.8
    assert frames.repetitions == len(stretch.moving)


@pytest.mark.parametrize("longer", [0.1, 0.2, 0.3])
def test_labels_end_with_the_movement_when_the_cue_was_longer(longer):
    wearer = Wearer(3)
    stretch = wearer.stretch()
    cues = tuple(slice(one.start, one.stop + round(longer * RATE)) for one in stretch.moving)
    frames = prompted_frames([type(stretch)(stretch.joint, stretch.values, cues)], range(5), np.ones(5), RATE)
    truth = np.roll(wearer.moving, round(0.075 * RATE))[: len(frames.label)]
    assert truth[frames.label > 0].mean() > 0.8
    assert (frames.label[truth] > 0).mean() > 0.6


def test_a_cue_longer_than_the_movement_does_not_teach_that_rest_is_movement():
    rate = np.zeros(400)
    rate[100:140] = np.sin(np.linspace(0, np.pi, 40))
    rate[180:230] = -0.7 * np.sin(np.linspace(0, np.pi, 50))
    label = stroke_labels(rate, [CuedMovement(80, 180)], [0], 100.0)
    assert set(np.flatnonzero(label > 0)) <= set(range(100, 140))
    assert (label[105:135] == 1).all()
    assert (label[190:220] == -1).all()
    assert not label[240:].any()


def test_where_nothing_rises_there_is_no_stroke():
    assert (stroke_labels(-np.ones(100), [CuedMovement(20, 50)], [0], 100.0) <= 0).all()


def test_without_a_cue_there_are_no_frames():
    wearer = Wearer(1)
    short = wearer.stretch(1)
    short = type(short)(short.joint, short.values, (slice(50, 55),))
    assert prompted_frames([short], range(5), np.ones(5), RATE) is None
    assert prompted_frames([], range(5), np.ones(5), RATE) is None


def cuff(sides, places) -> ShirtLayout:
    channels = tuple(
        Channel(name=f"c{i}", joint="elbow", ring="cuff", side=side, position=None if x is None else (x, 0.5))
        for i, (side, x) in enumerate(zip(sides, places, strict=True))
    )
    return ShirtLayout(name="cuff", channels=channels, joints=(Joint(name="elbow", label="Elbow"),))


def test_both_elbows_of_the_standard_shirt_have_their_front_a_quarter_before_their_outer_side() -> None:
    for ring in ("right_elbow", "left_elbow"):
        front, outside = landmarks(standard_layout(), ring)
        assert front == 1.5  # between the four sensors at the front, which come first
        assert outside == pytest.approx(3.5, abs=0.2)


@pytest.mark.parametrize("turn", range(6))
def test_a_ring_that_begins_elsewhere_has_them_elsewhere(turn: int) -> None:
    sides = ["front", "front", "front", "back", "back", "back"]
    x = [0.3, 0.2, 0.1, 0.1, 0.2, 0.3]
    found = landmarks(cuff(sides[turn:] + sides[:turn], x[turn:] + x[:turn]), "cuff")
    assert found == Landmarks(front=(1 - turn) % 6, outside=(2.5 - turn) % 6)


def test_what_the_layout_does_not_say_is_not_known() -> None:
    assert landmarks(cuff([None] * 4, [None] * 4), "cuff") == Landmarks(None, None)
    assert landmarks(cuff(["front", None, "back", "back"], [0.1, 0.1, 0.1, 0.1]), "cuff") == Landmarks(None, None)
    assert landmarks(cuff(["front", "back", "front", "back"], [0.1, 0.3, 0.1, 0.3]), "cuff") == Landmarks(None, None)


LARGEST_ACCELERATION = 2.1**2  # signal units/s², of the movement below


def movement(rate, seconds=6.0):
    t = np.arange(round(seconds * rate)) / rate
    return np.column_stack((np.sin(2.1 * t), np.cos(1.3 * t) + 0.2 * t))


@given(seed=st.integers(0, 1000), rate=st.floats(20.0, 300.0), k=st.integers(1, 4), cut=st.integers(5, 150))
@settings(max_examples=40, deadline=None)
def test_features_are_linear_and_know_no_future(seed, rate, k, cut):
    rng = np.random.default_rng(seed)
    one, other = rng.normal(size=(2, 160, k))
    made = features(one, rate)
    assert made.shape == (160, KINDS * k)
    np.testing.assert_allclose(features(one + 3.0 * other, rate), made + 3.0 * features(other, rate), atol=1e-7 * rate)
    np.testing.assert_allclose(features(one[:cut], rate), made[:cut], atol=1e-9 * rate)


@pytest.mark.parametrize("rate", [25.0, 50.0, 100.0, 130.0, 250.0, 1000.0])
def test_the_same_movement_has_the_same_features_at_every_sample_rate(rate):
    """The rate between two frames is that of the middle between them, so it may be half a sample period late."""
    finest = 4000.0
    fine, coarse = features(movement(finest), finest), features(movement(rate), rate)
    at = np.round(np.arange(len(coarse)) / rate * finest).astype(int)
    settled = slice(round(1.0 * rate), None)
    difference = np.abs(coarse - fine[at])[settled].max()
    half_a_period, half_a_fine_one = 0.5 / rate, 0.5 / finest
    assert difference < LARGEST_ACCELERATION * (half_a_period + half_a_fine_one)
    assert difference > 0.1 * LARGEST_ACCELERATION * half_a_period  # the limit is not far off


@pytest.mark.parametrize("rate", [25.0, 130.0, 1000.0])
def test_the_same_map_drives_alike_at_every_sample_rate(rate):
    """A pool of recordings of one rate, and people whose shirts have another one."""
    prior = MapPrior.of(prior_of(range(1, 9)))
    drives = []
    for one in (RATE, rate):
        wearer = Wearer(101, rate=one)
        drives.append(decoded(fitted(wearer, prior).profile, wearer))
    (in_phase, hit), (in_phase_then, hit_then) = drives
    assert abs(in_phase - in_phase_then) < 0.006
    assert abs(hit - hit_then) < 0.03


def test_an_earlier_rate_is_the_rate_of_then():
    made = features(movement(100.0), 100.0)
    np.testing.assert_allclose(made[100:, 2:4], made[95:-5, 0:2], atol=1e-12)
    np.testing.assert_allclose(made[100:, 8:10], made[80:-20, 0:2], atol=1e-12)


def random_moments(rng, k=2):
    made, label = rng.normal(size=(40, KINDS * k)), rng.integers(-1, 2, 40)
    label[0] = 1
    return Moments.of(made, label)


def equal(one, other):
    for name in ("gram", "moment", "stroke_mean", "stroke_gram"):
        np.testing.assert_allclose(getattr(one, name), getattr(other, name), atol=1e-9)


@given(seed=st.integers(0, 1000), count=st.integers(1, 6))
@settings(max_examples=25, deadline=None)
def test_the_order_of_a_sum_does_not_matter(seed, count):
    rng = np.random.default_rng(seed)
    every = [random_moments(rng) for _ in range(count)]
    equal(mean_of(every), mean_of(every[::-1]))


@given(seed=st.integers(0, 1000), factor=st.floats(0.1, 10.0))
@settings(max_examples=25, deadline=None)
def test_scaled_moments_are_those_of_scaled_features(seed, factor):
    rng = np.random.default_rng(seed)
    made, label = rng.normal(size=(30, KINDS * 2)), np.ones(30, dtype=np.int8)
    factors = np.array([factor, 1.0])
    equal(Moments.of(made, label).rescaled(factors), Moments.of(made * np.tile(factors, KINDS), label))


def test_moments_of_some_channels_and_back():
    rng = np.random.default_rng(1)
    made, label = rng.normal(size=(30, KINDS * 3)), np.ones(30, dtype=np.int8)
    made.reshape(30, KINDS, 3)[:, :, 1] = 0.0
    whole = Moments.of(made, label)
    equal(whole.of_channels([0, 2]).at_places([0, 2], 3), whole)
    equal(whole.of_channels([2, 1, 0]).of_channels([2, 1, 0]), whole)
