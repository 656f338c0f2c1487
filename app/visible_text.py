"""Refuses invisible characters in names and in text of several lines: they change how other text looks."""

import unicodedata
from collections.abc import Collection
from typing import Final

# Unicode 15.0, section 4.5: control characters, invisible format characters (among them the right-to-left overrides,
# joiners and marks), halves of a pair, and what separates lines and paragraphs.
UNSEEN: Final = frozenset({"Cc", "Cf", "Cs", "Zl", "Zp"})
LINE_BREAKS: Final = frozenset("\n\r\t")


def visible_line(text: str) -> str:
    """Return a name or another text of one line as it is.

    Raises
    ------
    ValueError
        Half a sentence: which character is not visible, at which place, and what to do.
    """
    return _visible(text, ())


def visible_lines(text: str) -> str:
    """Return a text as it is, which may have line breaks and tabs; ValueError as of `visible_line`."""
    return _visible(text, LINE_BREAKS)


def _visible(text: str, allowed: Collection[str]) -> str:
    for place, character in enumerate(text, start=1):
        if unicodedata.category(character) in UNSEEN and character not in allowed:
            name = unicodedata.name(character, "a control character")
            raise ValueError(
                f"character {place} is U+{ord(character):04X} ({name.lower()}), which nobody sees: leave it out"
            )
    return text
