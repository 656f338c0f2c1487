"""The range of a chart's axis; the module runs in node, without a page."""


def test_few_values_fill_the_axis(run_script):
    assert " holds" in run_script("charts/extent.mjs")
