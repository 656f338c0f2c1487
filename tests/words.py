"""`make words LANGUAGE=fr`: what a language lacks beside English, what is left over, and what cannot be read.

It also names the texts that are as in English: of a copied folder at first all, at the end names such as "STOP".
"""

import re
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Final

from fluent.syntax import FluentParser, ast

from folders import ROOT

WORDS: Final = ROOT / "web_static" / "words"
VALUE: Final = re.compile(r"\$(\w+)")
PLACEABLE: Final = re.compile(r"\{[^{}]*\}")
WORD: Final = re.compile(r"[A-Za-z]{3}")


@cache
def entries_of(text: str) -> Sequence[ast.EntryType]:
    """Return what a file with this text holds."""
    return FluentParser().parse(text).body


def texts_of(file: Path) -> dict[str, str]:
    """Return the ids of a file's messages in their order, each with its text as it is written.

    What cannot be read stands under its first line, without a text.
    """
    if not file.exists():
        return {}
    source, found = file.read_text(encoding="utf-8"), dict[str, str]()
    for entry in entries_of(source):
        if isinstance(entry, ast.Message) and entry.value is not None and entry.value.span is not None:
            found[entry.id.name] = source[entry.value.span.start : entry.value.span.end]
        elif isinstance(entry, ast.Junk):
            found[(entry.content or "").partition("\n")[0]] = ""
    return found


def messages_of(file: Path) -> dict[str, set[str]]:
    """Return the ids of a file's messages in their order, each with the names of its values."""
    return {name: set(VALUE.findall(text)) for name, text in texts_of(file).items()}


def differences(language: str) -> list[str]:
    """Return in sentences what differs from English."""
    english, other = WORDS / "en", WORDS / language
    files = sorted({file.relative_to(folder) for folder in (english, other) for file in folder.rglob("*.ftl")})
    found = []
    for file in files:
        source, translated = messages_of(english / file), messages_of(other / file)
        found += [f"{file}: {name} is missing" for name in source if name not in translated]
        found += [f"{file}: {name} is no message of English" for name in translated if name not in source]
        found += [
            f"{file}: {name} has the values {sorted(translated[name])}, English has {sorted(source[name])}"
            for name in source
            if name in translated and translated[name] != source[name]
        ]
    return found


def untranslated(language: str) -> list[str]:
    """Return in sentences which texts with words are as in English."""
    english = WORDS / "en"
    found = []
    for file in sorted(file.relative_to(english) for file in english.rglob("*.ftl")):
        translated = texts_of(WORDS / language / file)
        found += [
            f"{file}: {name} is as in English"
            for name, text in texts_of(english / file).items()
            if translated.get(name) == text and WORD.search(PLACEABLE.sub("", text))
        ]
    return found


if __name__ == "__main__":
    if not (WORDS / sys.argv[1]).is_dir():
        sys.exit(f"There is no folder {WORDS / sys.argv[1]}: copy that of English first (docs/translating.md).")
    alike, lines = untranslated(sys.argv[1]), differences(sys.argv[1])
    sys.stdout.write("".join(f"{line}\n" for line in [*alike, *lines]))
    sys.stdout.write(f"{len(alike)} texts are as in English\n")
    sys.exit(f"{len(lines)} differences" if lines else 0)
