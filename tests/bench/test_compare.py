"""The comparison of two commits: rows that both have, medians with their spread; nonsense is refused in a sentence."""

import subprocess
import sys
from pathlib import Path

import pytest

from bench.compare import checkout, measure, table
from folders import ROOT


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
