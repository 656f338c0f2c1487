"""The style sheets say each thing once: a selector stands once in a file, and a custom property is used."""

import re
from collections import Counter
from pathlib import Path

import pytest

from app.settings import static_folder

SHEETS = sorted((static_folder() / "css").rglob("*.css"))
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


def blocks(text: str) -> list[str]:
    """Return the selectors of a style sheet, each after the at-rules around it, in the order of their blocks."""
    heads: list[str] = []
    found: list[str] = []
    for part in re.findall(r"[^{};]*[{};]", COMMENT.sub("", text)):
        if part.endswith("{"):
            heads.append(" ".join(part[:-1].split()))
            found.append(" / ".join(heads))
        elif part.endswith("}"):
            heads.pop()
    assert heads == []
    return found


def test_blocks_are_found_below_their_at_rules() -> None:
    text = "/* a { */ a {\n color: red; }\nb, c { }\n@media (x) {\n a { color: blue }\n a { top: 0; }\n}"
    assert blocks(text) == ["a", "b, c", "@media (x)", "@media (x) / a", "@media (x) / a"]


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: sheet.stem)
def test_a_selector_stands_once_in_a_sheet(sheet: Path) -> None:
    # A block of @media stands beside what it changes, so that one condition may stand several times in a sheet.
    selectors = [each for each in blocks(sheet.read_text()) if not each.rpartition(" / ")[2].startswith("@")]
    assert selectors
    assert [each for each, times in Counter(selectors).items() if times > 1] == []


def test_a_custom_property_that_is_set_is_used() -> None:
    files = [*SHEETS, *(static_folder() / "js").rglob("*.js")]
    text = "\n".join(COMMENT.sub("", file.read_text()) for file in files)
    is_set = set(re.findall(r"^ *(--[a-z0-9-]+):", "\n".join(sheet.read_text() for sheet in SHEETS), re.MULTILINE))
    assert len(is_set) > 20
    unused = {name for name in is_set if not re.search(rf"{name}(?![\w-])(?!:)", text)}
    assert unused == set()
