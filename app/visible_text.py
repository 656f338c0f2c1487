"""Refuses invisible characters in text, because they change how other text looks, or puts spaces in their place."""

import unicodedata
from collections.abc import Collection
from typing import Final

from app.texts import Text

# Categories of Unicode 15.0, section 4.5: control characters, format characters (among them the right-to-left
# overrides, joiners and marks), surrogates, line and paragraph separators.
INVISIBLE: Final = frozenset({"Cc", "Cf", "Cs", "Zl", "Zp"})
LINE_BREAKS: Final = frozenset("\n\r\t")


def visible_line(text: str) -> str:
    """Return a text of one line unchanged.

    Raises
    ------
    ValueError
        Half a sentence: which character is invisible, at which position, and what to do.
    """
    return _check_visible(text, ())


def visible_lines(text: str) -> str:
    """Return a text with line breaks and tabs unchanged; raise ValueError as `visible_line` does."""
    return _check_visible(text, LINE_BREAKS)


def one_line(text: str, longest: int | None = None) -> str:
    """Return what others wrote, such as a library of an error, in one printable line of at most `longest` characters.

    Spaces stand for what cannot be printed; the line may be empty.
    """
    printable = "".join(letter if letter.isprintable() else " " for letter in text)
    return " ".join(printable.split())[:longest].rstrip()


def _check_visible(text: str, allowed: Collection[str]) -> str:
    for place, character in enumerate(text, start=1):
        if unicodedata.category(character) in INVISIBLE and character not in allowed:
            code, name = f"U+{ord(character):04X}", unicodedata.name(character, "a control character").lower()
            raise ValueError(Text("invalid-invisible", place=place, code=code, name=name))
    return text
