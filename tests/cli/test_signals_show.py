"""`bodydrive signals show` says what a file holds and how it is read; what it writes, every command reads."""

import json

import numpy as np
import pyarrow.parquet as pq
import pytest
from cli.answers import assert_refused, output_of

from folders import SHARED

CASES = SHARED / "data" / "cases"
T = np.arange(600) / 50


@pytest.fixture
def device(tmp_path):
    rows = "".join(
        f"{i % 256};{1e3 * t + 5000:.0f};{np.sin(t):.4f};{np.cos(t):.4f};start;0;{'n/a' if i % 6 == 0 else 1 + i % 3}\n"
        for i, t in enumerate(T)
    )
    header = "Sample Index;Time;left_elbow_1 [mV];left_elbow_2 [mV];event;Other;c\n"
    (tmp_path / "device.csv").write_text(f"# logger 1.2\n{header}{rows}")
    return tmp_path


def shown(bodydrive, *words):
    code, out, err = bodydrive("signals", "show", *words, "--json")
    assert (code, err) == (0, "")
    return json.loads(out)


def test_a_file_of_a_device_is_shown(bodydrive, device):
    found = shown(bodydrive, "device.csv")
    assert {column["name"]: column["role"] for column in found["columns"]} == {
        "Sample Index": "counter",
        "Time": "time",
        "left_elbow_1 [mV]": "channel",
        "left_elbow_2 [mV]": "channel",
        "event": "text",
        "Other": "channel",
        "c": "channel",
    }
    assert found["columns"][2]["unit"] == "mV"
    assert found["columns"][6]["missing"] == pytest.approx(1 / 6, abs=0.01)
    assert found["time"] == {"column": "Time", "unit": "ms", "stated": False}
    assert (found["rows"], found["sample_rate"], found["problem"]) == (600, 50.0, None)
    assert found["dialect"] == {"separator": ";", "decimal": ".", "encoding": "utf-8"}
    table, _, below = bodydrive("signals", "show", "device.csv")[1].partition("\n\n")
    assert [line.split()[0] for line in table.splitlines()[:3]] == ["column", "Sample", "Time"]
    assert "600 samples, 11.98 s, at 50 Hz, 4 channels." in below
    assert "The times are those of the column 'Time', in milliseconds." in below


def test_joints_are_those_of_the_layout_beside_it(bodydrive, device):
    layout = {
        "name": "arm",
        "channels": [{"name": f"left_elbow_{i}", "joint": "left_elbow"} for i in (1, 2)],
        "joints": [{"name": "left_elbow", "label": "Left elbow"}],
    }
    (device / "device.layout.json").write_text(json.dumps(layout))
    found = shown(bodydrive, "device.csv")
    assert found["channels"] == ["left_elbow_1", "left_elbow_2"]
    assert found["joints"] == {"left_elbow_1": "left_elbow", "left_elbow_2": "left_elbow"}
    assert "channels" not in found["message"]
    layout["channels"][0]["name"] = "1"
    (device / "device.layout.json").write_text(json.dumps(layout))
    assert "channels have columns of other names: 1 = left_elbow_1 [mV]" in shown(bodydrive, "device.csv")["message"]


def test_what_is_corrected_is_written_and_read_by_every_command(bodydrive, device):
    words = ("--time", "Time", "--unit", "ms", "--channels", "left_elbow_1 [mV],left_elbow_2 [mV]")
    output_of(bodydrive("signals", "show", "device.csv", *words, "--out", "signals.parquet", "--json"))
    table = pq.read_table(device / "signals.parquet")
    assert table.column_names == ["t", "left_elbow_1 [mV]", "left_elbow_2 [mV]"]
    np.testing.assert_allclose(table["t"].to_numpy(), T + 5)
    assert shown(bodydrive, "signals.parquet")["sample_rate"] == 50.0


def test_a_question_is_shown_and_nothing_is_written(bodydrive, device):
    (device / "counted.csv").write_text("time,a\n" + "".join(f"{i},{np.sin(i):.3f}\n" for i in range(300)))
    found = shown(bodydrive, "counted.csv")
    assert (found["sample_rate"], found["time"]) == (None, None)
    assert "can be seconds (1 Hz) and milliseconds (1000 Hz)" in found["problem"]
    code, out, err = bodydrive("signals", "show", "counted.csv")
    assert code == 0
    assert "column" in out
    assert "--unit" in err
    assert_refused(bodydrive("signals", "show", "counted.csv", "--out", "x.parquet"), "write the unit into its name")
    assert not (device / "x.parquet").exists()
    assert shown(bodydrive, "counted.csv", "--unit", "ms")["sample_rate"] == 1000.0


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("none.csv",), "none.csv: there is no such file"),
        (("device.csv", "--unit", "parsec"), "--unit parsec: give one of s, ms"),
        (("device.csv", "--rate", "nan"), "--rate nan: give Hz from 10 to 5000"),
        (("device.csv", "--channels", "a,,b"), "--channels a,,b"),
        (("device.csv", "--out", "x.csv"), "--out x.csv: its name must end in .parquet"),
        (("device.csv", "--layout", "none.json"), "none.json: there is no such layout"),
    ],
)
def test_bad_words_are_refused_in_one_sentence(bodydrive, device, words, sentence):
    assert_refused(bodydrive("signals", "show", *words), sentence)


def test_the_options_help_the_other_commands(bodydrive, shirt, tmp_path):
    lines = (tmp_path / "signals.csv").read_text().splitlines()
    header, rows = lines[0].replace("t,", "clock,"), [line.split(",", 1) for line in lines[1:]]
    content = "\n".join([header, *(f"{i},{row[1]}" for i, row in enumerate(rows))]) + "\n"
    (tmp_path / "counted.csv").write_text(content)
    plain = ("--layout", "layout.json", "--out", "profile.json", "--json")
    assert_refused(bodydrive("calibrate", "counted.csv", *plain), "(or say it with --time, --unit or --rate")
    assert bodydrive("calibrate", "counted.csv", *plain, "--rate", "100")[0] == 0
    decoded = bodydrive(
        "decode", "counted.csv", "--profile", "profile.json", "--out", "out.csv", "--rate", "100", "--json"
    )
    assert json.loads(decoded[1])["sample_rate"] == 100.0
    sent = bodydrive("replay", "counted.csv", "--rate", "100", "--speed", "100", "--to", "127.0.0.1:9", "--json")
    assert json.loads(sent[1])["frames"] == 1200


@pytest.mark.skipif(not CASES.is_dir(), reason="the files of other laboratories are not here")
def test_the_files_that_were_seen_are_shown(bodydrive):
    for file in sorted(CASES.glob("signals-*.csv")):
        found = shown(bodydrive, str(file))
        assert (found["sample_rate"] == 50.0) == (found["problem"] is None), file
        assert {"A", "B", "C"} <= {column["name"].partition(" [")[0][-1] for column in found["columns"]}
