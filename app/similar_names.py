"""Detects names that look alike, so that one is not mistaken for another."""

import re
import unicodedata
from collections.abc import Iterable
from typing import Final

from app.refusals import Conflict
from app.texts import Text

# Characters that look like a Latin letter or a digit (the common ones of Unicode's list of confusables).
PAIRS: Final = (
    "АA ВB ЕE ЅS ІI ЈJ КK МM НH ОO РP СC ТT УY ХX аa еe іi јj оo рp сc уy хx ѕs һh ԁd ԛq ԝw ӏl ӀI "
    "ΑA ΒB ΕE ΖZ ΗH ΙI ΚK ΜM ΝN ΟO ΡP ΤT ΥY ΧX οo ρp νv υu αa ɡg ıi ɑa"
)
LETTERS_OF: Final = str.maketrans({pair[0]: pair[1] for pair in PAIRS.split()})
SAME: Final = str.maketrans({"l": "1", "I": "1", "|": "1", "O": "0", "o": "0"})
TOGETHER: Final = {"HIRAGANA", "KATAKANA", "KATAKANA-HIRAGANA", "CJK", "BOPOMOFO", "HANGUL"}  # written in one word
WORD: Final = re.compile(r"[^\W\d_]+")


def skeleton(name: str) -> str:
    """Return what is equal for names that look alike: P-1 and P-l, Latin and Cyrillic letters of the same shape."""
    return " ".join(unicodedata.normalize("NFKC", name).translate(LETTERS_OF).translate(SAME).split())


def similar_name(name: str, others: Iterable[str]) -> str | None:
    """Return the first of other names that looks like this one; equal names look alike."""
    own_skeleton = skeleton(name)
    return next((other for other in others if skeleton(other) == own_skeleton), None)


def mixed_word(name: str) -> str | None:
    """Return the first word of a name whose letters are of two scripts, such as Latin and Cyrillic."""
    return next((word for word in WORD.findall(name) if len(_scripts(word)) > 1), None)


def require_distinct(name: str, others: Iterable[str], message: str) -> None:
    """Raise Conflict when a word of a name is of two scripts, or the name looks like one of the others.

    `message`: the id of the text for the second case, with the values `other` and `name`.
    """
    word = mixed_word(name)
    if word is not None:
        raise Conflict(Text("names-two-scripts", word=word))
    other = similar_name(name, others)
    if other is not None:
        raise Conflict(Text(message, other=other, name=name))


def _scripts(word: str) -> set[str]:
    named = (unicodedata.name(letter, "").partition(" ")[0] for letter in word if unicodedata.category(letter) != "Lm")
    return {"together" if name in TOGETHER else name for name in named if name not in {"", "MODIFIER", "COMBINING"}}
