"""Linear maps of all kinds: decoding frame by frame and at once agree, and follow the definition."""

import copy

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.features import features
from app.calibration.linear_map import AVERAGING_TIMES, LinearMap
from app.calibration.vocabulary import DriveParameters
from app.pipeline.decoder import Decoder, periods_between
from app.pipeline.replay.batch import decode_block
from building import guided_map, make_parameters, make_signals, with_gesture


def guided_parameters(guided=(0, 2), levels=True, **changes):
    """Return parameters whose joints numbered `guided` have random guided maps that decode."""
    document = make_parameters(**changes).model_dump(mode="json")
    rng = np.random.default_rng(7)
    for i in guided:
        joint = document["profile"]["joints"][i]
        k = len(joint["channels"])
        joint["map"] = "guided"
        joint["guided"] = guided_map(
            (tuple((rng.normal(size=k) / 6).tolist()),),
            short=tuple((levels * rng.normal(size=k) / 3).tolist()),
            long=tuple((levels * rng.normal(size=k) / 3).tolist()),
        ).model_dump(mode="json")
    return DriveParameters.model_validate(document)


def prior_parameters(joints=(0, 1, 2, 3), guided=(), **changes):
    """Return parameters whose joints numbered `joints` have random prior maps that decode."""
    document = guided_parameters(guided, **changes).model_dump(mode="json")
    rng = np.random.default_rng(8)
    for i in joints:
        joint = document["profile"]["joints"][i]
        k = len(joint["channels"])
        weights = rng.normal(size=(7, k)) / 6
        joint["map"] = "prior"
        joint["prior"] = LinearMap(
            rates=tuple(tuple(part) for part in weights[:5].tolist()),
            short=tuple(weights[5].tolist()),
            long=tuple(weights[6].tolist()),
            dead_zone=0.2,
            full=1.0,
            people=8,
        ).model_dump(mode="json")
    return DriveParameters.model_validate(document)


@pytest.mark.parametrize("sample_rate", [10.0, 33.3, 1000.0])
def test_a_gap_counts_in_whole_periods_up_to_a_second_however_long_it_is(sample_rate):
    assert [periods_between(n / sample_rate, sample_rate) for n in (0.2, 1.4, 1.6, 7.0)] == [1.0, 1.0, 2.0, 7.0]
    for gap in (1.1, 5.0, 1e12, 1e308):
        assert periods_between(gap, sample_rate) == pytest.approx(sample_rate)


def stream(parameters, device, values):
    """Return score, rate and activation (n, n_gestures) frame by frame."""
    sample_rate = parameters.profile.sample_rate
    decoder = Decoder(parameters, sample_rate)
    rows = []
    steps = np.diff(device, prepend=device[0] - 1 / sample_rate)
    for frame, step in zip(values, steps, strict=True):
        decoder.step(frame, periods_between(step, sample_rate))
        rows.append([list(decoder.score), list(decoder.rate), list(decoder.activation)])
    return np.array(rows).transpose(1, 0, 2)


def assert_alike(parameters, device, values):
    block = decode_block(parameters, parameters.profile.sample_rate, device, values)
    score, rate, activation = stream(parameters, device, values)
    np.testing.assert_allclose(block.score, score, atol=1e-9)
    np.testing.assert_allclose(block.rate, rate, atol=1e-9)
    np.testing.assert_allclose(block.activation, activation, atol=1e-9)
    return rate, activation


@given(
    seed=st.integers(0, 10_000),
    rate=st.one_of(st.sampled_from([20.0, 50.0, 100.0, 250.0, 1000.0]), st.floats(20.0, 1000.0)),
    guided=st.sets(st.integers(0, 3)),
    prior=st.sets(st.integers(0, 3), min_size=1),
    cutoff=st.floats(1.0, 8.0),
    lost=st.floats(0.0, 0.05),
    broken=st.lists(st.tuples(st.integers(0, 51), st.integers(0, 350), st.integers(1, 60)), max_size=3),
)
@settings(max_examples=25, deadline=None)
def test_frame_by_frame_is_the_whole_at_once(seed, rate, guided, prior, cutoff, lost, broken):
    parameters = prior_parameters(sorted(prior), sorted(guided), sample_rate=rate)
    parameters = parameters.model_copy(update={"cutoff": cutoff})
    values = make_signals(parameters, 400, seed)
    for channel, start, length in broken:
        values[start : start + length, channel] = np.nan
    kept = np.random.default_rng(seed).random(400) >= lost
    kept[0] = True
    device = (np.arange(400) / rate)[kept]
    block = decode_block(parameters, rate, device, values[kept])
    score, rates, _ = stream(parameters, device, values[kept])
    np.testing.assert_allclose(block.score, score, atol=1e-9)
    np.testing.assert_allclose(block.rate, rates, atol=1e-6)


@pytest.mark.parametrize("rate", [20.0, 30.0, 75.0, 100.0, 333.3, 1000.0])
def test_a_prior_map_decodes_the_features_that_it_was_learnt_from(rate):
    parameters = prior_parameters(sample_rate=rate)
    values = make_signals(parameters, 600)
    rates = stream(parameters, np.arange(600) / rate, values)[1]
    for joint, decoded in zip(parameters.profile.joints, rates.T, strict=True):
        own = features(values[:, joint.channels].astype(float), rate)
        np.testing.assert_allclose(decoded, own @ np.concatenate(joint.prior.parts), atol=1e-6)


def test_the_rate_is_what_the_definition_says():
    from scipy.signal import butter, lfilter

    parameters = guided_parameters((1,))
    values = make_signals(parameters, 3000)
    rate, activation = assert_alike(parameters, np.arange(3000) / 100, values)
    joint = parameters.profile.joints[1]
    own = values[:, joint.channels].astype(float)
    total = np.diff(own @ joint.guided.rates[0], prepend=own[0] @ joint.guided.rates[0]) * 100
    for part, memory in zip((joint.guided.short, joint.guided.long), AVERAGING_TIMES, strict=True):
        level, slow = own @ part, own[0] @ part
        for k, now in enumerate(level):
            slow += (1 - np.exp(-1 / (100 * memory))) * (now - slow)
            total[k] += now - slow
    expected = lfilter(*butter(2, 3.0, fs=100.0), total)
    np.testing.assert_allclose(rate[:, 1], expected, atol=1e-9)
    assert activation[:, 1].max() > 0.1


def test_joints_without_a_guided_map_decode_as_ever():
    plain, mixed = make_parameters(), guided_parameters((0,))
    values = make_signals(plain, 2000)
    t = np.arange(2000) / 100
    blocks = decode_block(plain, 100.0, t, values), decode_block(mixed, 100.0, t, values)
    np.testing.assert_allclose(*(block.rate[:, 1:] for block in blocks), atol=1e-12)
    np.testing.assert_allclose(*(stream(one, t, values)[1][:, 1:] for one in (plain, mixed)), atol=1e-12)
    np.testing.assert_allclose(*(stream(one, t, values)[0] for one in (plain, mixed)), atol=1e-12)


def test_a_guided_map_that_is_only_offered_does_not_decode():
    offered = guided_parameters((0,)).model_dump(mode="json")
    offered["profile"]["joints"][0]["map"] = "pca"
    values = make_signals(make_parameters(), 1000)
    t = np.arange(1000) / 100
    np.testing.assert_array_equal(
        decode_block(DriveParameters.model_validate(offered), 100.0, t, values).rate,
        decode_block(make_parameters(), 100.0, t, values).rate,
    )


def test_against_the_prompted_direction_the_way_back_counts():
    forwards = guided_parameters((0,))
    backwards = with_gesture(forwards, 0, direction=-1)
    values = make_signals(forwards, 2000)
    t = np.arange(2000) / 100
    one, _ = assert_alike(forwards, t, values)
    other, activation = assert_alike(backwards, t, values)
    np.testing.assert_allclose(other[:, 0], -one[:, 0], atol=1e-12)
    assert activation[:, 0].max() > 0


def test_a_held_posture_keeps_the_map_of_the_paper():
    held = {"feature": "displacement", "dead_zone": 0.1, "full": 0.5}
    plain, guided = with_gesture(make_parameters(), 0, **held), with_gesture(guided_parameters((0,)), 0, **held)
    values = make_signals(plain, 1500)
    t = np.arange(1500) / 100
    rate, _ = assert_alike(guided, t, values)
    np.testing.assert_array_equal(rate[:, 0], stream(plain, t, values)[1][:, 0])


@pytest.mark.parametrize("parameters", [guided_parameters((0,)), prior_parameters((0,))], ids=["guided", "prior"])
def test_a_channel_that_breaks_silences_its_gesture_and_its_return_is_no_movement(parameters):
    values = make_signals(parameters, 1000, strokes=False)
    values[300:500, 0] = np.nan
    values[500:, 0] += 40.0  # it comes back somewhere else
    rate, activation = assert_alike(parameters, np.arange(1000) / 100, values)
    assert not activation[300:500, 0].any()
    quiet = np.abs(rate[100:300, 0]).max()
    assert np.abs(rate[500:, 0]).max() < 3 * quiet + 0.05


@pytest.mark.parametrize(
    "parameters", [make_parameters(), guided_parameters((0,), levels=False)], ids=["pca", "guided"]
)
def test_missing_frames_do_not_make_a_movement_faster(parameters):
    t = np.arange(600) / 100
    values = np.outer(t, np.ones(52)).astype(np.float32)
    steady = stream(parameters, t, values)[1][-1, 0]
    kept = np.ones(600, dtype=bool)
    kept[400:406] = False
    gapped, _ = assert_alike(parameters, t[kept], values[kept])
    assert gapped[300:, 0] == pytest.approx(steady, rel=1e-3)


@pytest.mark.parametrize("parameters", [guided_parameters((0, 1, 2, 3)), prior_parameters()], ids=["guided", "prior"])
def test_after_a_reset_the_past_is_forgotten(parameters):
    values = make_signals(parameters, 300)
    decoder = Decoder(parameters, 100.0)
    runs = []
    for _ in range(2):
        decoder.reset()
        for frame in values:
            decoder.step(frame, 1.0)
        runs.append(list(decoder.rate))
    assert runs[0] == runs[1]


@pytest.mark.parametrize("parameters", [guided_parameters((0,)), prior_parameters((0,))], ids=["guided", "prior"])
def test_rest_is_rest(parameters):
    """Without movement the rate is exactly 0, whatever the posture and however long it is held."""
    decoder = Decoder(parameters, 100.0)
    still = np.tile(np.full(52, 7.0, dtype=np.float32), (15, 1))  # shorter than a flat line is
    for frame in still:
        decoder.step(frame, 1.0)
        assert decoder.rate[0] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.uncompiled
def test_a_copy_goes_on_as_the_original_and_without_it():
    parameters = prior_parameters(joints=(1,), guided=(2,))
    values = make_signals(parameters, 300)
    decoder = Decoder(parameters, 100.0)
    for frame in values[:150]:
        decoder.step(frame, 1.0)
    other = copy.deepcopy(decoder)
    rates = []
    for frame in values[150:]:
        decoder.step(frame, 1.0)
        rates.append(decoder.rate)
    for frame, rate in zip(values[150:], rates, strict=True):
        other.step(frame, 1.0)
        assert other.rate == rate
