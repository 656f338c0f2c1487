"""The page docs/speed.md holds the newest run of each build."""

from datetime import date

from bench.row import Row
from bench.tables import Measured, page
from folders import ROOT

RATIO = Row("a step", [1.0, 2.0, 4.0], "x", 2.5, "lower", "5 us a step")
TIME = Row("a page", [900.0], "ms", 800.0, "lower", "one run")
OLDER, NEWER = (Measured("a machine", commit, date(2026, 11, day)) for commit, day in (("abc1234", 2), ("def5678", 3)))


def test_a_run_says_when_where_and_of_what_it_was_made() -> None:
    text = page("", [RATIO, TIME], OLDER, ["eye"], compiled=False)
    assert "## Plain Python\n2 November 2026, commit abc1234, a machine.\nNot measured: eye.\n" in text
    assert "| a step | 2 x (1 to 4) | <= 2.5 | 5 us a step |" in text
    assert "| a page | 900 ms | <= 800 | one run **not reached** |" in text


def test_what_two_rows_have_in_common_is_named_once() -> None:
    rows = [Row(f"an echo: {what}", [1.0], "x", None, "lower", "") for what in ("median", "p99")]
    text = page("", rows, OLDER, [], compiled=False)
    assert "| an echo: median | 1 x |  |  |\n| … p99 | 1 x |  |  |\n" in text


def test_a_newer_run_takes_the_place_of_that_of_its_own_build() -> None:
    both = page(page("", [RATIO], OLDER, [], compiled=True), [RATIO], OLDER, [], compiled=False)
    assert both.index("## Plain Python") < both.index("## Compiled")
    newer = page(both, [TIME], NEWER, [], compiled=False)
    assert newer.count("abc1234") == newer.count("def5678") == 1
    assert newer.partition("## Compiled")[2] == both.partition("## Compiled")[2]


def test_the_page_of_the_documents_is_written_so() -> None:
    text = (ROOT / "docs" / "speed.md").read_text(encoding="utf-8")
    (first, *_) = (part for part in text.split("\n## ")[1:])
    assert first.startswith("Plain Python\n")
    assert "commit " in first.splitlines()[1]
