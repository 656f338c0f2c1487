"""The time of a file: its column, its unit, and what is asked about; times of day and dates."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.signals.clock_times import seconds_of_moments
from app.signals.file_table import FileTable
from app.signals.row_places import RowPlaces
from app.signals.signals import ReadingOptions, read_signals
from app.signals.time_columns import possible_units, sentence_of_time, time_of_table
from app.signals.time_names import SECONDS, time_names

ROWS = np.arange(400)
SIGNAL = np.sin(ROWS / 30)


def table(columns, units=None):
    return FileTable(
        {name: np.asarray(values, np.float64) for name, values in columns.items()}, units or {}, RowPlaces("f")
    )


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        *(("Time (s)", "s"), ("time_ms", "ms"), ("Timestamp [us]", "us"), ("t/ms", "ms"), ("Zeit in ms", "ms")),
        *(("timestamp_ns", "ns"), ("millis", "ms"), ("seconds_elapsed", "s"), ("Tiempo (s)", "s"), ("TIME [µs]", "us")),
        *(("time (min)", "min"), ("elapsedMicroseconds", "us"), ("Time, s", "s"), ("t_s", "s"), ("UTC_Nano", "ns")),
    ],
)
@given(sample_rate=st.sampled_from([10.0, 50.0, 128.0, 1000.0]), start=st.sampled_from([0.0, 12.5, 1.7e9]))
def test_a_stated_unit_is_that_of_the_time(name, unit, sample_rate, start):
    truth = start + ROWS / sample_rate
    time = time_of_table(table({"a": SIGNAL, name: truth / SECONDS[unit]}))
    assert (time.column, time.unit, time.is_stated) == (name, unit, True)
    np.testing.assert_allclose(time.t, truth, atol=1e-6)


def test_a_unit_in_a_row_of_its_own_is_stated_too():
    time = time_of_table(table({"time": ROWS * 2e7, "a": SIGNAL}, {"time": "ns", "a": "mV"}))
    np.testing.assert_allclose(time.t, ROWS / 50)


@pytest.mark.parametrize("name", ["t", "time", "Timestamp"])
@pytest.mark.parametrize("unit", ["s", "ms", "us", "ns"])
@pytest.mark.parametrize("sample_rate", [20.0, 100.0, 1000.0])
def test_a_clock_that_counts_from_1970_has_one_unit(name, unit, sample_rate):
    time = time_of_table(table({name: (1_706_282_470 + ROWS / sample_rate) / SECONDS[unit], "a": SIGNAL}))
    assert time.unit == unit
    assert np.diff(time.t).mean() == pytest.approx(1 / sample_rate, rel=1e-4)


@pytest.mark.parametrize(("unit", "step"), [("s", 0.02), ("ms", 20.0), ("us", 20_000.0), ("ns", 2e7), ("s", 0.0002)])
def test_where_one_unit_is_possible_it_is_found_and_said(unit, step):
    time = time_of_table(table({"time": ROWS * step, "a": SIGNAL}))
    assert (time.unit, time.is_stated) == (unit, False)
    assert "The times are those of the column 'time'" in str(sentence_of_time(time))


@pytest.mark.parametrize(("step", "units"), [(1.0, ["s", "ms"]), (0.5, ["s", "ms"]), (500.0, ["ms", "us"])])
def test_where_two_units_are_possible_a_person_is_asked(step, units):
    assert possible_units(ROWS * step) == units
    with pytest.raises(ValueError, match="write the unit into its name") as question:
        time_of_table(table({"time": ROWS * step, "a": SIGNAL}))
    assert "\n" not in str(question.value)
    assert time_of_table(table({"time": ROWS * step, "a": SIGNAL}), unit=units[1]).unit == units[1]


def test_our_own_t_is_in_seconds_and_nothing_is_said_of_it():
    time = time_of_table(table({"t": ROWS * 20.0, "a": SIGNAL}))
    assert (time.unit, sentence_of_time(time)) == ("s", None)


@pytest.mark.parametrize(
    ("names", "chosen"),
    [
        (["time", "t", "a"], ["t"]),
        (["Sample Index", "EXG 0", "Timestamp"], ["Timestamp"]),
        (["PacketCounter", "SampleTimeFine", "Acc_X"], ["SampleTimeFine"]),
        (["seconds_elapsed", "time", "x"], ["time", "seconds_elapsed"]),
        (["time of flight", "frame rate", "force"], []),
    ],
)
def test_times_are_known_by_their_names(names, chosen):
    assert time_names(names) == chosen


def test_of_several_times_the_first_one_with_a_unit_counts_and_none_is_a_channel(tmp_path):
    file = tmp_path / "signals.csv"
    rows = "".join(f"{i % 256},{i * 500},{i / 50:.2f},{np.sin(i):.3f}\n" for i in range(300))
    file.write_text(f"Sample Index,time,seconds_elapsed,EXG 0\n{rows}")
    signals = read_signals(file)
    assert (signals.channel_names, signals.sample_rate) == (["EXG 0"], 50.0)


@pytest.mark.parametrize(
    ("first", "written"),
    [
        (1_706_282_470.0, lambda k: f"2024-01-26T15:21:{10 + k // 50:02}.{20 * (k % 50):03}Z"),
        (1_706_282_470.0, lambda k: f"2024-01-26 16:21:{10 + k // 50:02},{20 * (k % 50):03}+01:00"),
        (1_706_282_470.0, lambda k: f"26.01.2024 15:21:{10 + k // 50:02}.{20 * (k % 50):03}"),
        (1_706_282_470.0, lambda k: f"01/26/2024 03:21:{10 + k // 50:02}.{20 * (k % 50):03} PM"),
        (1_706_282_470.0, lambda k: f"26/01/2024 15:21:{10 + k // 50:02}.{20 * (k % 50):03}"),
        (1_706_282_470.0, lambda k: f"26-Jan-2024 15:21:{10 + k // 50:02}.{20 * (k % 50):03}"),
        (1_706_282_470.0, lambda k: f"2024.01.26 15:21:{10 + k // 50:02}.{20 * (k % 50):03}"),
        (55_270.0, lambda k: f"15:21:{10 + k // 50:02}.{20 * (k % 50):03}"),
        (55_270.0, lambda k: f"15:21:{10 + k // 50:02}:{20 * (k % 50):03}"),
        (70.0, lambda k: f"01:{10 + k // 50:02}.{20 * (k % 50):03}"),
    ],
)
def test_moments_are_read_in_seconds(tmp_path, first, written):
    t = seconds_of_moments([written(k) for k in range(400)])
    np.testing.assert_allclose(t, first + ROWS / 50, atol=1e-6)
    file = tmp_path / "signals.csv"
    file.write_text("Zeit;A\n" + "".join(f"{written(k)};{np.sin(k):.3f}\n" for k in range(400)))
    assert read_signals(file).sample_rate == pytest.approx(50.0, abs=1e-3)


def test_a_recording_over_midnight_goes_on():
    cells = [f"23:59:{50 + k}.0" for k in range(10)] + [f"00:00:{k:02}.0" for k in range(10)]
    np.testing.assert_allclose(np.diff(seconds_of_moments(cells)), 1.0)


@given(st.lists(st.text(max_size=30), max_size=20))
def test_what_is_no_moment_is_missing(cells):
    assert len(seconds_of_moments(cells)) == len(cells)


@pytest.fixture
def file(tmp_path):
    content = "".join(f"{i * 10},{np.sin(i):.3f},{np.cos(i):.3f}\n" for i in range(300))
    (tmp_path / "signals.csv").write_text(f"clock,x,y\n{content}")
    return tmp_path / "signals.csv"


def test_a_person_corrects_what_a_file_says(file):
    signals = read_signals(file, options=ReadingOptions(time="clock", unit="ms", channels=("y",)))
    assert (signals.channel_names, signals.sample_rate) == (["y"], 100.0)
    assert "in milliseconds" in str(signals.damage)
    signals = read_signals(file, options=ReadingOptions(rate=100.0))
    assert signals.t[:2].tolist() == [0.0, 0.01]
    assert "count as even, at 100 Hz" in str(signals.damage)


def test_a_wrong_correction_is_refused(file):
    with pytest.raises(ValueError, match="by the column 'clock' it is 100 Hz"):
        read_signals(file, options=ReadingOptions(rate=50.0))
    with pytest.raises(ValueError, match="no column 'z'"):
        read_signals(file, options=ReadingOptions(channels=("z",)))
    with pytest.raises(ValueError, match="no column 'z'"):
        read_signals(file, options=ReadingOptions(time="z"))


def test_without_any_time_a_rate_is_enough(tmp_path):
    file = tmp_path / "signals.csv"
    file.write_text("a,b\n" + "".join(f"{np.sin(i):.3f},{np.cos(i):.3f}\n" for i in range(300)))
    with pytest.raises(ValueError, match="no column 't' and no other one of times"):
        read_signals(file)
    assert read_signals(file, options=ReadingOptions(rate=250.0)).t[-1] == pytest.approx(299 / 250)
