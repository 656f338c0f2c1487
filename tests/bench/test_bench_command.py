"""`python -m bench`, as `make bench` runs it."""

import json
import os
import re
import subprocess
import sys
from types import SimpleNamespace

import pytest

import bench.__main__ as command
from bench.row import Row
from folders import ROOT


def bench(*words: str, **more: str) -> "subprocess.CompletedProcess[str]":
    command, environment = [sys.executable, "-m", "bench", *words], {**os.environ, **more}
    return subprocess.run(command, check=False, capture_output=True, text=True, cwd=ROOT, env=environment)


def test_one_part_is_measured_and_printed_as_one_json_object() -> None:
    ended = bench("fit", "--json")
    assert ended.returncode == 0, ended.stderr
    found = json.loads(ended.stdout)
    assert found["machine"]
    assert [row["figure"] > 0 for row in found["rows"]] == [True]


def test_without_json_a_table_says_what_depends_on_the_machine() -> None:
    ended = bench("fit")
    assert ended.stderr == "fit: fitting a calibration ...\n"
    title, _, head, _, row, _, machine = ended.stdout.splitlines()
    assert title == "What depends on how fast this machine is:"
    assert "measured (of each run)" in head
    assert re.match(r"\| calibration fit of 10 s at 1 kHz x 52 \| [\d.]+ ms \([\d.]+ to [\d.]+\) \| <= 100 \|", row)
    assert machine.endswith("not compiled")


def test_an_unknown_part_is_refused_in_one_sentence() -> None:
    ended = bench("fit", "speed")
    assert ended.returncode == 2
    assert "there is no part 'speed' to measure: use any of chain, gate" in ended.stderr


def test_a_part_that_cannot_be_measured_here_is_a_sentence_and_the_others_are_measured() -> None:
    ended = bench("page", "fit", "--json", PATH="/nowhere")
    assert ended.returncode == 0
    assert ended.stderr.startswith("page is not measured: there is no chromium here: install Debian's package")
    assert len(json.loads(ended.stdout)["rows"]) == 1


def test_what_was_measured_is_printed_although_another_part_failed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def measure(module: str) -> SimpleNamespace:
        if module == "bench.fit":
            return SimpleNamespace(measure_fit=lambda: [Row("a fit", [2.0], "ms", None, "lower", "two runs")])
        raise AssertionError("the page did not come")

    monkeypatch.setattr(command, "import_module", measure)
    monkeypatch.setattr(sys, "argv", ["bench", "page", "fit"])
    with pytest.raises(SystemExit) as ended:
        command.main()
    printed = capsys.readouterr()
    assert ended.value.code == 1
    assert "| a fit | 2 ms" in printed.out
    assert "page is not measured, because it failed:" in printed.err
    assert "the page did not come" in printed.err
