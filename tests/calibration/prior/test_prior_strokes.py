"""Strokes, landmarks and features of a prior's map: found where they are, and alike at every sample rate."""

import numpy as np
import pytest
from calibration.prior.simulated_wearers import RATE, Wearer

from app.calibration.guided.labels import CuedMovement
from app.calibration.prior.frames import movement_lags, prompted_frames, stroke_labels
from app.calibration.prior.landmarks import Landmarks, landmarks
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
