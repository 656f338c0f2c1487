"""The time columns of files of other laboratories, in the commands and in a shirt that replays a file."""

import json

import numpy as np
import pytest
from cli.answers import invoke

from app.hardware.base import HardwareError
from app.hardware.shirt.playback import read_frames
from folders import SHARED

CASES = SHARED / "data" / "cases"
LAYOUT = {
    "name": "one joint",
    "channels": [{"name": name, "joint": "elbow"} for name in "ABC"],
    "joints": [{"name": "elbow", "label": "Elbow"}],
}
ROWS = np.arange(1200)
BURSTS = 0.1 + 0.1 * (ROWS // 5) + 0.001 * (ROWS % 5)


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "layout.json").write_text(json.dumps(LAYOUT))
    (tmp_path / "prompts.csv").write_text("start,end,joint\n4,5,elbow\n7,8,elbow\n10,11,elbow\n")
    return tmp_path


def write(folder, t):
    noise = np.random.default_rng(1).normal(size=(len(t), 3))
    bent = sum(0.5 - 0.5 * np.cos(np.pi * np.clip(ROWS / 50 - start, 0, 2)) for start in (4, 7, 10))
    values = 500 + 100 * np.multiply.outer(bent, [1.0, 0.4, -0.7]) + 0.3 * noise
    file = folder / "signals.csv"
    np.savetxt(file, np.column_stack([t, values]), "%.9f", ",", header="t,A,B,C", comments="")
    return file


def commands(folder, file):
    layout, profile = folder / "layout.json", folder / "profile.json"
    person = ("--layout", layout, "--prompts", folder / "prompts.csv", "--person", "P1")
    write(folder, ROWS / 50).rename(folder / "even.csv")
    assert invoke("calibrate", folder / "even.csv", "--layout", layout, "--out", profile).exit_code == 0
    return [
        ("calibrate", file, "--layout", layout, "--out", folder / "new.json"),
        ("decode", file, "--profile", profile, "--out", folder / "commands.csv"),
        ("prior", "add", folder / "prior.json", file, *person),
    ]


@pytest.mark.parametrize(
    ("t", "words"),
    [
        (ROWS * 2e7, "looks like nanoseconds (50 Hz)"),
        (ROWS * 20.0, "looks like milliseconds (50 Hz)"),
        (ROWS / 3000, "looks like minutes (23.98 s at 50 Hz)"),
        (np.where(ROWS < 600, ROWS / 50, ROWS / 50 + 2e5), "t jumps there by 200000 s (55.6 hours)"),
        (np.cumsum(np.random.default_rng(1).uniform(0.004, 0.036, 1200)), "without an even sample rate"),
    ],
)
def test_every_command_and_a_replayed_shirt_refuse_in_one_sentence(folder, t, words):
    for command in commands(folder, file := write(folder, t)):
        write(folder, t)
        refused = invoke(*command)
        assert refused.exception is not None
        assert words in str(refused.exception), command
    assert not {"new.json", "commands.csv", "prior.json"} & {written.name for written in folder.iterdir()}
    assert words in str(invoke("replay", file).exception)
    with pytest.raises(HardwareError) as refusal:
        read_frames(file)
    assert words in str(refusal.value)


@pytest.mark.parametrize(("t", "words"), [(BURSTS, "come in bursts"), (np.floor(ROWS / 50), "the time of the sample")])
def test_bursts_and_whole_seconds_are_decoded_as_even_samples_and_said(folder, t, words):
    file = write(folder, t)
    for command in commands(folder, file):
        write(folder, t)
        done = invoke(*command)
        assert done.exit_code == 0, done.output
        assert words in done.stderr
        assert "at 50 Hz" in done.stderr
    active = [np.genfromtxt(folder / "commands.csv", delimiter=",", names=True)["elbow_activation"] > 0]
    profile, even = folder / "profile.json", folder / "even_commands.csv"
    assert invoke("decode", folder / "even.csv", "--profile", profile, "--out", even).exit_code == 0
    active.append(np.genfromtxt(even, delimiter=",", names=True)["elbow_activation"] > 0)
    assert active[0].sum() == pytest.approx(active[1].sum(), abs=2)
    assert active[1].sum() > 50
    frames = read_frames(file)
    assert frames.sample_rate == 50.0
    assert np.diff(frames.seq).tolist() == [1] * (len(t) - 1)
    assert words in str(frames.note)


@pytest.mark.skipif(not CASES.is_dir(), reason="the files of other laboratories are not here")
@pytest.mark.parametrize(
    ("name", "words", "sample_rate", "active"),
    [
        ("control", "", 50.0, 543),
        ("burst-arrival", "come in bursts", 50.0, 543),
        ("stamps-of-1-s", "the time of the sample before", 50.0, 136),
        ("minutes", "looks like minutes", None, None),
        ("epoch-ns", "in nanoseconds", 50.0, 68),
        ("jump-of-200000-s", "line 1203: t jumps there", None, None),
    ],
)
def test_the_files_that_were_seen(name, words, sample_rate, active, folder):
    profile, file, layout = folder / "profile.json", CASES / f"signals-{name}.csv", CASES / "signals.layout.json"
    assert invoke("calibrate", CASES / "signals-control.csv", "--layout", layout, "--out", profile).exit_code == 0
    decoded = invoke("decode", file, "--profile", profile, "--out", folder / "commands.csv", "--json")
    if sample_rate is None:
        assert words in str(decoded.exception)
        return
    assert json.loads(decoded.stdout)["sample_rate"] == sample_rate
    assert words in decoded.stderr
    commands = np.genfromtxt(folder / "commands.csv", delimiter=",", names=True)
    assert (commands["elbow_activation"] > 0).sum() == pytest.approx(active, abs=2)
