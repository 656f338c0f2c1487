"""The messages of the pages, web_static/words/LANGUAGE/*.ftl, and where the modules name them."""

import re
from collections.abc import Container, Iterator
from pathlib import Path
from typing import Final

from folders import ROOT

WORDS: Final = ROOT / "web_static" / "words"
SCRIPTS: Final = ROOT / "web_static" / "js"
BEGINNING: Final = re.compile(r"^([a-zA-Z][\w-]*) *=", re.MULTILINE)
LITERAL: Final = re.compile(r'"([^"\n]*)"')
# A template of an id: parts of one, and values in which no other template stands.
TEMPLATE: Final = re.compile(r"`((?:[\w-]+|\$\{[^{}`]*\})+)`")
VALUE: Final = re.compile(r"\$\{[^{}`]*\}")
COMPARED: Final = re.compile(r'[=!]== "[^"\n]*"')
CALL: Final = re.compile(r"(?<![\w.])(?:t|textWith|hasText)\(")


def ids_of(file: Path) -> list[str]:
    """Return the ids of a file in their order."""
    return BEGINNING.findall(file.read_text(encoding="utf-8"))


def ids_of_language(language: str = "en") -> dict[str, set[str]]:
    """Return the ids by the name of their file, without its end."""
    return {file.stem: set(ids_of(file)) for file in sorted((WORDS / language).glob("*.ftl"))}


def id_of(text: str) -> str:
    """Return the part of an id that a text gives: idOf of web_static/js/words.js."""
    return re.sub(r"[^A-Za-z0-9]+", "-", re.sub(r"-$", "-minus", re.sub(r"\+$", "-plus", text)))


def is_made_by(template: str, name: str, values: Container[str]) -> bool:
    """Tell whether a template makes an id when its values are some of `values`."""

    def follows(parts: list[str], rest: str) -> bool:
        first, *others = parts
        if not rest.startswith(first):
            return False
        rest = rest.removeprefix(first)
        if not others:
            return not rest
        return any(rest[:end].strip("-") in values and follows(others, rest[end:]) for end in range(len(rest) + 1))

    return follows(VALUE.split(template), name)


def scripts() -> dict[str, str]:
    """Return the modules by their paths below web_static/js."""
    files = sorted(SCRIPTS.rglob("*.js"))
    return {file.relative_to(SCRIPTS).as_posix(): file.read_text(encoding="utf-8") for file in files}


def asked_for(script: str) -> Iterator[str]:
    """Yield the first argument of each call of t(), textWith() and hasText() in a module."""
    for call in CALL.finditer(script):
        depth, at = 1, call.end()
        while depth and not (depth == 1 and script[at] == ","):
            depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(script[at], 0)
            at += 1
        yield script[call.end() : at]
