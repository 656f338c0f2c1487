"""A tablet's own sensor as the head tracker; its module runs in node, without a page."""


def test_a_tablet_tells_where_it_looks(run_script):
    assert " holds" in run_script("tablet_head.mjs")
