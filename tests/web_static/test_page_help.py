"""Each page says what it is for; the modules run in node, without a page."""


def test_every_page_has_three_sentences_and_a_drawing(run_script):
    assert " hold" in run_script("page_help.mjs")
