"""Signals from CSV, Parquet and recordings: every dialect reads equal, and what is refused is named."""

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from app.layout import Channel, Joint, ShirtLayout
from app.recording.reader import RunRecording
from app.signals.signals import read_layout, read_signals, signals_of_run

ROWS = "".join(f"{i * 0.01:.2f},{i},{-i}\n" for i in range(20))
LAYOUT = ShirtLayout(
    name="two",
    channels=(Channel(name="b", joint="j"), Channel(name="a", joint="j")),
    joints=(Joint(name="j", label="J"),),
)


@pytest.fixture
def write(tmp_path):
    def writer(content, name="signals.csv"):
        file = tmp_path / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    return writer


@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_csv_is_read(write, mark):
    signals = read_signals(write(f"{mark}t,a,b\n{ROWS}"))
    assert signals.channel_names == ["a", "b"]
    assert signals.sample_rate == 100.0
    assert signals.t == pytest.approx(np.arange(20) * 0.01)
    assert signals.values[:, 1] == pytest.approx(-np.arange(20.0))


def test_a_layout_says_which_channels_and_in_which_order(write):
    rows = ROWS.replace("\n", ",some words\n")
    signals = read_signals(write(f"t,a,b,remark\n{rows}"), LAYOUT)
    assert signals.channel_names == ["b", "a"]
    assert signals.values[5].tolist() == [-5.0, 5.0]


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int16])
def test_parquet_is_read(tmp_path, dtype):
    file = tmp_path / "signals.parquet"
    pq.write_table(pa.table({"t": np.arange(20) / 50, "a": np.arange(20).astype(dtype), "b": np.ones(20, dtype)}), file)
    signals = read_signals(file, LAYOUT)
    assert signals.sample_rate == 50.0
    assert signals.values.dtype == (np.float32 if dtype == np.float32 else np.float64)
    assert signals.values[:, 1].tolist() == list(range(20))


def test_missing_numbers_are_nan_in_channels(write):
    signals = read_signals(write(f"t,a,b\n{ROWS}0.20,,NaN\n0.21,inf,1\n"))
    assert np.isnan(signals.values[20]).all()
    assert np.isnan(signals.values[21, 0])
    assert signals.values[21, 1] == 1.0


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("", "this file is empty"),
        ("t,a,b\n", "no row below the header"),
        ("weight,a,b\n" + "".join(f"{7 - i},1,1\n" for i in range(20)), "no column 't' and no other one of times"),
        ("t\n" + "".join(f"{i}\n" for i in range(20)), "no channel beside 't'"),
        ("t,a,b\n" + ROWS + "0.20,1,x\n", "line 22, column 'b': 'x' is not a number"),
        ("t,a,b\n" + ROWS + "0.20,1\n0.21,1,1\n", "line 22: 2 cells where the header has 3"),
        ("t,a,b\n" + ROWS + "0.05,1,1\n", "line 22: time runs backwards"),
        ("t,a,b\n" + ROWS + ",1,1\n", "line 22: 't' has no number"),
        ("t,a,b\n" + ROWS + "nan,1,1\n", "line 22: 't' has no number"),
        ("t,a,b\n" + "0,1,1\n" * 20, "t is 0 in every row"),
        ("t,a,b\n0,1,1\n0.1,1,1\n", "2 samples are too few"),
        ("t,a,b\n" + "".join(f"{10 * i},1,1\n" for i in range(20)), "must be in seconds"),
        ("t\ta\tb\n0\t1\t1\n", "1 sample is too few"),
        ("t,a,a\n0,1,1\n0.1,2,1\n", "two columns 'a'"),
        ("t,,a\n0,1,1\n", "column 2 has no name"),
        (b"\x89PNG\r\n\x1a\n\x00\x00\xff\xfe", "not a CSV file but something binary"),
        (b"t,a,b\n" + ROWS.encode() + b"0.20,\xff\x01\xfe,1\n", "not a CSV file but something binary"),
        ("Dear Sir,\nI have no signals.\n", "no table of numbers"),
    ],
)
def test_a_bad_file_is_refused_in_one_sentence_that_names_it(write, content, words):
    file = write(content)
    with pytest.raises(ValueError, match=words) as refusal:
        read_signals(file)
    assert str(refusal.value).startswith(str(file))
    assert "\n" not in str(refusal.value)


def test_channels_that_the_layout_wants_must_be_there(write):
    with pytest.raises(ValueError, match="channel b of the layout 'two' is not in this recording"):
        read_signals(write("t,a\n" + "".join(f"{i / 100},1\n" for i in range(20))), LAYOUT)
    with pytest.raises(ValueError, match="none of the columns a, b, t is there"):
        read_signals(write("x,y\n1,2\n"), LAYOUT)


def recorded_run(**changes):
    """A run of 2 s at 100 Hz; every fifth turn of the loop came without a frame."""
    rows = 250
    has_frame = np.arange(rows) % 5 != 4
    run_t = np.arange(rows) * 0.008
    columns = {
        "t": 5000 + run_t,
        "run_t": run_t,
        "t_device": np.cumsum(has_frame) * 0.01,
        "has_frame": has_frame.astype(np.uint8),
        "values": np.where(has_frame[:, np.newaxis], np.cumsum(has_frame)[:, np.newaxis] * [1, -1], np.nan).astype(
            "f4"
        ),
    }
    return RunRecording(
        {"layout": LAYOUT.model_dump(mode="json"), "sample_rate": 100.0, **changes}, columns, 0, "It was cut."
    )


def test_a_recorded_run_gives_its_frames(tmp_path):
    swapped = ShirtLayout(name="swapped", channels=LAYOUT.channels[::-1], joints=LAYOUT.joints)
    signals = signals_of_run(recorded_run(), tmp_path)
    assert (signals.channel_names, signals.sample_rate, len(signals.t)) == (["b", "a"], 100.0, 200)
    assert signals.values[:, 0].tolist() == list(range(1, 201))
    assert signals.t_device == pytest.approx(np.arange(1, 201) * 0.01)
    assert signals.t[0] == 0.0
    assert signals_of_run(recorded_run(), tmp_path, swapped).values[:, 1].tolist() == list(range(1, 201))


def test_a_run_that_does_not_fit_is_refused(tmp_path):
    other = ShirtLayout(name="other", channels=(Channel(name="c", joint="j"),), joints=LAYOUT.joints)
    with pytest.raises(ValueError, match="channel c of the layout 'other'"):
        signals_of_run(recorded_run(), tmp_path, other)
    with pytest.raises(ValueError, match=r"does not say which shirt it is of\. It was cut\."):
        signals_of_run(recorded_run(layout=None), tmp_path)
    with pytest.raises(ValueError, match="channels: this is missing"):
        signals_of_run(recorded_run(layout={"name": "x", "joints": []}), tmp_path)
    short = recorded_run()
    short.columns["has_frame"][5:] = 0
    with pytest.raises(ValueError, match="4 frames are too few"):
        signals_of_run(short, tmp_path)
    with pytest.raises(ValueError, match="there is no recording in this folder"):
        read_signals(tmp_path)


def test_what_is_no_file_of_signals_is_refused(tmp_path, write):
    with pytest.raises(ValueError, match="no such file"):
        read_signals(tmp_path / "nothing.csv")
    with pytest.raises(ValueError, match="not a Parquet file"):
        read_signals(write("t,a\n0,1\n", "signals.parquet"))
    with pytest.raises(ValueError, match="more than a shirt can have"):
        read_signals(write("t," + ",".join(f"c{i}" for i in range(65)) + "\n" + ("0" + ",1" * 65 + "\n") * 20))


def test_text_in_parquet_is_named(tmp_path):
    file = tmp_path / "signals.parquet"
    pq.write_table(pa.table({"t": np.arange(20) / 50, "a": ["x"] * 20}), file)
    with pytest.raises(ValueError, match="column 'a' holds string and not numbers"):
        read_signals(file)


def test_a_stretch_is_found_by_its_times(write):
    signals = read_signals(write(f"t,a,b\n{ROWS}"))
    assert signals.between(None, None) == slice(0, 20)
    assert signals.between(0.05, 0.1) == slice(5, 10)
    assert signals.between(7.0, None) == slice(20, 20)


def test_a_layout_is_read(write):
    assert read_layout(write(LAYOUT.model_dump_json(), "layout.json")) == LAYOUT


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("{", "this is not JSON"),
        ('{"name": "x"}', "channels: this is missing, add it"),
        (
            '{"name": "x", "channels": [{"name": "a", "joint": "k"}], "joints": [{"name": "j", "label": "J"}]}',
            "joint 'k'",
        ),
        (
            '{"name": "x", "joints": [{"name": "j", "label": "J"}], '
            '"channels": [{"name": "a", "joint": "j", "hue": 1}]}',
            r"channels\[0\].hue: this is not known here",
        ),
    ],
)
def test_a_bad_layout_is_refused_in_one_sentence(write, content, words):
    file = write(content, "layout.json")
    with pytest.raises(ValueError, match=words) as refusal:
        read_layout(file)
    assert str(refusal.value).startswith(str(file))
    assert "\n" not in str(refusal.value)


def test_a_missing_layout_is_refused(tmp_path):
    with pytest.raises(ValueError, match="there is no such layout"):
        read_layout(tmp_path / "layout.json")
