"""The tables of docs/safety.md name tests that exist, and no invariant is left out."""

import ast
import re
from collections import defaultdict

from folders import ROOT

PAGE = (ROOT / "docs" / "safety.md").read_text()
INVARIANTS = [f"S{number}" for number in range(1, 32) if number != 19]  # there is no S19
NAMED = re.findall(r"`([\w/]+\.py)::(\w+)`", PAGE)


def functions_of(file):
    nodes = ast.walk(ast.parse(file.read_text()))
    return {node.name for node in nodes if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)}


def test_every_test_that_the_page_names_is_there():
    places = defaultdict(list)
    for file in (ROOT / "tests").rglob("*.py"):
        for place in {place for place, _ in NAMED if file.as_posix().endswith(f"/{place}")}:
            places[place].append(file)
    assert {place: files for place, _ in NAMED if len(files := places[place]) != 1} == {}
    functions = {place: functions_of(file) for place, (file,) in places.items()}
    assert [(place, name) for place, name in NAMED if name not in functions[place]] == []


def test_every_invariant_has_its_row():
    rows = {
        invariant: [line for line in PAGE.splitlines() if re.match(rf"\| {invariant} \|", line)]
        for invariant in INVARIANTS
    }
    assert {invariant: found for invariant, found in rows.items() if len(found) != 1} == {}
    # a row names its test, or says why there is none
    assert [row for (row,) in rows.values() if not re.search(r"::test_|`make drills`|not shown", row)] == []


ACTIONS = ("drive on", "turn on", "stop", "arm", "adapt", "change speed")
WAYS = ("given wrongly", "not given", "too late", "too long")


def test_every_control_action_is_looked_at_in_every_way_it_can_be_unsafe():
    table = PAGE.partition("### Control actions")[2].partition("###")[0]
    rows = [[cell.strip() for cell in line[1:-1].split("|")] for line in table.splitlines() if line.startswith("| ")]
    action, way, seen = "", "", []
    for row in rows[1:]:
        action, way = row[0] or action, row[1] or way
        seen.append((action, way))
        assert "test" in row[-1], f"{action}, {way}: name a test, or say that there is none"
    assert set(seen) == {(action, way) for action in ACTIONS for way in WAYS}
