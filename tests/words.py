"""`make words LANGUAGE=fr`: what a language lacks beside English, what is left over, and what cannot be read."""

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


@cache
def entries_of(text: str) -> Sequence[ast.EntryType]:
    """Return what a file with this text holds."""
    return FluentParser().parse(text).body


def messages_of(file: Path) -> dict[str, set[str]]:
    """Return the ids of a file's messages in their order, each with the names of its values.

    What cannot be read stands under its first line, without values.
    """
    if not file.exists():
        return {}
    text, found = file.read_text(encoding="utf-8"), dict[str, set[str]]()
    for entry in entries_of(text):
        if isinstance(entry, ast.Message) and entry.value is not None and entry.value.span is not None:
            found[entry.id.name] = set(VALUE.findall(text[entry.value.span.start : entry.value.span.end]))
        elif isinstance(entry, ast.Junk):
            found[(entry.content or "").partition("\n")[0]] = set()
    return found


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


if __name__ == "__main__":
    if not (WORDS / sys.argv[1]).is_dir():
        sys.exit(f"There is no folder {WORDS / sys.argv[1]}: copy that of English first (docs/translating.md).")
    lines = differences(sys.argv[1])
    sys.stdout.write("".join(f"{line}\n" for line in lines))
    sys.exit(f"{len(lines)} differences" if lines else 0)
