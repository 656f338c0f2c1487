"""The server's messages: each can be read, has one place and the values that it is given; each language has all."""

import ast
import re
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from fluent.syntax import FluentParser
from fluent.syntax import ast as fluent

from app.texts import LANGUAGES
from folders import ROOT
from words import WORDS, differences, messages_of

FILES = sorted((ROOT / "app").rglob("*.py"))


def entries(file: Path) -> Iterator[fluent.EntryType]:
    """Yield what a file holds."""
    yield from FluentParser().parse(file.read_text(encoding="utf-8")).body


@cache
def messages() -> dict[str, set[str]]:
    """Return the messages of the server, each with the names of its values."""
    return {
        name: values for file in (WORDS / "en" / "server").glob("*.ftl") for name, values in messages_of(file).items()
    }


@cache
def messages_for_texts() -> dict[str, set[str]]:
    """Return the messages of the server, and those of the pages that it shares: the names of joints."""
    return messages() | messages_of(WORDS / "en" / "joints.ftl")


@cache
def trees() -> dict[str, ast.Module]:
    """Return the parsed modules of the program by their paths."""
    return {str(file.relative_to(ROOT)): ast.parse(file.read_text(encoding="utf-8")) for file in FILES}


def texts_of(tree: ast.AST) -> Iterator[ast.Call]:
    """Yield the calls that make a text."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Text":
            yield node


def pattern_of(argument: ast.expr) -> re.Pattern[str] | None:
    """Return the ids that the first argument of a text may be; None when it is a variable."""
    if isinstance(argument, ast.Constant):
        return re.compile(re.escape(str(argument.value)))
    if isinstance(argument, ast.JoinedStr):
        parts = [
            re.escape(str(part.value)) if isinstance(part, ast.Constant) else "[a-z0-9-]+" for part in argument.values
        ]
        return re.compile("".join(parts))
    return None


@pytest.mark.parametrize("language", sorted(folder.name for folder in WORDS.iterdir()))
def test_each_message_can_be_read_and_has_one_place(language):
    count: Counter[str] = Counter()
    for file in sorted((WORDS / language).rglob("*.ftl")):
        for entry in entries(file):
            assert not isinstance(entry, fluent.Junk), (file.name, entry.content)
            if isinstance(entry, fluent.Message):
                count[entry.id.name] += 1
    assert len(count) > 2000
    assert [name for name, times in count.items() if times > 1] == []
    assert [name for name in count if not re.fullmatch(r"[A-Za-z0-9]+(-[A-Za-z0-9]+)*", name)] == []


@pytest.mark.parametrize("language", LANGUAGES)  # that people can choose
def test_a_language_has_each_message_with_the_same_values(language):
    assert differences(language) == []


@pytest.mark.parametrize("path", [path for path, tree in trees().items() if any(texts_of(tree))])
def test_a_text_has_a_message_and_is_given_its_values(path):
    known, wrong = messages_for_texts(), []
    for call in texts_of(trees()[path]):
        pattern = pattern_of(call.args[0])
        if pattern is None:
            continue
        found = [name for name in known if pattern.fullmatch(name)]
        given = {keyword.arg for keyword in call.keywords}
        needed = set().union(*(known[name] for name in found))
        if not found or (None not in given and given != needed):
            wrong.append((call.lineno, ast.unparse(call.args[0]), given))
    assert wrong == []


def test_no_message_is_left_over():
    """An id stands in the program, or a text makes it with a part of its own."""
    literals = {
        node.value
        for tree in trees().values()
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }
    made = [
        pattern
        for tree in trees().values()
        for call in texts_of(tree)
        if isinstance(call.args[0], ast.JoinedStr) and (pattern := pattern_of(call.args[0])) is not None
    ]
    left = {name for name in messages() if name not in literals and not any(ids.fullmatch(name) for ids in made)}
    assert left == set()
