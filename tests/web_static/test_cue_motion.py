"""The cue of a movement with reduced motion; the module runs in node, without a page."""

from collections.abc import Callable


def test_where_reduced_motion_is_preferred_the_cue_changes_in_steps_and_does_not_glide(run_script: Callable[..., str]):
    assert " holds" in run_script("cue_motion.mjs")
