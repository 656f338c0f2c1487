import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.pipeline.channel_health import ChannelHealth
from building import make_profile

CHANNELS = 8
EVERY = np.ones(CHANNELS, dtype=np.bool_)
values = st.one_of(st.floats(-300, 300), st.just(float("nan")), st.just(float("inf")), st.just(1.0))


def health(watched=EVERY, sample_rate=20.0):
    profile = make_profile(CHANNELS).model_copy(update={"low": (-100.0,) * CHANNELS, "high": (100.0,) * CHANNELS})
    return ChannelHealth(profile, watched, sample_rate)


def trembling(n, seed=0):
    return np.random.default_rng(seed).normal(size=(n, CHANNELS))


def test_a_well_shirt_has_nothing_to_report():
    watch = health()
    assert all(watch.step(frame.copy()) is None for frame in trembling(300))


def judged(value):
    """Return whether channel 3, and no other, is bad when it shows `value`."""
    frame = trembling(1)[0]
    frame[3] = value
    bad = health().step(frame)
    assert bad is None or bad.tolist() == [i == 3 for i in range(CHANNELS)]
    return bad is not None


def test_values_beyond_one_and_a_half_times_the_range_are_not_believed():
    for value in (149.9, -149.9, 0.0):
        assert not judged(value)
    for value in (150.1, -150.1, np.nan, np.inf, 1e308):
        assert judged(value)


def test_a_channel_that_stands_still_for_200_ms_is_bad_until_it_moves_again():
    watch, frames = health(), trembling(30)
    frames[10:20, 5] = 0.25
    bad_at = [i for i, frame in enumerate(frames) if watch.step(frame.copy()) is not None]
    assert bad_at == [14, 15, 16, 17, 18, 19]  # 4 periods of 50 ms after it stopped


def test_a_channel_whose_driver_watches_its_sensor_may_be_constant_until_the_driver_misses_it():
    """Safety S5: a tracker sends no orientation that has not changed."""
    profile = make_profile(CHANNELS).model_copy(update={"noise": (1.0,) * CHANNELS})
    channels = list(profile.layout.channels)
    channels[5] = channels[5].model_copy(update={"liveness": "arrival"})
    profile = profile.model_copy(update={"layout": profile.layout.model_copy(update={"channels": tuple(channels)})})
    frames = trembling(200)
    frames[20:, 3] = frames[50:, 5] = 0.25
    frames[180:, 5] = np.nan
    watch, whole = ChannelHealth(profile, EVERY, 100.0), ChannelHealth(profile, EVERY, 100.0)
    one_by_one = [watch.step(frame.copy()) for frame in frames]
    bad = np.array([np.zeros(CHANNELS, dtype=bool) if bad is None else bad for bad in one_by_one])
    assert np.flatnonzero(bad.any(axis=0)).tolist() == [3, 5]
    assert np.flatnonzero(bad[:, 5]).tolist() == list(range(180, 200))
    np.testing.assert_array_equal(whole.block(frames, None), bad)


def test_channels_that_nobody_reads_may_do_what_they_like():
    watched = EVERY.copy()
    watched[2] = False
    watch, frames = health(watched), trembling(50)
    frames[:, 2] = np.nan
    assert all(watch.step(frame.copy()) is None for frame in frames)


@given(st.lists(st.lists(values, min_size=CHANNELS, max_size=CHANNELS), min_size=1, max_size=40), st.integers(1, 20))
def test_at_once_is_the_same_as_frame_by_frame(rows, chunk):
    frames = np.array(rows)
    watch, whole = health(), health()
    one_by_one = []
    for frame in frames:
        bad = watch.step(frame.copy())
        one_by_one.append(np.zeros(CHANNELS, dtype=bool) if bad is None else bad)
    blocks = []
    for start in range(0, len(frames), chunk):
        before = frames[max(0, start - whole.memory) : start] if start else None
        blocks.append(whole.block(frames[start : start + chunk], before))
    np.testing.assert_array_equal(np.concatenate(blocks), one_by_one)


def quiet_health(sample_rate=100.0):
    """Return the health of channels whose noise in the calibration was that of `trembling`."""
    profile = make_profile(CHANNELS).model_copy(
        update={"low": (-100.0,) * CHANNELS, "high": (100.0,) * CHANNELS, "noise": (1.0,) * CHANNELS}
    )
    return ChannelHealth(profile, EVERY, sample_rate)


@pytest.mark.parametrize("value", [0.0, 40.0, -99.0])
@pytest.mark.parametrize("noise", [0.0, 0.1, 0.6])
def test_a_channel_that_is_stuck_with_less_than_its_own_noise_is_bad(value, noise):
    frames, rng = trembling(200), np.random.default_rng(2)
    frames[100:, 5] = value + noise * rng.integers(0, 2, 100)  # one bit
    watch = quiet_health()
    bad = np.array([watch.step(frame.copy()) is not None for frame in frames])
    assert not bad[:100].any()
    assert bad[130:].all()


@pytest.mark.parametrize("sample_rate", [20.0, 60.0, 100.0, 1000.0])
def test_a_channel_with_its_own_noise_is_never_stuck(sample_rate):
    watch = quiet_health(sample_rate)
    frames = trembling(20_000, seed=3)
    assert watch.bad_in_block(frames, None) is None
    assert all(watch.step(frame.copy()) is None for frame in frames[:3000])


@given(
    st.lists(st.tuples(st.integers(0, CHANNELS - 1), st.integers(0, 150), st.integers(1, 120)), max_size=4),
    st.sampled_from([20.0, 45.0, 100.0]),
    st.integers(1, 60),
    st.floats(0.0, 0.8),
)
def test_stuck_at_once_is_the_same_as_frame_by_frame(stuck, sample_rate, chunk, noise):
    frames, rng = trembling(200, seed=4), np.random.default_rng(5)
    for channel, start, length in stuck:
        stop = min(200, start + length)
        frames[start:stop, channel] = 3.0 + noise * rng.random(stop - start)
    watch, whole = quiet_health(sample_rate), quiet_health(sample_rate)
    one_by_one = [watch.step(frame.copy()) for frame in frames]
    one_by_one = [np.zeros(CHANNELS, dtype=bool) if bad is None else bad for bad in one_by_one]
    blocks = [
        whole.block(frames[i : i + chunk], frames[max(0, i - whole.memory) : i] if i else None)
        for i in range(0, 200, chunk)
    ]
    np.testing.assert_array_equal(np.concatenate(blocks), one_by_one)
