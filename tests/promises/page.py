"""The page docs/promises.md: every promise with its tests, made of docs/safety.md and docs/promises.toml."""

import re
import tomllib
from typing import NamedTuple

from folders import ROOT

PAGE = ROOT / "docs" / "promises.md"
SAFETY = ROOT / "docs" / "safety.md"
SOURCE = ROOT / "docs" / "promises.toml"

SHOWN, IN_PART, NOT_SHOWN, NOT_BUILT = "shown", "in part", "🔴 **no test**", "not built yet"
MARKS = (SHOWN, IN_PART, NOT_BUILT, NOT_SHOWN)
PARTS = (("C", "Security"), ("D", "Data"))
KEYS = {"id", "words", "built", "tests", "commands", "missing"}

HEAD = """# Promises

Made by `make page PAGE=promises` of [safety.md](safety.md) and [promises.toml](promises.toml). Each promise has the
tests that show it (file in `tests/` and function): all of it, unless it says what is missing.
The promises on safety stand in [safety.md](safety.md#what-holds).

"""


class Promise(NamedTuple):
    """What is promised, and what shows it."""

    id: str
    words: str
    tests: tuple[str, ...]  # FILE::FUNCTION
    commands: tuple[str, ...]  # such as `make drills`
    missing: str  # what no test shows, empty for nothing
    built: bool

    @property
    def mark(self) -> str:
        """Whether it is shown."""
        if not self.built:
            return NOT_BUILT
        if not self.tests and not self.commands:
            return NOT_SHOWN
        return IN_PART if self.missing else SHOWN

    @property
    def row(self) -> str:
        """Its line in the table."""
        shown_by = ", ".join(f"`{one}`" for one in (*self.tests, *self.commands))
        return f"| {self.id} | {self.words}{self.gap} | {shown_by} |"

    @property
    def gap(self) -> str:
        """What its tests do not show, in words with its mark; empty for nothing."""
        return "" if self.mark == SHOWN else f" **{self.mark.replace('**', '')}**: {self.missing}"


def promises() -> list[Promise]:
    """Return every promise, in the order of the page."""
    source = SOURCE.read_text(encoding="utf-8")
    missing = tomllib.loads(source)["safety"]
    return [*of_safety(SAFETY.read_text(encoding="utf-8"), missing), *of_source(source)]


def of_safety(page: str, missing: dict[str, str]) -> list[Promise]:
    """Return the promises of the table of docs/safety.md, with what is `missing`, by their ids."""
    found = []
    for line in page.splitlines():
        if re.match(r"\| S\d+ \|", line):
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            shown = cells[-1]
            tests = tuple(re.findall(r"`([\w/]+\.py::\w+)`", shown))
            commands = tuple(re.findall(r"`(make [a-z-]+)`", shown))
            found.append(Promise(cells[0], cells[1], tests, commands, missing.get(cells[0], ""), built=True))
    return found


def of_source(text: str) -> list[Promise]:
    """Return the promises of docs/promises.toml; ValueError for one with an unknown or missing key."""
    found = []
    for one in tomllib.loads(text)["promise"]:
        unknown = one.keys() - KEYS
        if unknown or not {"id", "words", "tests"} <= one.keys():
            raise ValueError(f"{one.get('id')}: unknown or missing keys {sorted(unknown)}")
        tests, commands = tuple(one["tests"]), tuple(one.get("commands", ()))
        built, missing = one.get("built", True), one.get("missing", "")
        if (not built or not tests) and not missing:
            raise ValueError(f"{one['id']}: say in `missing` what there is not")
        found.append(Promise(one["id"], one["words"], tests, commands, missing, built))
    return found


def page() -> str:
    """Return the page."""
    every = promises()
    count = ", ".join(f"{sum(one.mark == mark for one in every)} {mark}" for mark in MARKS)
    lines = [f"{len(every)} promises: {count}."]
    lines += ["", "## Safety", *(f"- {one.id}:{one.gap}" for one in every if one.id[0] == "S" and one.gap)]
    for letter, title in PARTS:
        lines += ["", f"## {title}", "| # | promise | shown by |", "|---|---|---|"]
        lines += [one.row for one in every if one.id.startswith(letter)]
    return HEAD + "\n".join([*lines, ""])
