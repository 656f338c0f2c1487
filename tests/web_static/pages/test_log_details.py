"""The details of a row of the log as words; the module runs in node, without a page."""


def test_patients_have_their_code_and_changes_say_before_and_now(run_script):
    assert " hold" in run_script("pages/log_details.mjs")
