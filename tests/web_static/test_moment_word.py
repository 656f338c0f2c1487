"""Which large word the patient's screen shows; the module runs in node, without a page."""


def test_no_end_of_a_trial_is_forgotten(run_script):
    assert " holds" in run_script("moment_word.mjs")
