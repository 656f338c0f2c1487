"""Samples of several streams become rows: joined by their times, or on a grid; nothing is computed between two."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.shirt.stream_join import (
    LONGEST_LAG,
    MOST_WAITING,
    PATIENCE,
    EvenTimes,
    GridRows,
    LedRows,
    StreamSample,
    StreamSamples,
)
from app.messages import FRESH_PERIODS

PERIOD = 0.01  # s


def stream(rate=100.0, channels=1, *, is_regular=True):
    return StreamSamples(channels, rate, is_regular=is_regular)


def put(one, t, *values, arrived=None):
    one.add(StreamSample(t, values, t if arrived is None else arrived))


def all_rows(rows, now):
    found = []
    while (row := rows.next(now)) is not None:
        found.append(row)
    return found


def even(times, period=PERIOD):
    """Return the steps and the even times of samples with these time stamps."""
    clock = EvenTimes(period)
    steps = [clock.step(t) for t in times]
    return steps, clock.t


def test_exact_time_stamps_stay_as_they_are():
    clock = EvenTimes(PERIOD)
    for i in range(1000):
        assert clock.step(7.0 + i * PERIOD) == 1
        assert clock.t == pytest.approx(7.0 + i * PERIOD, abs=1e-9)


@pytest.mark.parametrize("missing", [1, 2, 5, 300])
def test_a_gap_is_counted_in_whole_periods(missing):
    times = [i * PERIOD for i in range(50)] + [(50 + missing + i) * PERIOD for i in range(50)]
    steps, last = even(times)
    assert sum(steps) - len(times) == missing
    assert steps[50] == 1 + missing
    assert last == pytest.approx(times[-1], abs=1e-6)


def test_jitter_below_half_a_period_is_no_gap():
    dice = np.random.default_rng(1)
    times = np.arange(5000) * PERIOD + dice.uniform(-0.24, 0.24, 5000) * PERIOD
    steps, last = even(times)
    assert set(steps) == {1}
    assert abs(last - times[-1]) < PERIOD


@pytest.mark.parametrize("burst", [2, 5, 10])
def test_samples_that_get_one_time_together_are_no_gaps(burst):
    steps, _ = even([i // burst * burst * PERIOD for i in range(5000)])
    assert set(steps) == {1}


@pytest.mark.parametrize("rate", [95.0, 99.9, 100.1, 105.0])
def test_a_clock_that_runs_otherwise_is_followed(rate):
    times = [i / rate for i in range(20_000)]
    steps, last = even(times)
    assert set(steps) == {1}
    assert abs(last - times[-1]) < LONGEST_LAG / 2


def test_a_step_of_the_clock_is_no_loss():
    steps, last = even([100.0, 100.01, 3.0, 3.01, 3.02])
    assert steps == [1] * 5
    assert last == pytest.approx(3.02)
    assert even([0.0, 1e9])[0] == [1, 1]


@given(st.lists(st.floats(-1e6, 1e6, allow_nan=False), min_size=1, max_size=40))
def test_no_time_stamps_give_a_step_below_one_or_a_time_that_is_no_number(times):
    clock = EvenTimes(PERIOD)
    for t in times:
        assert clock.step(t) >= 1
        assert math.isfinite(clock.t)


def test_each_sample_of_a_single_stream_is_a_row():
    one = stream(channels=2)
    rows = LedRows([one], 0)
    assert rows.next(0.0) is None
    assert rows.wait(0.0) == (0, math.inf)
    for i in range(5):
        put(one, 1.0 + i * PERIOD, i, -i)
    found = all_rows(rows, 1.1)
    assert [row.seq for row in found] == [0, 1, 2, 3, 4]
    np.testing.assert_array_equal([row.values for row in found], [[i, -i] for i in range(5)])
    assert found[0].values.dtype == np.float32
    put(one, 1.0 + 9 * PERIOD, 9, -9)
    assert rows.next(1.1).seq == 9
    assert rows.lost == 4


def test_streams_that_are_sampled_together_are_joined_also_when_one_arrives_later():
    fast, slow = stream(100.0), stream(50.0)
    rows = LedRows([fast, slow], 0)
    put(fast, 0.0, 0)
    put(slow, 0.0, 100)
    assert rows.next(0.0).values.tolist() == [0, 100]
    put(fast, 0.01, 1)
    assert rows.next(0.01).values.tolist() == [1, 100]
    put(fast, 0.02, 2)
    assert rows.next(0.02) is None, "the slow stream's sample of this time is still to come"
    awaited, wait = rows.wait(0.02)
    assert awaited == 1
    assert wait == pytest.approx(PATIENCE)
    put(slow, 0.0201, 102, arrived=0.03)
    assert rows.wait(0.03) == (None, 0.0)
    assert rows.next(0.03).values.tolist() == [2, 102]


def test_a_row_waits_no_longer_than_its_patience_and_a_silent_stream_is_nan_after_three_periods():
    lead, other = stream(), stream()
    rows = LedRows([lead, other], 0)
    put(lead, 0.0, 0)
    put(other, 0.0, 50)
    assert rows.next(0.0).values.tolist() == [0, 50]
    found = []
    for i in range(1, 8):
        put(lead, i * PERIOD, i)
    assert rows.next(PERIOD) is None
    found = all_rows(rows, PERIOD + PATIENCE) + all_rows(rows, 1.0)
    assert [row.values[0] for row in found] == [1, 2, 3, 4, 5, 6, 7]
    silent = [bool(np.isnan(row.values[1])) for row in found]
    assert silent == [False] * int(FRESH_PERIODS) + [True] * 4
    put(lead, 8 * PERIOD, 8)
    assert rows.next(8 * PERIOD) is None
    put(lead, 9 * PERIOD, 9, arrived=1.0)
    assert len(all_rows(rows, 1.0)) == 2, "nobody waits for a stream that is silent"
    put(other, 10 * PERIOD, 60, arrived=1.1)
    put(lead, 10 * PERIOD, 10, arrived=1.1)
    assert rows.next(1.1).values.tolist() == [10, 60]


@pytest.mark.parametrize("first", [0, 1])
def test_samples_that_come_many_at_once_are_joined_whichever_stream_comes_first(first):
    streams = [stream(), stream()]
    rows = LedRows(streams, 0)
    found = []
    for begin in range(0, 96, 32):
        for place, number in enumerate((first, 1 - first)):
            arrived = (begin + 32) * PERIOD + place * PATIENCE / 2
            for i in range(begin, begin + 32):
                put(streams[number], i * PERIOD, 100 * number + i, arrived=arrived)
            found += all_rows(rows, arrived)
    assert [row.values.tolist() for row in found] == [[i, 100 + i] for i in range(96)]


def test_a_time_that_is_far_ahead_is_another_clock_and_no_loss():
    times = EvenTimes(1e-3)
    assert [times.step(t) for t in (0.0, 0.002, 1e12, 1e12 + 0.001, 0.003, 1e308)] == [1, 2, 1, 1, 1, 1]


def test_a_stream_without_a_rate_is_not_waited_for():
    lead, other = stream(), stream(30.0, is_regular=False)
    rows = LedRows([lead, other], 0)
    put(other, 0.0, 5)
    for i in range(12):
        put(lead, i * PERIOD, i)
    found = all_rows(rows, 0.0)
    assert len(found) == 12
    assert [row.values[1] for row in found[:11]] == [5] * 11  # three periods of the expected rate are 0.1 s
    assert np.isnan(found[11].values[1])


def test_no_value_is_made_up_between_two_samples():
    lead, other = stream(100.0), stream(70.0)
    rows = LedRows([lead, other], 0)
    for i in range(100):
        put(lead, i / 100.0, i)
    for i in range(70):
        put(other, i / 70.0, 1000 + i)
    found = all_rows(rows, 2.0)
    for i, row in enumerate(found):
        sample = int(row.values[1]) - 1000
        assert row.values[1] == 1000 + sample
        assert -1.0 / 70.0 < sample / 70.0 - i / 100.0 <= PERIOD / 2


def test_a_leader_that_is_silent_makes_no_rows_and_the_others_fill_no_memory():
    lead, other = stream(), stream()
    rows = LedRows([lead, other], 0)
    for i in range(3 * MOST_WAITING):
        put(other, i * PERIOD, i)
    assert rows.next(1e6) is None
    assert len(other.waiting) == MOST_WAITING


def test_another_clock_begins_anew():
    lead, other = stream(), stream()
    rows = LedRows([lead, other], 0)
    put(other, 1e6, 1)
    put(lead, 1.0, 2)
    put(other, 1.0, 3)
    assert rows.next(1.0).values.tolist() == [2, 3]


def test_streams_without_a_rate_come_on_a_grid_by_their_newest_samples():
    one, two = stream(50.0, is_regular=False), stream(50.0, is_regular=False)
    rows = GridRows([one, two], 50.0)
    assert rows.next(10.0) is None
    put(one, 10.0, 1)
    found = all_rows(rows, 10.0)
    assert [row.seq for row in found] == [0]
    assert found[0].values[0] == 1
    assert np.isnan(found[0].values[1])
    assert rows.wait(10.0) == (None, pytest.approx(0.02))
    put(two, 10.003, 7)
    put(two, 10.017, 8)
    put(one, 10.025, 2)
    (row,) = all_rows(rows, 10.021)
    assert (row.seq, row.t, row.values.tolist()) == (1, pytest.approx(10.02), [1, 8])


def test_on_a_grid_a_channel_without_a_sample_for_three_periods_is_nan_and_silence_makes_no_row():
    one, two = stream(50.0, is_regular=False), stream(50.0, is_regular=False)
    rows = GridRows([one, two], 50.0)
    put(one, 0.0, 1)
    put(two, 0.0, 2)
    for i in range(1, 6):
        put(two, i * 0.02, 2 + i)
    found = all_rows(rows, 0.1)
    assert [bool(np.isnan(row.values[0])) for row in found] == [False] * 4 + [True] * 2
    assert [row.values[1] for row in found] == [2, 3, 4, 5, 6, 7]
    assert len(all_rows(rows, 0.5)) == 3
    assert rows.lost == 17
    put(one, 0.51, 9)
    (row,) = all_rows(rows, 0.521)
    assert (row.seq, row.values[0]) == (26, 9)


def test_after_a_long_hold_up_the_grid_goes_on_in_the_present():
    one = stream(50.0, is_regular=False)
    rows = GridRows([one], 50.0)
    put(one, 0.0, 1)
    assert rows.next(0.0).seq == 0
    for i in range(1, 1001):
        put(one, i * 0.02, i)
    found = all_rows(rows, 20.0)
    assert [row.t for row in (found[0], found[-1])] == pytest.approx([19.0, 20.0], abs=0.021)
    assert rows.lost == 1000 - len(found)


@given(
    arrivals=st.lists(st.tuples(st.floats(0.0, 3.0), st.floats(0.0, 0.1)), max_size=60),
    step=st.floats(0.001, 0.3),
)
def test_rows_of_a_grid_are_even_in_order_and_hold_only_samples_that_had_come(arrivals, step):
    one = stream(50.0, is_regular=False)
    rows = GridRows([one], 50.0)
    waiting = sorted(((t + late, t) for t, late in arrivals), reverse=True)
    now, found = 0.0, []
    while now < 4.0:
        while waiting and waiting[-1][0] <= now:
            arrived, t = waiting.pop()
            put(one, t, t, arrived=arrived)
        found += all_rows(rows, now)
        now += step
    assert all(later.seq > earlier.seq for earlier, later in pairwise(found))
    for row in found:
        assert row.t - FRESH_PERIODS * 0.02 - LONGEST_LAG <= row.values[0] <= row.t + 1e-5
