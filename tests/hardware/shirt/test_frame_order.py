"""The order and the lateness of a shirt's frames."""

from hypothesis import given
from hypothesis import strategies as st

from app.hardware.shirt.frame_order import FORGIVEN, LATE, RESTART_AFTER, WRAP, Lateness, Sequence

PERIOD = 10_000  # microseconds between two frames
OFFSETS = st.integers(-(10**9), 10**9)  # s that our clock is ahead of the device's
JITTER = st.lists(st.floats(0.0, 0.9 * LATE), min_size=2, max_size=200)


def times(count, begin=0):
    return [begin + PERIOD * i for i in range(count)]


@given(st.integers(0, 2**60), OFFSETS, JITTER)
def test_a_radio_s_jitter_is_not_late(begin, offset, delays):
    lateness = Lateness()
    for i, delay in enumerate(delays):
        assert lateness.of(begin + PERIOD * i, 1e-6 * PERIOD * i + offset + delay) == 0.0


@given(OFFSETS, JITTER, st.floats(2.01 * LATE, 3600.0))
def test_frames_that_are_kept_back_are_late_for_as_long_as_they_are(offset, delays, kept):
    lateness = Lateness()
    for i, delay in enumerate(delays):
        lateness.of(PERIOD * i, 1e-6 * PERIOD * i + offset + delay)
    for i, delay in enumerate(delays, len(delays)):
        late = lateness.of(PERIOD * i, 1e-6 * PERIOD * i + offset + delay + kept)
        assert kept - LATE - 1e-3 * kept < late < kept + LATE
    in_time = 2 * len(delays)
    assert lateness.of(PERIOD * in_time, 1e-6 * PERIOD * in_time + offset) == 0.0


@given(st.floats(-1e-4, 1e-4), st.floats(-1e-4, 1e-4))
def test_ten_hours_of_clocks_that_drift_are_not_late(device, ours):
    lateness = Lateness()
    for second in range(0, 36_000, 7):
        assert lateness.of(round(1e6 * second * (1 + device)), second * (1 + ours) + 0.05 * (second % 2)) == 0.0


def test_a_delay_that_creeps_is_seen_unless_it_grows_no_quicker_than_clocks_drift():
    lateness = Lateness()
    late = [lateness.of(1_000_000 * i, i * (1 + 10 * FORGIVEN)) for i in range(1000)]
    assert late[49] == 0.0
    assert all(late[100:])


@given(st.floats(0.15, 60.0))
def test_what_a_radio_hands_on_after_a_gap_is_late_but_for_its_end(gap):
    lateness = Lateness()
    assert lateness.of(0, 5.0) == 0.0
    frames = times(int(gap * 100), PERIOD)
    late = [lateness.of(microseconds, 5.0 + gap) for microseconds in frames]
    for microseconds, found in zip(frames, late, strict=True):
        assert (found > 0.0) == (gap - 1e-6 * microseconds > LATE + FORGIVEN * gap), (microseconds, found)
    assert lateness.of(frames[-1] + PERIOD, 5.0 + 1e-6 * (frames[-1] + PERIOD)) == 0.0


@given(st.integers(1, 300), st.floats(2 * LATE, 10.0))
def test_a_counter_of_32_bits_wraps_without_an_effect(before, kept):
    lateness = Lateness()
    begin = WRAP - PERIOD * before
    for i in range(600):
        assert lateness.of((begin + PERIOD * i) % WRAP, 1e-6 * PERIOD * i) == 0.0
    for i in range(600, 600 + WRAP // PERIOD, WRAP // PERIOD // 50):  # kept back beyond the next wrap
        assert lateness.of((begin + PERIOD * i) % WRAP, 1e-6 * PERIOD * i + kept + 1.0) > 0.0


@given(st.integers(WRAP, 2**50), st.floats(2 * LATE, 3600.0))
def test_a_clock_that_is_set_back_is_late_until_the_device_begins_anew(before, back):
    lateness = Lateness()
    lateness.of(before, 1.0)
    microseconds = before - round(1e6 * back)
    assert lateness.of(microseconds, 1.01) > 0.0
    lateness.forget()
    assert lateness.of(microseconds, 1.01) == 0.0


def test_a_clock_that_stands_shows_nothing():
    lateness = Lateness()
    assert [lateness.of(7, t) for t in (0.0, 1.0, 100.0)] == [0.0] * 3


def test_another_device_is_judged_anew():
    lateness = Lateness()
    lateness.of(0, 0.0)
    assert lateness.of(PERIOD, 2.0) > 0.0
    lateness.forget()
    assert lateness.of(2 * PERIOD, 2.1) == 0.0


@given(st.integers(0, 2**32 - 1), st.lists(st.integers(1, 1000), max_size=50))
def test_gaps_are_counted_and_the_counter_may_wrap(start, steps):
    sequence = Sequence()
    seq = start
    assert sequence.accept(seq)
    for step in steps:
        seq = (seq + step) % 2**32
        assert sequence.accept(seq)
    assert sequence.lost == sum(steps) - len(steps)
    assert sequence.dropped == sequence.restarts == 0


@given(st.integers(0, 2**32 - 1), st.lists(st.integers(0, 500), min_size=1, max_size=30))
def test_late_and_repeated_frames_between_new_ones_are_dropped(start, behind):
    sequence = Sequence()
    seq = start
    sequence.accept(seq)
    for back in behind:
        seq = (seq + 1) % 2**32
        assert sequence.accept(seq)
        assert not sequence.accept((seq - back) % 2**32)
    assert sequence.dropped == len(behind)
    assert sequence.lost == sequence.restarts == 0


@given(st.integers(RESTART_AFTER + 1, 2**32 - 2**20 - 1))
def test_a_device_that_begins_anew_is_heard_again_soon(last):
    sequence = Sequence()
    sequence.accept(last)
    taken = [sequence.accept(seq) for seq in range(RESTART_AFTER + 20)]
    assert all(taken[RESTART_AFTER:])
    assert sequence.lost < RESTART_AFTER
    if last < 2**31:
        assert sequence.restarts == 1


def test_a_device_that_begins_anew_far_ahead_has_lost_nothing():
    sequence = Sequence()
    sequence.accept(5)
    assert sequence.accept(1_900_000_000)
    assert sequence.lost == 0
    assert sequence.restarts == 1
