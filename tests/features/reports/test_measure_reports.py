"""Measures and trials in the words of a report."""

import pytest

from app.features.reports.measure_reports import _trials_text, with_unit

ROW = {"session": 1, "familiarisation": False, "reached": True}


def test_levels_have_their_unit():
    assert with_unit("e_diff", 1.234) == "1.23 m²"
    assert with_unit("heading_error_deg", 12.0) == "12°"
    assert with_unit("sparc", -3.5) == "\u22123.50"
    assert with_unit("heading_error_deg", 12.3) == "12°"
    assert with_unit("follow_near", 0.434) == "43 %"
    assert with_unit("collisions", 0.4) == "0.4"
    assert with_unit("dist", None) == ""


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
