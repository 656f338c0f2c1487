"""The messages: each can be read, has one place and the values that it is given; each language has all of them."""

import ast
import re
from collections import Counter
from functools import cache
from typing import NamedTuple

import pytest
from fluent.syntax import ast as fluent

from app.texts import LANGUAGES
from folders import ROOT
from words import WORDS, differences, entries_of, messages_of


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


class Module(NamedTuple):
    """What is read of a module of the program."""

    texts: list[ast.Call]  # that make a text
    literals: set[str]


@cache
def modules() -> dict[str, Module]:
    """Return the modules of the program by their paths."""
    found = {}
    for file in sorted((ROOT / "app").rglob("*.py")):
        module = found[file.relative_to(ROOT).as_posix()] = Module([], set())
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Text":
                module.texts.append(node)
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                module.literals.add(node.value)
    return found


def pattern_of(argument: ast.JoinedStr) -> re.Pattern[str]:
    """Return the ids that a text makes with a part of its own."""
    parts = [re.escape(str(part.value)) if isinstance(part, ast.Constant) else "[a-z0-9-]+" for part in argument.values]
    return re.compile("".join(parts))


def ids_of(argument: ast.expr, known: dict[str, set[str]]) -> list[str] | None:
    """Return the known ids that the first argument of a text may be; None when it is a variable."""
    if isinstance(argument, ast.Constant):
        return [name for name in (str(argument.value),) if name in known]
    if isinstance(argument, ast.JoinedStr):
        pattern = pattern_of(argument)
        return [name for name in known if pattern.fullmatch(name)]
    return None


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_message_can_be_read_and_has_one_place(language):
    count: Counter[str] = Counter()
    for file in sorted((WORDS / language).rglob("*.ftl")):
        for entry in entries_of(file.read_text(encoding="utf-8")):
            assert not isinstance(entry, fluent.Junk), (file.name, entry.content)
            if isinstance(entry, fluent.Message):
                count[entry.id.name] += 1
    assert len(count) > 2000
    assert [name for name, times in count.items() if times > 1] == []
    assert [name for name in count if not re.fullmatch(r"[A-Za-z0-9]+(-[A-Za-z0-9]+)*", name)] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_language_has_each_message_with_the_same_values(language):
    assert differences(language) == []


def test_each_text_has_a_message_and_is_given_its_values():
    known, wrong, count = messages_for_texts(), [], 0
    for path, module in modules().items():
        for call in module.texts:
            found = ids_of(call.args[0], known)
            if found is None:
                continue
            count += 1
            given = {keyword.arg for keyword in call.keywords}
            needed = set().union(*(known[name] for name in found))
            if not found or (None not in given and given != needed):
                wrong.append((path, call.lineno, ast.unparse(call.args[0]), given))
    assert wrong == []
    assert count > 500


def test_no_message_is_left_over():
    """An id stands in the program, or a text makes it with a part of its own."""
    literals = set().union(*(module.literals for module in modules().values()))
    made = [
        pattern_of(call.args[0])
        for module in modules().values()
        for call in module.texts
        if isinstance(call.args[0], ast.JoinedStr)
    ]
    left = {name for name in messages() if name not in literals and not any(ids.fullmatch(name) for ids in made)}
    assert left == set()
