"""docs/promises.md is the one that its sources make, no promise is left out, and every test that it names exists."""

import re
from collections import defaultdict

import pytest
from promises.page import IN_PART, NOT_BUILT, NOT_SHOWN, PAGE, SHOWN, Promise, of_source, page, promises

from folders import ROOT

# Numbers that were never given are left out.
IDS = {
    "S": [number for number in range(1, 32) if number != 19],
    "C": [number for number in range(1, 29) if number not in {11, 13, 21}],
    "D": [number for number in range(1, 19) if number not in {2, 8}],
}
EVERY = promises()


def test_no_promise_is_left_out_and_none_stands_twice():
    expected = [f"{letter}{number}" for letter, numbers in IDS.items() for number in numbers]
    assert sorted(one.id for one in EVERY) == sorted(expected)


def test_the_page_is_current():
    assert PAGE.read_text(encoding="utf-8") == page(), "docs/promises.md is out of date: make page PAGE=promises"


def test_every_test_and_command_that_is_named_exists():
    functions = defaultdict(list)
    for file in (ROOT / "tests").rglob("test_*.py"):
        for name in re.findall(r"^(?:async )?def (\w+)", file.read_text(encoding="utf-8"), re.MULTILINE):
            functions[f"{file.name}::{name}"].append(file)
    named = {(one.id, test) for one in EVERY for test in one.tests}
    # exactly one: two files of one name could not be told apart
    assert {(promise, test) for promise, test in named if len(functions[test]) != 1} == set()
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    commands = {command for one in EVERY for command in one.commands}
    assert commands
    assert [
        name for name in commands if not re.search(rf"^{name.removeprefix('make ')}:", makefile, re.MULTILINE)
    ] == []


@pytest.mark.parametrize(
    ("tests", "commands", "missing", "built", "mark"),
    [
        (("a",), (), "", True, SHOWN),
        ((), ("make drills",), "", True, SHOWN),
        (("a",), (), "not all", True, IN_PART),
        ((), (), "nothing", True, NOT_SHOWN),
        (("a",), (), "not all", False, NOT_BUILT),
    ],
)
def test_the_mark_says_whether_a_promise_is_shown(tests, commands, missing, built, mark):
    assert Promise("C1", "words", tests, commands, missing, built).mark == mark


@pytest.mark.parametrize(
    "line", ["tests = []", 'tests = ["a"]\nbuilt = false', 'tests = ["a"]\ntest = "b"', 'missing = "all"']
)
def test_a_row_without_test_or_reason_is_refused(line):
    with pytest.raises(ValueError, match="C1"):
        of_source(f'[[promise]]\nid = "C1"\nwords = "w"\n{line}\n')
