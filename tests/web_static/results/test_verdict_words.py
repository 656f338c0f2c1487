"""The words of verdicts on the pages; the modules run in node, without a page."""

from collections.abc import Callable
from pathlib import Path


def test_the_verdict_on_a_measure_has_its_unit_and_no_arrow_within_noise(
    run_script: Callable[..., str], reference_file: Path
) -> None:
    assert " holds" in run_script("results/verdict_words.mjs", reference_file)
