"""Bad input gives one sentence on stderr and exit code 2; unusual input is read; no output is half-written."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet
import pytest
from cli.answers import assert_refused, output_of
from cli.conftest import write_table

from app.cli.study import study_runs
from app.texts import from_document
from building import make_profile

CALIBRATE = ("calibrate", "signals.csv", "--layout", "layout.json", "--out", "profile.json")


def refused(answer, words):
    assert_refused(answer, words)
    assert answer[2].startswith("bodydrive: ")
    assert answer[2].rstrip("\n").isprintable()


def parsed(answer):
    """Return the JSON object on stdout, which must not hold NaN or infinity."""
    out = output_of(answer)
    assert out.count("\n") == 1
    return json.loads(out, parse_constant=pytest.fail)


def test_every_json_is_one_object(bodydrive, shirt, tmp_path):
    (tmp_path / "trial.csv").write_text("t,x,y\n0,0,0\n1,1,0\n2,3,0\n")
    (tmp_path / "path.csv").write_text("x,y\n0,0\n3,0\n")
    wall, row = b"\0" * 100, b"\0" + b"\xfe" * 98 + b"\0"
    (tmp_path / "hall.pgm").write_bytes(b"P5 100 60 255\n" + wall + row * 58 + wall)
    (tmp_path / "hall.yaml").write_text("image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n")
    for words, key in (
        ((*CALIBRATE, "--prompts", "prompts.csv"), "joints"),
        (("decode", "signals.csv", "--profile", "profile.json", "--out", "commands.csv"), "frames"),
        (("score", "trial.csv", "path.csv"), "e_diff"),
        (("floorplan", "import", "hall.yaml", "--out", "hall.json"), "walls"),
        (("floorplan", "list"), "floorplans"),
        (("study", "--trials=1", "--path=corridor", "--jobs=1", "--format=none", "--out=new"), "learning"),
        (("replay", "signals.csv", "--speed", "100", "--to", "127.0.0.1:9"), "frames"),
    ):
        assert key in parsed(bodydrive(*words, "--json")), words[0]


def test_the_installed_command_says_no_with_code_2(tmp_path):
    command = Path(sys.executable).with_name("bodydrive")
    if not command.exists():
        pytest.skip("bodydrive is not installed beside this Python")
    ended = subprocess.run(
        [command, "score", "none.csv", "path.csv"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr == "bodydrive: none.csv: there is no such file, check its name\n"


def test_without_a_word_the_help_is_shown(bodydrive):
    for words in ((), ("floorplan",)):
        out = output_of(bodydrive(*words))
        assert "Usage: bodydrive" in out


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"t,right_elbow_0\r0,1\r", "its lines end in carriage returns alone"),
        (b't,"right\rleft"\n', "its lines end in carriage returns alone"),
        (b"t,right_elbow_0", "no row below the header"),
        ("t,a\n0,1\n".encode("utf-16"), "channel right_elbow_0, right_elbow_1"),
        (b"a" * 50_000 + b"\n1\n", "only aaaaaaaaaaaaaaaaaaaaaaaaaaaaaa..., add them"),
        ("t,right_elbow_0\n0,\u0663\n".encode(), "'\u0663' is not a number"),
        (b"t,right_elbow_0\n0,a\x1b[31m\n", "'a [31m' is not a number"),
    ],
)
def test_odd_tables_are_refused(bodydrive, shirt, tmp_path, content, words):
    (tmp_path / "signals.csv").write_bytes(content)
    refused(bodydrive(*CALIBRATE), words)
    assert not (tmp_path / "profile.json").exists()


def test_two_columns_of_one_name_in_parquet(bodydrive, shirt, tmp_path):
    table = pa.Table.from_arrays([pa.array(shirt[:, 0]), *[pa.array(shirt[:, 1])] * 2], names=["t", "a_1", "a_1"])
    pyarrow.parquet.write_table(table, tmp_path / "signals.parquet")
    refused(bodydrive("calibrate", "signals.parquet", *CALIBRATE[2:]), "there are two columns 'a_1'")


def test_numbers_that_no_sensor_gives_are_missing_ones(bodydrive, shirt, tmp_path):
    """Values beyond float32, beyond a profile's range, and infinite: many of them exclude the channel."""
    for column, number in ((1, 1e300), (2, 1e30), (4, np.inf)):
        shirt[500:530, column] = number
    shirt[700, 5] = np.inf
    write_table(tmp_path / "signals.csv", shirt)
    assert set(parsed(bodydrive(*CALIBRATE, "--json"))["joints"]) == {"right_elbow", "left_elbow"}
    left_out = json.loads((tmp_path / "profile.json").read_text())["left_out"]
    assert {name: str(from_document(reason)) for name, reason in left_out.items()} == dict.fromkeys(
        ("right_elbow_0", "right_elbow_1", "left_elbow_0"), "misses 0.30 s at once, and at most 0.2 s are bridged"
    )
    decoded = bodydrive("decode", "signals.csv", "--profile", "profile.json", "--out", "out.parquet", "--json")
    assert parsed(decoded)["frames"] == 1200
    table = pyarrow.parquet.read_table(tmp_path / "out.parquet")
    numbers = [name for name in table.column_names if name != "simulated"]  # which a table of signals does not tell
    assert all(np.isfinite(table[name]).all() for name in numbers)


@pytest.mark.parametrize("scale", [1e-200, 1e13])
def test_signals_of_no_sensible_size_are_refused(bodydrive, shirt, tmp_path, scale):
    shirt[:, 1:] = (shirt[:, 1:] + 2) * scale if scale > 1 else shirt[:, 1:] * scale
    write_table(tmp_path / "signals.csv", shirt)
    refused(bodydrive(*CALIBRATE), "no joint of 'two elbows' has a sensor that can be used")


def test_a_joint_is_kept_when_each_of_its_channels_misses_a_few_samples(bodydrive, shirt, tmp_path):
    whole = parsed(bodydrive(*CALIBRATE, "--prompts", "prompts.csv", "--json"))["joints"]["right_elbow"]
    missing = np.random.default_rng(3).random((len(shirt), 3)) < 0.03
    shirt[:, 1:4][missing] = np.nan
    write_table(tmp_path / "signals.csv", shirt)
    holed = parsed(bodydrive(*CALIBRATE, "--prompts", "prompts.csv", "--json"))["joints"]["right_elbow"]
    assert holed["span"] == pytest.approx(whole["span"], rel=0.02)
    shirt[::2, 1:4] = np.nan  # but not when half of them do
    write_table(tmp_path / "signals.csv", shirt)
    assert parsed(bodydrive(*CALIBRATE, "--json"))["joints"]["right_elbow"]["has_to_be_repeated"] is True


def test_a_layout_with_a_mark_of_its_byte_order_is_read(bodydrive, shirt, tmp_path):
    layout = tmp_path / "layout.json"
    layout.write_bytes(b"\xef\xbb\xbf" + layout.read_bytes())
    parsed(bodydrive(*CALIBRATE, "--json"))


def test_a_channel_that_is_called_t_is_refused(bodydrive, shirt, tmp_path):
    layout = tmp_path / "layout.json"
    layout.write_text(layout.read_text().replace("right_elbow_0", "t"))
    refused(bodydrive(*CALIBRATE), "has a channel 't', which is the time")


@pytest.mark.parametrize("out", ["signals.csv", "layout.json", "prompts.csv", "link.csv", "pipe", ".", "x" * 300])
def test_what_was_read_and_what_is_no_file_is_never_replaced(bodydrive, shirt, tmp_path, out):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link.csv").symlink_to("signals.csv")
    before = {file.name: file.read_bytes() for file in tmp_path.iterdir() if file.is_file()}
    refused(bodydrive(*CALIBRATE[:-1], out, "--prompts", "prompts.csv"), "choose another place")
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir() if file.is_file()} == before
    assert (tmp_path / "pipe").is_fifo()


@pytest.mark.parametrize(
    ("option", "value", "words"),
    [
        ("--dead-zone", "-1", "--dead-zone -1: give full movements per second from 0 to 99"),
        ("--dead-zone", "nan", "--dead-zone nan: give full movements per second"),
        ("--dead-zone", "100", "--dead-zone 100: give full movements per second"),
        ("--cutoff", "9", "--cutoff 9: give Hz from 1 to 8"),
        ("--cutoff", "1e999", "--cutoff inf: give Hz"),
    ],
)
def test_decode_names_the_option_that_is_wrong(bodydrive, tmp_path, option, value, words):
    (tmp_path / "profile.json").write_text(make_profile().model_dump_json())
    refused(bodydrive("decode", "x.csv", "--profile", "profile.json", "--out", "y.csv", option, value), words)


def test_a_profile_that_is_nested_without_end(bodydrive, tmp_path):
    (tmp_path / "profile.json").write_text("[" * 100_000)
    refused(bodydrive("decode", "x.csv", "--profile", "profile.json", "--out", "y.csv"), "is not a JSON document")


@pytest.mark.parametrize(
    ("trial", "path", "words"),
    [
        ("0,0,0\n1,1e300,0\n", "0,0\n3,0\n", "trial.csv: x and y must be metres"),
        ("0,0,0\n1,1,0\n", "0,0\n1e300,0\n", "path.csv: x and y must be metres"),
        ("0,0,0\n0.01,1,0\n0.02,1,0\n1e308,1,0\n", "0,0\n3,0\n", "trial.csv: it lasts 1e+308 s, more than a day"),
    ],
)
def test_score_refuses_what_no_chair_drives(bodydrive, tmp_path, trial, path, words):
    (tmp_path / "trial.csv").write_text("t,x,y\n" + trial)
    (tmp_path / "path.csv").write_text("x,y\n" + path)
    refused(bodydrive("score", "trial.csv", "path.csv", "--json"), words)


@pytest.mark.parametrize(
    ("document", "image", "words"),
    [
        ("made: [2020, 2\n", b"", "hall.yaml: this is not a YAML document"),
        ("", b"P5\n4", "hall.pgm: this image cannot be read"),
        ("", b"P2\n4 4\n255\nabc", "hall.pgm: this image cannot be read"),
        ("", b"P5 9000 9000 255\n", "hall.pgm: this image has more than 40,000,000 pixels"),
    ],
)
def test_broken_maps_are_named(bodydrive, tmp_path, document, image, words):
    (tmp_path / "hall.pgm").write_bytes(image)
    (tmp_path / "hall.yaml").write_text(f"image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n{document}")
    refused(bodydrive("floorplan", "import", "hall.yaml", "--out", "plan.json"), words)


@pytest.mark.parametrize("host", ["a..b", "x" * 300, "é" * 80])
def test_replay_to_a_name_that_cannot_be_one(bodydrive, shirt, host):
    refused(bodydrive("replay", "signals.csv", "--to", f"{host}:5"), "there is no host of this name")


@pytest.mark.parametrize(
    ("out", "words"),
    [
        ("full", "--out full holds 'letter', which is no part of a study"),
        ("full/letter/study", "is a file and not a folder"),
        ("x" * 300, "cannot be written"),
    ],
)
@pytest.mark.parametrize("overwrite", [(), ("--overwrite",)])
def test_study_refuses_a_place_before_it_works(bodydrive, tmp_path, monkeypatch, out, words, overwrite):
    monkeypatch.setattr(study_runs, "run_study", pytest.fail)
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "letter").write_text("dear")
    (tmp_path / "full" / "study.json").write_text("{}")
    refused(bodydrive("study", "--out", out, *overwrite), words)
    assert (tmp_path / "full" / "letter").read_text() == "dear"


@pytest.mark.parametrize("seeds", [1, 2])
def test_without_matplotlib_a_study_says_so_before_it_works_and_goes_without_figures(
    bodydrive, tmp_path, monkeypatch, seeds
):
    monkeypatch.setitem(sys.modules, "matplotlib", None)  # as if it were not installed
    asked = ("study", "--out", "study", "--trials", 1, "--seeds", seeds, "--jobs", 1, "--path", "corridor")
    with monkeypatch.context() as before:
        before.setattr(study_runs, "run_study", pytest.fail)
        before.setattr(study_runs, "run_seeds", pytest.fail)
        words = "figures need the library matplotlib, install it with pip install 'bodydrive[figures]'"
        refused(bodydrive(*asked), words)
    code, _, _ = bodydrive(*asked, "--format", "none")
    assert code == 0
    written = {file.name for file in (tmp_path / "study").iterdir()}
    assert written == {"study.json", "trajectories.parquet", "trials.csv"}


@pytest.fixture
def interruptible():
    """Take an interrupt as at a terminal: a shell lets what it starts in the background ignore it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("interruptible")
def test_ctrl_c_in_a_study_leaves_nothing(bodydrive, tmp_path, monkeypatch):
    def interrupted(*_, **__):
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(study_runs, "write_study", interrupted)
    monkeypatch.setattr(study_runs, "run_study", lambda *_, **__: None)
    assert bodydrive("study", "--out", "study") == (130, "", "")
    assert not list(tmp_path.iterdir())


def test_a_full_disk_behind_stdout_is_one_sentence(bodydrive, monkeypatch):
    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("app.cli.floorplan.typer.echo", full)
    refused(bodydrive("floorplan", "list"), "the output cannot be read or written (No space left on device)")


def test_a_proxy_needs_its_name_and_a_name_its_proxy(bodydrive):
    for words in (("--behind-proxy", "127.0.0.1"), ("--name", "clinic.example.org")):
        refused(bodydrive("serve", *words), "--behind-proxy and --name belong together")
