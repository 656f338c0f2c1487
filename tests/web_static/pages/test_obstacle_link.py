"""The Drive page leads to what is missing while the controls cannot drive; the module runs in node."""


def test_a_calibration_that_does_not_fit_leads_to_a_new_one(run_script):
    assert " holds" in run_script("pages/obstacle_link.mjs")
