"""The result of a calibration says both forecasts of a map from other people, and what is not known."""

from typing import Any

HITS = {"value": 71.3, "uncertainty": 11.3}
FALSE = {"value": 1.79, "uncertainty": 1.2}


def test_each_forecast_has_its_uncertainty_and_what_is_not_known_is_said(answered: Any) -> None:
    given = [
        {"hits": HITS, "hits_with_prompts": None, "false_per_minute": FALSE},
        {"hits": None, "hits_with_prompts": None, "false_per_minute": None},
    ]
    known, unknown = answered("pages/expected_words.mjs", given)
    assert known == [
        "Of 100 movements about 71 are answered (± 11).",
        "At rest it acts about 1.8 times a minute (± 1.2).",
    ]
    assert unknown[0].startswith("How many of 100 movements are answered is not known yet")
    assert unknown[1] == "How often it acts at rest is known once this movement has been repeated."


def test_before_any_prompt_it_says_what_prompts_would_bring(answered: Any) -> None:
    without = {"value": 70.8, "uncertainty": 17.9}
    given = [{"hits": without, "hits_with_prompts": HITS, "false_per_minute": None}]
    ((hits, _, prompted),) = answered("pages/expected_words.mjs", given)
    assert hits == "Of 100 movements about 71 are answered (± 18)."
    assert prompted.startswith("After three repetitions of this movement the first figure is surer (± 11)")
