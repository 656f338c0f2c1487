from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.signals.row_places import RowPlaces
from app.signals.sampling_times import sampling_times

FILE = Path("signals.csv")
ROWS = np.arange(2400)


def seen(t):
    return sampling_times(np.asarray(t, np.float64), RowPlaces(str(FILE)))


@given(
    sample_rate=st.sampled_from([50.0, 100.0, 300.0, 1000.0]),
    digits=st.integers(1, 4),
    count=st.integers(1200, 2000),
    start=st.floats(0, 1000),
)
def test_times_written_with_too_few_digits_are_made_even_again(sample_rate, digits, count, start):
    truth = start + np.arange(count) / sample_rate
    written = truth.round(digits)
    if len(np.unique(written)) < 4:
        return
    times = seen(written)
    assert (np.diff(times.t) > 0).all()
    assert np.abs(times.t - truth).max() <= 3 * 10.0**-digits + 2 / sample_rate


def test_gaps_between_exact_times_stay_gaps():
    t = np.concatenate([np.arange(50), np.arange(70, 120)]) / 100
    times = seen(t)
    assert (times.t.tolist(), times.sample_rate) == (t.tolist(), 100.0)
    assert "There is 1 gap" in str(times.note)


def test_samples_stamped_in_bursts_have_the_rate_of_many_bursts():
    for case in product((12.5, 50.0, 100.0, 128.0), (2, 3, 5, 20), (0.0, 0.0005), (0.0, 0.2)):
        sample_rate, size, within, late = case
        bursts = ROWS // size
        delays = np.random.default_rng(1).uniform(0, late, bursts[-1] + 1) * size / sample_rate
        times = seen((bursts + 1) * size / sample_rate + delays[bursts] + within * (ROWS % size))
        assert times.sample_rate == pytest.approx(sample_rate, rel=0.003), case
        assert np.diff(times.t) == pytest.approx(1 / times.sample_rate, rel=1e-6), case
        assert "spread evenly" in str(times.note), case


def test_a_lost_burst_stays_a_gap():
    bursts = np.delete(np.arange(400), [50, 51, 200, 333])
    t = np.repeat(bursts * 0.1, 5) + np.tile(np.arange(5) * 0.001, len(bursts))
    times = seen(t)
    assert times.sample_rate == 50.0
    assert np.sort(np.diff(times.t))[-4:] == pytest.approx([0.02, 0.12, 0.12, 0.22])


@pytest.mark.parametrize("first", [0.0, 0.37, 0.99])
@pytest.mark.parametrize("sample_rate", [20.0, 50.0, 100.0, 51.2])
def test_stamps_in_whole_seconds_have_the_rate_of_whole_seconds(first, sample_rate):
    times = seen(np.floor(first + np.arange(1000) / sample_rate))
    assert times.sample_rate == pytest.approx(sample_rate, rel=0.003)
    assert "spread evenly" in str(times.note)


def test_a_clock_that_moves_in_coarse_steps_is_read_by_the_whole_file():
    for sample_rate in (33.0, 40.0, 50.0, 66.0, 100.0):
        times = seen(np.floor(ROWS / sample_rate * 64) / 64)
        assert times.sample_rate == pytest.approx(sample_rate, rel=0.002)


def test_a_clock_that_stands_still_now_and_then_is_read_by_the_whole_file():
    t = ROWS / 100
    t[ROWS % 60 >= 50] = (50 + 60 * (ROWS // 60))[ROWS % 60 >= 50] / 100  # ten samples with one time, in every sixty
    times = seen(t)
    assert times.sample_rate == pytest.approx(100.0, rel=1e-3)
    assert np.abs(times.t - ROWS / 100).max() < 0.1


@pytest.mark.parametrize("loss", [0.01, 0.05, 0.2])
def test_lost_samples_leave_the_rate(loss):
    kept = np.random.default_rng(2).random(len(ROWS)) >= loss
    times = seen(ROWS[kept] / 50)
    assert times.sample_rate == 50.0
    assert times.t.tolist() == (ROWS[kept] / 50).tolist()


def test_a_hole_of_seconds_is_noted_with_its_place():
    t = ROWS / 50
    t[1200:] += 5
    assert str(seen(t).note) == "There is 1 gap between the samples, of 5.02 s, before signals.csv, line 1202."


def test_a_row_written_twice_leaves_the_rate():
    times = seen(np.insert(np.arange(300) / 50, 77, 77 / 50))
    assert times.sample_rate == 50.0
    assert "1 of 301 samples has the time of the sample before" in str(times.note)


@pytest.mark.parametrize("sample_rate", [10.0, 50.0, 128.0, 1000.0])
@pytest.mark.parametrize(
    ("unit", "seconds", "start"),
    [
        ("milliseconds", 1e-3, 0.0),
        ("milliseconds", 1e-3, 1.7e9),
        ("microseconds", 1e-6, 1.7e9),
        ("nanoseconds", 1e-9, 0.0),
        ("nanoseconds", 1e-9, 1.706e9),
        ("minutes", 60.0, 0.0),
        ("hours", 3600.0, 12.0),
        ("days", 86400.0, 0.0),
    ],
)
def test_another_unit_than_seconds_is_named_with_its_remedy(unit, seconds, start, sample_rate):
    with pytest.raises(ValueError, match="must be in seconds") as refusal:
        seen((start + ROWS / sample_rate) / seconds)
    if unit == "milliseconds" and sample_rate == 1000.0 and start == 0.0:
        unit = "a counter of samples"
    assert unit in str(refusal.value)
    assert "the column t by" in str(refusal.value)


@pytest.mark.parametrize("sample_rate", [500.0, 600.0, 1000.0, 1024.0, 2000.0, 3000.0, 5000.0])
def test_fast_recordings_of_seconds_are_not_taken_for_minutes(sample_rate):
    count = int(sample_rate * (2.0 if sample_rate in (1000.0, 1024.0, 2000.0, 5000.0) else 25.0))
    assert seen(np.arange(count) / sample_rate).sample_rate == pytest.approx(sample_rate)


@pytest.mark.parametrize(
    ("t", "words"),
    [
        (np.where(ROWS < 1200, ROWS / 50, ROWS / 50 + 200_000), r"line 1202: t jumps there by 200000 s \(55.6 hours\)"),
        (np.where(ROWS < 1200, ROWS / 50, ROWS / 50 - 1), "line 1202: time runs backwards"),
        (np.cumsum(np.random.default_rng(3).exponential(0.02, 2400)), "so that the sample rate is unknown"),
        (np.cumsum(np.random.default_rng(3).uniform(0.006, 0.034, 2400)), "without an even sample rate"),
        (np.cumsum(np.where(ROWS < 1200, 0.01, 0.02)), "without an even sample rate"),
        (np.cumsum(np.where(ROWS < 2200, 0.01, 0.02)), "line 2201: the sample rate changes there"),
        (np.repeat([0.0, 1.0], 50), "so that the sample rate is unknown"),
        (ROWS / 8, "samples taken too slowly"),
        (ROWS * 1e300, "give the time in seconds"),
        (ROWS * 5e-324, "t is 0 in every row"),
        (np.where(ROWS < 1200, -1.7e308, 1.7e308), "give the time in seconds"),
    ],
)
def test_times_without_one_even_rate_are_refused_in_one_sentence(t, words):
    with pytest.raises(ValueError, match=words) as refusal:
        seen(t)
    assert str(refusal.value).startswith(str(FILE))


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=10, max_size=40), st.booleans())
def test_any_column_is_times_or_one_sentence(numbers, are_sorted):
    try:
        times = seen(sorted(numbers) if are_sorted else numbers)
    except ValueError:
        return
    assert (np.diff(times.t) > 0).all()
    assert 10.0 <= times.sample_rate <= 5000.0
