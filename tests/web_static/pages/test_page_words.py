"""What pages say of the patient's screens, and of the forecasts of a map from other people."""

from typing import Any

import pytest

GOOD, PLAN = {"connected": True, "picture": "view"}, {"connected": True, "picture": "plan"}
EMPTY, NEW = {"connected": True, "picture": "none"}, {"connected": True, "picture": None}
AWAY = {"connected": False, "picture": None}


@pytest.mark.parametrize(
    ("screens", "words", "is_bad"),
    [
        ([], "None is paired", False),
        ([GOOD], "1 paired", False),
        ([GOOD, PLAN, NEW], "3 paired", False),
        ([EMPTY], "1 paired, without a picture", True),
        ([GOOD, EMPTY], "2 paired, not all with a picture", True),
        ([AWAY], "1 paired, not connected", True),
        ([GOOD, AWAY, EMPTY], "3 paired, not all connected", True),
    ],
)
def test_what_is_said_of_the_screens(answered: Any, screens: list[Any], words: str, is_bad: bool) -> None:
    assert answered("pages/screen_words.mjs", [screens]) == [{"words": words, "isBad": is_bad}]


HITS = {"value": 71.3, "uncertainty": 11.3}
FALSE = {"value": 1.79, "uncertainty": 1.2}


def test_each_forecast_has_its_uncertainty_and_what_is_not_known_is_said(answered: Any) -> None:
    given = [
        {"hits": HITS, "hits_with_prompts": None, "false_per_minute": FALSE},
        {"hits": None, "hits_with_prompts": None, "false_per_minute": None},
    ]
    known, unknown = answered("pages/expected_words.mjs", given)
    assert known == [
        "About 71 of 100 movements are recognised (± 11).",
        "At rest this movement is recognised by mistake about 1.8 times a minute (± 1.2).",
    ]
    assert unknown[0].startswith("It is not known yet how many of 100 movements are recognised")
    assert (
        unknown[1]
        == "It is not known yet how often this movement is recognised by mistake at rest: it must be repeated first."
    )


def test_before_any_prompt_it_says_what_prompts_would_bring(answered: Any) -> None:
    without = {"value": 70.8, "uncertainty": 17.9}
    given = [{"hits": without, "hits_with_prompts": HITS, "false_per_minute": None}]
    ((hits, _, prompted),) = answered("pages/expected_words.mjs", given)
    assert hits == "About 71 of 100 movements are recognised (± 18)."
    assert prompted.startswith("The repetitions of this movement make the first figure more certain (± 11)")
