"""The Drive page says of the patient's screens how many are paired, and apart what has no connection or no picture."""

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
