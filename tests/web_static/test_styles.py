"""The style sheets say each thing once: a selector stands once in a file, and a custom property is used.

Layouts change at few widths.

Where one reads from right to left, a page is the same in a mirror: no style names left or right where it means the
side at which a line begins or ends.
"""

import re
from collections import Counter
from collections.abc import Iterator

from app.settings import static_folder

SHEETS = sorted((static_folder() / "css").rglob("*.css"))
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
ROW = re.compile(r"^   (\d+)px  ", re.MULTILINE)  # of the table of widths in tokens.css
WIDTH = re.compile(r"\((min|max)-width: ?(\d+)px\)")  # in a media query

# What stays where it is in each language: a reason, and its selectors by sheet ("": all of that sheet).
PHYSICAL = {
    "it lies over a picture or a drawn plan, in which left is left": {
        "editor/editor.css": [".views"],
        "pages/drive.css": [".place", ".page.filled .pace"],
        "patient.css": [".patient .corner", ".patient .arrow"],
        "plan/mini_plan.css": [".mini"],
        "view/view_settings.css": [".view-settings"],
    },
    "it is a scale, or stands on one: as in charts, time and measures go from left to right": {
        "charts/time_chart.css": [".cursor"],
        "pages/calibrate.css": [".evr > span"],
        "pages/chair.css": [".level-bar .fill", ".level-bar .mark"],
        "pages/controls.css": [".handles .live", ".handles .peak", ".handle", ".handle::after"],
        "pages/drive.css": [".leader-bar i"],
        "pages/review.css": [".comment-marks i", ".event-marks i"],
    },
    "it is the picture of the left or of the right eye": {"stereo.css": [""]},
}
SIDE = re.compile(r"left|right|(?:margin|padding|border|scroll-margin|scroll-padding)-(?:\w+-)?(?:left|right)(?:-\w+)*")
TO_A_SIDE = re.compile(r"(?:text-align|float|clear|transition): .*\b(?:left|right)\b")
FOUR_SIDES = re.compile(r"(?:margin|padding|inset|border-(?:width|style|color)|scroll-margin|scroll-padding)")
IN_THE_MIDDLE = {"left: 50%", "transform: translateX(-50%)"}
VALUE = re.compile(r"(?:[^\s()]|\((?:[^()]|\([^()]*\))*\))+")  # of several, one; brackets may hold brackets


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


def declarations(text: str) -> Iterator[tuple[str, list[str]]]:
    """Yield the selector of each block without its at-rules, and what stands in the block itself."""
    heads: list[tuple[str, list[str]]] = []
    for part in re.findall(r"[^{};]*[{};]", COMMENT.sub("", text)):
        words = " ".join(part[:-1].split())
        if part.endswith("{"):
            heads.append((words, []))
        elif words:
            heads[-1][1].append(words)
        if part.endswith("}"):
            yield heads.pop()


def names_a_side(declaration: str) -> bool:
    """Return whether left and right differ by a declaration."""
    name, _, text = declaration.partition(": ")
    if SIDE.fullmatch(name) or TO_A_SIDE.match(declaration):
        return True
    values = VALUE.findall(text.removesuffix("!important"))
    if name == "border-radius":  # top left, top right, bottom right, bottom left
        return len(values) in (2, 3) or (len(values) == 4 and (values[0] != values[1] or values[2] != values[3]))
    return FOUR_SIDES.fullmatch(name) is not None and len(values) == 4 and values[1] != values[3]


def physical(text: str) -> Iterator[tuple[str, str]]:
    """Yield what names left or right in a style sheet, after its selector; the middle is the same from both sides."""
    for selector, stated in declarations(text):
        for each in stated:
            if names_a_side(each) and not (each in IN_THE_MIDDLE and set(stated) >= IN_THE_MIDDLE):
                yield selector, each


def test_blocks_are_found_below_their_at_rules() -> None:
    text = "/* a { */ a {\n color: red; }\nb, c { }\n@media (x) {\n a { color: blue }\n a { top: 0; }\n}"
    assert blocks(text) == ["a", "b, c", "@media (x)", "@media (x) / a", "@media (x) / a"]


def test_a_selector_stands_once_in_a_sheet() -> None:
    # A block of @media stands beside what it changes, so that one condition may stand several times in a sheet.
    for sheet in SHEETS:
        selectors = [each for each in blocks(sheet.read_text()) if not each.rpartition(" / ")[2].startswith("@")]
        assert selectors, sheet
        assert [each for each, times in Counter(selectors).items() if times > 1] == [], sheet


def test_a_layout_changes_at_the_widths_of_the_table_only() -> None:
    table = {int(width) for width in ROW.findall((static_folder() / "css" / "tokens.css").read_text())}
    used: set[int] = set()
    for file in [*SHEETS, *(static_folder() / "js").rglob("*.js")]:
        for end, width in WIDTH.findall(COMMENT.sub("", file.read_text())):
            rows = table & {int(width), int(width) - (end == "min")}
            assert rows, (file.name, width)
            used |= rows
    assert table == used  # no row without need


def test_a_custom_property_that_is_set_is_used() -> None:
    files = [*SHEETS, *(static_folder() / "js").rglob("*.js")]
    text = "\n".join(COMMENT.sub("", file.read_text()) for file in files)
    is_set = set(re.findall(r"^ *(--[a-z0-9-]+):", "\n".join(sheet.read_text() for sheet in SHEETS), re.MULTILINE))
    assert len(is_set) > 20
    unused = {name for name in is_set if not re.search(rf"{name}(?![\w-])(?!:)", text)}
    assert unused == set()


def test_what_names_left_or_right_is_found() -> None:
    text = (
        "a { left: 0; padding: 1px 2px 3px; margin: 0 calc(1px + (2px)) 0 0; }"
        "@media (x) { b { border-left-color: red; text-align: right !important; inset: 0 auto; left: 50% } }"
        "c { border-radius: 8px 0 0 8px; left: 50%; transform: translateX(-50%); border-radius: 4px 4px 0 0; }"
        "d { transition: left 1s; margin: 0 1px 0 1px; inset-inline-start: 0; text-align: start }"
    )
    assert list(physical(text)) == [
        *(("a", "left: 0"), ("a", "margin: 0 calc(1px + (2px)) 0 0")),
        *(("b", "border-left-color: red"), ("b", "text-align: right !important"), ("b", "left: 50%")),
        *(("c", "border-radius: 8px 0 0 8px"), ("d", "transition: left 1s")),
    ]


def test_no_style_names_left_or_right_where_it_means_the_side_at_which_a_line_begins() -> None:
    for sheet in SHEETS:
        name = sheet.relative_to(static_folder() / "css").as_posix()
        stays = {selector for sheets in PHYSICAL.values() for selector in sheets.get(name, [])}
        found = list(physical(sheet.read_text()))
        assert [each for each in found if each[0] not in stays and "" not in stays] == [], name
        assert stays <= {selector for selector, _ in found} | {""}, name  # else: an exception that is none
