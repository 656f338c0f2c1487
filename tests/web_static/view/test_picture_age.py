"""How old a picture may be that somebody drives by (S24); the module runs in node, without a page."""


def test_a_second_is_too_old_unless_the_page_itself_is_late(run_script):
    assert " holds" in run_script("view/picture_age.mjs")
