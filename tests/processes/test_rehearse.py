"""`bodydrive chair rehearse` with its processes: a signed record of every step, which it checks itself."""

import json
import os
import subprocess
import sys

import pytest

from app.hardware.chair.key import new_key, read_key, write_key
from app.hardware.chair.rehearsal import STEPS, is_genuine
from folders import ROOT

PATIENCE = 120.0  # s


def rehearse(folder, *options):
    command = [sys.executable, "-m", "app.cli.main", "chair", "rehearse", "--key-file", folder / "7.key", *options]
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    return subprocess.run(
        command, cwd=ROOT, env=environment, capture_output=True, encoding="utf-8", timeout=PATIENCE, check=False
    )


@pytest.fixture
def folder(tmp_path):
    write_key(tmp_path / "7.key", new_key(7))
    return tmp_path


@pytest.mark.parametrize("output", ["sim", pytest.param("whill", marks=pytest.mark.long)])
def test_every_step_is_in_the_record_which_is_signed(folder, output):
    out = folder / "record.json"
    run = rehearse(folder, "--out", out, "--who", "Ada", "--output", output)
    assert run.returncode in (0, 1), run.stderr  # a busy machine may keep a step too late
    record = json.loads(out.read_text(encoding="utf-8"))
    assert is_genuine(record, read_key(folder / "7.key"))
    assert [step["step"] for step in record["steps"]] == [step.name for step in STEPS[output]]
    assert (run.returncode == 0) is all(step["kept"] for step in record["steps"])
    page = (folder / "record.md").read_text(encoding="utf-8")
    assert "The chair was emulated." in page
    assert record["sha256"] in page
    assert rehearse(folder, "--out", out, "--verify").returncode == 0
    out.write_text(out.read_text(encoding="utf-8").replace("Ada", "Eve"), encoding="utf-8")
    refused = rehearse(folder, "--out", out, "--verify")
    assert (refused.returncode, refused.stderr.count("\n")) == (2, 1)


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (("--who", "Ada", "--output", "luci"), "luci"),
        (("--who", " "), "--who"),
        (("--who", "A\nb"), "--who"),
    ],
)
def test_bad_input_is_one_sentence_and_leaves_no_record(folder, options, why):
    run = rehearse(folder, "--out", folder / "record.json", *options)
    assert (run.returncode, run.stderr.count("\n")) == (2, 1)
    assert why in run.stderr
    assert sorted(file.name for file in folder.iterdir()) == ["7.key"]
