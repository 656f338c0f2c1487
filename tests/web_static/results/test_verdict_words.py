"""The words of verdicts on the pages; the modules run in node, without a page."""

import json
from collections.abc import Callable
from pathlib import Path

from app.scoring.verdict.measure_comparison import COMPARISONS


def test_pages_compare_the_measures_as_the_server_does_and_show_no_arrow_within_noise(
    run_script: Callable[..., str], tmp_path: Path
) -> None:
    file = tmp_path / "compared.json"
    file.write_text(json.dumps({name: [measure.better, measure.needs_goal] for name, measure in COMPARISONS.items()}))
    assert " holds" in run_script("results/verdict_words.mjs", file)
