"""Which group of trials a review shows first; the module runs in node, without a page."""


def test_worn_trials_come_first_and_otherwise_what_was_driven_last(run_script):
    assert " holds" in run_script("results/source_group.mjs")
