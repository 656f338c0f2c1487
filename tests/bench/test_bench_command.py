"""`python -m bench`, as `make bench` runs it, and the comparison of two commits."""

import json
import re
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace

import pytest

import bench.__main__ as command
from bench.compare import checkout, measure, table
from bench.row import Row
from folders import ROOT

FIT = "calibration fit of 10 s at 1 kHz x 52"


def bench(*words: str) -> "subprocess.CompletedProcess[str]":
    words = (sys.executable, "-m", "bench", *words)
    return subprocess.run(words, check=False, capture_output=True, text=True, cwd=ROOT)


def test_one_part_is_measured_and_printed_as_one_json_object() -> None:
    ended = bench("fit", "--json")
    assert ended.returncode == 0, ended.stderr
    found = json.loads(ended.stdout)
    assert found["machine"]
    assert [row["figure"] > 0 for row in found["rows"]] == [True]


@pytest.fixture
def printed(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """Return a function that measures parts in this process, `fit` in no time: exit code, stdout and stderr."""
    load = import_module
    fit = SimpleNamespace(measure_fit=lambda: [Row(FIT, [20.0, 21.0], "ms", 100.0, "lower", "two runs")])
    monkeypatch.setattr(command, "import_module", lambda module: fit if module == "bench.fit" else load(module))

    def of(*words: str) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["bench", *words])
        with pytest.raises(SystemExit) as ended:
            command.main()
        said = capsys.readouterr()
        return ended.value.code, said.out, said.err  # type: ignore[return-value]

    return of


def test_without_json_a_table_says_what_depends_on_the_machine(printed: Callable[..., tuple[int, str, str]]) -> None:
    code, out, errors = printed("fit")
    assert (code, errors) == (0, "fit: fitting a calibration ...\n")
    title, _, head, _, row, _, machine = out.splitlines()
    assert title == "What depends on how fast this machine is:"
    assert "measured (of each run)" in head
    assert re.match(r"\| calibration fit of 10 s at 1 kHz x 52 \| [\d.]+ ms \([\d.]+ to [\d.]+\) \| <= 100 \|", row)
    assert machine.endswith("not compiled")


def test_an_unknown_part_is_refused_in_one_sentence() -> None:
    ended = bench("fit", "speed")
    assert ended.returncode == 2
    assert "there is no part 'speed' to measure: use any of chain, gate" in ended.stderr


def test_a_part_that_cannot_be_measured_here_is_a_sentence_and_the_others_are_measured(
    printed: Callable[..., tuple[int, str, str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    code, out, errors = printed("page", "fit", "--json")
    assert code == 0
    assert errors.startswith("page is not measured: there is no chromium here: install Debian's package")
    assert len(json.loads(out)["rows"]) == 1


def test_what_was_measured_is_printed_although_another_part_failed(
    printed: Callable[..., tuple[int, str, str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    load = vars(command)["import_module"]  # that of `printed`

    def fail() -> None:
        raise AssertionError("the page did not come")

    page = SimpleNamespace(measure_page=fail)
    monkeypatch.setattr(command, "import_module", lambda module: page if module == "bench.web.page" else load(module))
    code, out, errors = printed("page", "fit")
    assert code == 1
    assert f"| {FIT} | 20.5 ms" in out
    assert "page is not measured, because it failed:" in errors
    assert "the page did not come" in errors


def test_rows_of_both_are_compared_by_their_medians() -> None:
    before = {"gate": [4.0, 5.0, 9.0], "gone": [1.0]}
    now = {"gate": [2.5, 2.0, 3.0], "new": [1.0]}
    assert table(before, now).splitlines()[2:] == ["| gate | 5 (4 to 9) | 2.5 (2 to 3) | 0.50 |"]


def test_a_commit_is_measured_in_a_folder_of_its_own() -> None:
    with checkout("HEAD") as folder:
        assert folder != ROOT
        assert (folder / "bench" / "__main__.py").is_file()
        figures = measure(folder, ["fit"])
    assert [figure > 0 for figure in figures.values()] == [True]
    assert not folder.exists()


def test_a_commit_without_a_benchmark_is_said(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="older than the benchmark"):
        measure(tmp_path, ["fit"])


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["no-such-commit", "gate"], "The commits cannot be compared: fatal: "),
        (["HEAD", "no-such-part", "--runs", "1"], "there is no part 'no-such-part'"),
        (["HEAD", "gate", "--runs", "0"], "--runs must be 1 or more"),
    ],
)
def test_what_cannot_be_compared_is_said(words: list[str], sentence: str) -> None:
    ended = subprocess.run(
        [sys.executable, "-m", "bench.compare", *words], check=False, capture_output=True, text=True, cwd=ROOT
    )
    assert ended.returncode in {1, 2}
    assert sentence in ended.stderr
