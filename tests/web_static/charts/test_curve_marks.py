"""Sessions and versions of the map along a learning curve; the module runs in node, without a page."""


def test_sessions_and_maps_stand_where_they_belong(run_script):
    assert " holds" in run_script("charts/curve_marks.mjs")
