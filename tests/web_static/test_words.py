"""How a page makes the text of a message; the module runs in node, without a page."""


def test_a_text_has_its_values_numbers_as_given_and_the_right_plural(run_script):
    assert " hold" in run_script("words.mjs")
