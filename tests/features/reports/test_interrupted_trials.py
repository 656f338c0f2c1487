"""A report names the counted trials that were interrupted."""

import pytest

from app.features.reports.measure_reports import _trials_text

ROW = {"session": 1, "familiarisation": False, "reached": True}


def rows(count):
    return [{**ROW, "number": number, "halts": 1, "halt_time": 2.0} for number in range(1, count + 1)]


@pytest.mark.parametrize(
    ("found", "words"),
    [
        ([{**ROW, "number": 1}], "the goal was reached in 1."),
        (rows(1), "Interrupted: trial 1 (halted once, 2 s)."),
        (rows(8), "trial 6 (halted once, 2 s) and 2 more."),
    ],
)
def test_interrupted_trials_are_named(found, words):
    assert _trials_text(found, None).endswith(words)
