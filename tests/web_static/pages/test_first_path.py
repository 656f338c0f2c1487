"""Review begins with a task that has a verdict, and says how many trials another one lacks; the modules run in node."""


def test_a_task_that_can_be_compared_comes_first_and_what_counts_is_said(run_script, reference_file):
    assert " holds" in run_script("pages/first_path.mjs", reference_file)
