"""The bench of a shirt that is put on again prints its figures from one person too."""

import re

import pytest

from bench.learning.donning import main


def test_it_counts_what_s5_silences_with_each_kind_of_range(capsys: pytest.CaptureFixture[str]) -> None:
    main(people=1)
    text = capsys.readouterr().out
    counts = [int(found) for found in re.findall(r"silences (\d+) of 16", text)]
    assert len(counts) == 3
    assert counts[0] > counts[1] >= counts[2]
    assert "standard deviation of" in text
