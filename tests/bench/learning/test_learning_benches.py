"""The benches of forecasts and of a shirt that is put on again count the gestures of simulated people."""

import re

import pytest

from bench.learning.donning import main
from bench.learning.forecasts import KINDS, Kind, Tally, compare, row


def test_one_person_is_compared_and_counted() -> None:
    tally = Tally()
    compare(Kind("able", 0.0, 0.0), 1, tally, rest=5.0, repetitions=2)
    assert (tally.gestures, tally.movements) == (4, 8)
    assert 4 * 4.5 / 60 < tally.minutes < 4 * 5 / 60
    assert tally.counted_false == 0
    assert tally.counted_hits == 8
    assert 7 < tally.predicted_hits <= 8
    cells = row(KINDS[0], tally).split("|")[1:-1]
    assert (cells[0].strip(), cells[1].strip(), cells[8].strip()) == ("able", "4", "1.000")


def test_people_differ_in_what_they_are_asked_to() -> None:
    even, uneven = Tally(), Tally()
    compare(Kind("even", 0.0, 0.0), 2, even, rest=1.0, repetitions=6)
    compare(Kind("uneven", 0.0, 1.0), 2, uneven, rest=1.0, repetitions=6)
    assert uneven.counted_hits < even.counted_hits


def test_it_counts_what_s5_silences_with_each_kind_of_range(capsys: pytest.CaptureFixture[str]) -> None:
    main(people=1)
    text = capsys.readouterr().out
    counts = [int(found) for found in re.findall(r"silences (\d+) of 16", text)]
    assert len(counts) == 3
    assert counts[0] > counts[1] >= counts[2]
    assert "standard deviation of" in text
