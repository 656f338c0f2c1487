"""Levels of measures in the words of a report."""

from app.features.reports.measure_reports import with_unit


def test_levels_have_their_unit():
    assert with_unit("e_diff", 1.234) == "1.23 m²"
    assert with_unit("heading_error_deg", 12.0) == "12°"
    assert with_unit("sparc", -3.5) == "\u22123.50"
    assert with_unit("heading_error_deg", 12.3) == "12°"
    assert with_unit("follow_near", 0.434) == "43 %"
    assert with_unit("collisions", 0.4) == "0.4"
    assert with_unit("dist", None) == ""
