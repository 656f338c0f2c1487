"""The quality of control, for signals with known figures and for a recording on disk."""

import json
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded_trial import record_trial
from session.known_strokes import COUNT, JOINTS, RATE, SECONDS, along, frames, parameters, strokes, turned

from app.recording.format import META_FILE
from app.scoring.control_quality import control_quality, cross_talk
from app.scoring.joint_quality import map_fit, rest_noise, stretches
from app.session.recordings import quality_of_recording


def quality_of(values: np.ndarray, activation: np.ndarray | None = None, **more: Any):
    n = len(values)
    pulses = np.zeros((n, 2)) if activation is None else activation
    armed = more.pop("armed", np.ones(n, dtype=bool))
    return control_quality(parameters(**more), RATE, values, armed, pulses, 10.0)


@pytest.mark.parametrize("degrees", [0.0, 5.0, 17.0, 45.0, 80.0])
def test_the_angle_of_a_map_turned_by_a_known_angle(degrees):
    joint = quality_of(frames(along(turned(degrees), strokes()))).joints[0]
    assert joint.map_angle_deg == pytest.approx(degrees, abs=0.05)
    assert joint.evr == pytest.approx(1.0, abs=1e-4)
    assert joint.null_space_share == pytest.approx(math.sin(math.radians(degrees)) ** 2, abs=1e-4)
    assert joint.direction == pytest.approx(
        dict(zip([f"right_elbow_{i}" for i in range(COUNT)], turned(degrees), strict=True)), abs=1e-3
    )
    assert joint.label == "right elbow"


def test_the_share_of_the_null_space_is_exact():
    """Two movements, each in separate strokes: 1 FS along the map, 0.5 FS across it."""
    one, pause = strokes(1.0, 20.0), np.zeros(2000)
    movement = along(turned(0), np.concatenate((one, pause))) + along(turned(90), np.concatenate((pause, 0.5 * one)))
    quality = quality_of(frames(movement))
    # A little more of the smaller movement is too slow to count.
    assert quality.joints[0].evr == pytest.approx(0.8, abs=0.03)
    assert quality.joints[0].null_space_share == pytest.approx(1.0 - quality.joints[0].evr, abs=1e-3)
    assert quality.joints[0].map_angle_deg == pytest.approx(0.0, abs=0.5)
    assert quality.joints[1].map_angle_deg is None
    assert quality.joints[1].moved == 0.0
    assert (quality.map_angle_deg, quality.evr) == (quality.joints[0].map_angle_deg, quality.joints[0].evr)


@given(
    seed=st.integers(0, 2**32 - 1),
    count=st.integers(2, 7),
    degrees=st.floats(0.0, 90.0),
    across=st.floats(0.0, 0.9),
    scale=st.floats(1e-3, 1e3),
)
def test_angle_evr_and_null_space_are_those_of_the_covariance(seed, count, degrees, across, scale):
    """Movement with the variances 1 along a direction and `across` along one that is perpendicular to it."""
    random = np.random.default_rng(seed)
    basis = np.linalg.qr(random.standard_normal((count, count)))[0]
    direction, aside = basis[:, 0], basis[:, 1]
    t = np.arange(1000) / RATE
    movement = scale * (
        np.sin(2 * math.pi * t)[:, np.newaxis] * direction
        + math.sqrt(across) * np.cos(2 * math.pi * t)[:, np.newaxis] * aside
    )
    angle = math.radians(degrees)
    weights = math.cos(angle) * direction + math.sin(angle) * aside
    fit = map_fit(movement, np.ones(1000, dtype=bool), weights, RATE)
    assert fit is not None
    assert fit.angle_deg == pytest.approx(degrees, abs=1e-4)
    assert fit.evr == pytest.approx(1.0 / (1.0 + across), abs=1e-9)
    seen = (math.cos(angle) ** 2 + across * math.sin(angle) ** 2) / (1.0 + across)
    assert fit.null_space_share == pytest.approx(1.0 - seen, abs=1e-9)
    assert fit.null_space_share >= 1.0 - fit.evr - 1e-9
    assert fit.direction @ weights >= 0


def test_slow_drift_between_strokes_is_no_movement():
    drift = np.linspace(0.0, 1.5, round(SECONDS * RATE))
    joint = quality_of(frames(along(turned(0), strokes()) + drift[:, np.newaxis] * turned(90))).joints[0]
    assert joint.map_angle_deg < 1.0
    assert joint.null_space_share < 0.005


def test_the_span_is_given_as_a_share_of_the_calibrated_span():
    joint = quality_of(frames(along(turned(0), strokes(0.6)))).joints[0]
    assert joint.span_share == pytest.approx(0.6, abs=0.01)
    assert joint.span == pytest.approx(1.2, abs=0.02)


def test_only_frames_with_motion_permitted_count():
    permitted = np.arange(round(SECONDS * RATE)) < 2000
    movement = along(turned(10), strokes())
    movement[~permitted] = along(turned(70), 2.0 * strokes())[~permitted]
    joint = quality_of(frames(movement), armed=permitted).joints[0]
    assert joint.map_angle_deg == pytest.approx(10.0, abs=0.1)
    assert joint.span_share == pytest.approx(math.cos(math.radians(10)), abs=0.02)


def test_too_little_movement_has_no_figures():
    quality = quality_of(frames(along(turned(40), strokes()))[:300])
    assert quality.joints[0].map_angle_deg is None
    assert quality.map_angle_deg is quality.evr is quality.null_space_share is None


@pytest.mark.parametrize("noise", [0.02, 0.1])
def test_noise_at_rest_is_measured_between_strokes(noise):
    """A rate with noise of a known size, and with strokes in half of the time."""
    random = np.random.default_rng(3)
    rate = noise * random.standard_normal(6000) + np.where(
        np.arange(6000) % 400 < 200, 3.0 * np.sin(np.arange(6000)), 0
    )
    found = rest_noise(rate, np.ones(6000, dtype=bool), RATE)
    assert found == pytest.approx(noise, rel=0.15)


def test_a_rest_too_short_has_no_noise():
    assert rest_noise(np.zeros(200), np.ones(200, dtype=bool), RATE) is None


def test_stretches_are_found_to_the_sample():
    flags = np.array([1, 1, 0, 0, 1, 1, 1, 0, 1], dtype=bool)
    assert stretches(flags, 2) == [slice(0, 2), slice(4, 7)]
    assert stretches(np.zeros(3, dtype=bool), 1) == []


def pulses(n: int, beginnings: list[int], length: int = 50) -> np.ndarray:
    column = np.zeros(n)
    for start in beginnings:
        column[start : start + length] = 0.8
    return column


def test_activations_are_counted_exactly():
    values = frames(along(turned(0), strokes()))
    activation = np.column_stack((pulses(4000, [100, 500, 900]), pulses(4000, [1500])))
    quality = quality_of(values, activation)
    assert [joint.activations for joint in quality.joints] == [3, 1]
    assert quality.activations == 4
    assert quality.activations_per_metre == pytest.approx(0.4)
    assert quality.cross_talk == 0.0
    assert quality_of(values, activation, bound=JOINTS[:1]).activations == 3
    assert (
        control_quality(parameters(), RATE, values, np.ones(4000, bool), activation, 0.1).activations_per_metre is None
    )


def test_cross_talk_is_the_share_of_all_but_the_strongest_gesture():
    assert cross_talk(np.array([[0.8, 0.0], [0.0, 0.4]])) == pytest.approx(0.0)
    assert cross_talk(np.array([[0.5, 0.5], [0.5, 0.5]])) == pytest.approx(0.5)
    assert cross_talk(np.array([[0.9, 0.1], [0.0, 0.0]])) == pytest.approx(0.1)
    assert cross_talk(np.zeros((5, 2))) is None


def test_a_stop_on_purpose_is_no_cross_talk():
    together = np.array([[0.9, 0.9], [0.6, 0.0]])
    assert cross_talk(together) == pytest.approx(0.9 / 2.4)
    assert cross_talk(together, [[0, 1]]) == 0.0
    n = 4000
    activation = np.column_stack((pulses(n, [100]), pulses(n, [100])))
    values = frames(along(turned(0), strokes()))
    assert quality_of(values, activation).cross_talk == pytest.approx(0.5)
    assert quality_of(values, activation, stop=True).cross_talk is None


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 8))
def test_cross_talk_lies_between_its_limits(seed, count):
    activation = np.random.default_rng(seed).random((20, count)) * (
        np.random.default_rng(seed + 1).random((20, 1)) > 0.3
    )
    share = cross_talk(activation)
    assert share is None or 0.0 <= share <= (count - 1) / count + 1e-12


@pytest.mark.parametrize("dead", [np.nan, 1.0, 40.0])
def test_a_failed_channel_is_named_and_left_out(dead):
    values = frames(along(turned(20), strokes()))
    values[1000:, 2] = dead  # the channel across the map dies after a quarter of the time
    quality = quality_of(values)
    (bad,) = quality.bad_channels
    assert (bad.name, bad.joint, bad.silent) == ("right_elbow_2", "right_elbow", True)
    assert bad.share == pytest.approx(0.75, abs=0.01)
    assert quality.joints[0].map_angle_deg == pytest.approx(0.0, abs=0.1)
    assert "right_elbow_2" not in quality.joints[0].direction


def test_a_short_drop_out_costs_only_its_own_moment():
    values = frames(along(turned(20), strokes()))
    values[1000:1100, 0] = np.nan
    quality = quality_of(values)
    assert [(bad.name, bad.share, bad.silent) for bad in quality.bad_channels] == [("right_elbow_0", 100 / 4000, True)]
    assert quality.joints[0].map_angle_deg == pytest.approx(20.0, abs=0.2)


def test_a_channel_beyond_its_range_is_not_silent():
    values = frames(along(turned(20), strokes()))
    values[:, 1] += 10.0
    (bad,) = quality_of(values).bad_channels
    assert (bad.name, bad.share, bad.silent) == ("right_elbow_1", 1.0, False)


def test_a_joint_without_a_channel_left_has_no_figures():
    values = frames(along(turned(0), strokes()))
    values[:, :COUNT] = 1.0
    joint = quality_of(values).joints[0]
    assert (joint.map_angle_deg, joint.span, joint.rest_rate, joint.direction) == (None, None, None, None)


@pytest.mark.parametrize(
    ("values", "armed", "activation", "words"),
    [
        (np.zeros((9, 7)), np.ones(9, bool), np.zeros((9, 2)), "frames of this shirt"),
        (np.zeros((9, 8)), np.zeros(9, bool), np.zeros((9, 2)), "permitted"),
        (np.zeros((9, 8)), np.ones(9, bool), np.zeros((9, 3)), "other gestures"),
    ],
)
def test_what_does_not_fit_is_refused_in_a_sentence(values, armed, activation, words):
    with pytest.raises(ValueError, match=words):
        control_quality(parameters(), RATE, values, armed, activation, 5.0)


def test_the_quality_of_a_recorded_trial_uses_its_own_parameters(tmp_path):
    values = frames(along(turned(20), strokes(seconds=30.0)))
    record_trial(tmp_path / "run", parameters(), values=values)
    quality = quality_of_recording(tmp_path / "run")
    joint = quality.joints[0]
    assert joint.map_angle_deg == pytest.approx(20.0, abs=0.1)
    assert joint.activations == len(values) / RATE / 2 - 1  # one stroke every two seconds; at the first it is not armed
    assert quality.activations == joint.activations
    assert quality.cross_talk == 0.0
    assert quality.bad_channels == ()


def test_a_recording_without_parameters_is_refused(tmp_path):
    run = tmp_path / "run"
    run.mkdir()
    (run / META_FILE).write_text(json.dumps({"sample_rate": RATE}))
    with pytest.raises(ValueError, match="with what parameters"):
        quality_of_recording(run)
    with pytest.raises(ValueError, match="no recording"):
        quality_of_recording(tmp_path / "nowhere")
