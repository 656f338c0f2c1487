"""Each rule of a style sheet has elements and stands in the sheet of what it styles; tokens.css has the values.

A sheet in `css/pages/` has the name of a folder in `js/pages/`, and each of its selectors names a class of this page
alone. What several pages share stands in the sheet of a widget, or in base.css.
"""

import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest
from web_static.test_styles import COMMENT, SHEETS, declarations

from app.settings import static_folder

STYLES, SCRIPTS = static_folder() / "css", static_folder() / "js"
TOKENS = STYLES / "tokens.css"
PAGES = sorted((STYLES / "pages").glob("*.css"))
APART = {  # load no page
    *("docs.js", "patient", "patient.js", "phone", "phone.js"),
    *("share.js", "stereo", "stereo.js", "tablet", "tablet.js"),
}

COMMENT_LINE = re.compile(r"^ *(?://|/?\*).*$", re.MULTILINE)
STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|`(?:[^`\\]|\\.)*`', re.DOTALL)
SAYS_CLASSES = re.compile(  # of an element: `class: …`, `className = …`, `classList.toggle(…)`
    rf"(?:\bclass: |\bclass=|\.className \+?= |\.classList\.\w+\()((?:[^,;(){{}}\"'`]|{STRING.pattern}|\([^()]*\))*)",
    re.DOTALL,
)
NAME = re.compile(r"(?<![\w-])[a-zA-Z_][\w-]*")
CLASS = re.compile(r"\.([a-zA-Z_][\w-]*)")
COMMA = re.compile(r",\s*(?![^()]*\))")  # between selectors
STEP = re.compile(r"from|to|\d+%")  # of an animation
COLOUR = re.compile(
    r"(?<![\w-])(?:#[0-9a-f]{3,8}|(?:rgba?|hsla?|hwb|lab|lch|oklab|oklch|color)\("
    r"|(?:aqua|black|blue|brown|cyan|fuchsia|gr[ae]y|green|lime|magenta|maroon|navy|olive|orange|pink|purple|red|silver"
    r"|teal|white|yellow)(?![\w-]))",
    re.IGNORECASE,
)
TOKEN = re.compile(r"^ *(--[\w-]+): ([^;]+);", re.MULTILINE)
NUMBER = re.compile(r"(?<![\w.])\d*\.?\d+(?:px|rem)?(?![\w.%])")
# Properties whose values are tokens where tokens.css has a value for them, by how these begin.
WITH_TOKENS = {
    "--space-": re.compile(r"(?:padding|margin)(?:-[a-z]+)*|(?:row-|column-)?gap"),
    "--radius": re.compile(r"border-radius"),
    "--size-": re.compile(r"font(?:-size)?"),
    "--layer-": re.compile(r"z-index"),
}

# Classes that a module makes of parts, or that others' code gives.
MADE = {
    **dict.fromkeys(("is-armed", "is-contact", "is-fault", "is-goal", "is-stop"), "`is-${kind}` of review/play_bar.js"),
    **dict.fromkeys(("grass", "sand"), "`ground ${plan.ground.kind}` of plan/plan_svg.js"),
    **dict.fromkeys(("u-axis", "u-over", "u-under", "u-wrap"), "uPlot's own elements"),
}
# Classes with a style in the sheet of a page that other modules use for something else.
OF_TWO_THINGS = {
    "attention": "the list of Patients to look after; a sentence of Adapt that warns",
    "handle": "a limit of a control; a corner in the editor",
    "ring": "where a limb has its sensors, in Calibrate; a circle in another picture",
    "sensor": "a lamp on the figure of the shirt; a place in the ring of a limb",
}


def owner(script: Path) -> str:
    """Return the page, the other folder, or the file itself that a module belongs to."""
    parts = script.relative_to(SCRIPTS).parts
    return "/".join(parts[: 2 if parts[0] == "pages" else 1])


def names(text: str) -> set[str]:
    """Return what may be a class in the strings of a text."""
    return {name for string in STRING.findall(text) for name in NAME.findall(string)}


def names_by_owner() -> tuple[dict[str, set[str]], dict[str, set[str]]]:
    """Return the names in all strings of each owner, and those that its elements surely have as classes."""
    in_strings: dict[str, set[str]] = defaultdict(set)
    as_classes: dict[str, set[str]] = defaultdict(set)
    for script in SCRIPTS.rglob("*.js"):
        text = COMMENT_LINE.sub("", script.read_text())
        in_strings[owner(script)] |= names(text)
        for said in SAYS_CLASSES.findall(text):
            as_classes[owner(script)] |= names(said)
    return in_strings, as_classes


IN_STRINGS, AS_CLASSES = names_by_owner()


def selectors(sheet: Path) -> Iterator[str]:
    """Yield each selector of a sheet, without the values of attributes."""
    for head, _ in declarations(sheet.read_text()):
        if not head.startswith("@"):
            yield from (one for one in COMMA.split(re.sub(r'"[^"]*"', '""', head)) if not STEP.fullmatch(one))


def of_others(sheet: Path) -> list[str]:
    """Return the selectors in the sheet of a page that name no class of this page alone."""
    page = f"pages/{sheet.stem}"
    others = set().union(*(found for name, found in AS_CLASSES.items() if name not in APART and name != page))
    alone = (IN_STRINGS[page] | MADE.keys()) - others
    return [one for one in selectors(sheet) if not alone.intersection(CLASS.findall(one))]


def test_classes_are_found_in_what_a_module_says() -> None:
    text = 'h("p", { class: is ? "a b" : `c-${kind}`, id: "d" }); x.classList.toggle("e", has("f")); x.className = "g";'
    assert set().union(*(names(said) for said in SAYS_CLASSES.findall(text))) == {"a", "b", "c-", "kind", "e", "g"}
    assert len(IN_STRINGS["pages/review"]) > 100
    assert len(AS_CLASSES["pages/review"]) > 50


def test_each_sheet_is_loaded() -> None:
    files = [*static_folder().glob("*.html"), *SCRIPTS.rglob("*.js")]
    text = "\n".join(file.read_text() for file in files)
    assert [sheet.name for sheet in SHEETS if f'"css/{sheet.relative_to(STYLES).as_posix()}"' not in text] == []


def test_a_class_of_a_style_is_one_of_an_element() -> None:
    entries = "".join(file.read_text() for file in static_folder().glob("*.html"))
    used = set().union(names(" ".join(re.findall(r'class="[^"]*"', entries))), *IN_STRINGS.values())
    classes = {(sheet.name, name) for sheet in SHEETS for one in selectors(sheet) for name in CLASS.findall(one)}
    assert {(sheet, name) for sheet, name in classes if name not in used | MADE.keys()} == set()


def test_a_class_that_is_made_has_a_style_and_stands_nowhere_else() -> None:
    classes = {name for sheet in SHEETS for selector in selectors(sheet) for name in CLASS.findall(selector)}
    assert MADE.keys() - classes == set()
    assert MADE.keys() & set().union(*IN_STRINGS.values()) == set()


@pytest.mark.parametrize("sheet", PAGES, ids=lambda sheet: sheet.stem)
def test_a_sheet_of_a_page_styles_what_this_page_alone_has(sheet: Path) -> None:
    assert (SCRIPTS / "pages" / sheet.stem).is_dir()
    assert [one for one in of_others(sheet) if not OF_TWO_THINGS.keys() & set(CLASS.findall(one))] == []


def test_a_class_of_two_things_is_one() -> None:
    found = {name for sheet in PAGES for selector in of_others(sheet) for name in CLASS.findall(selector)}
    assert OF_TWO_THINGS.keys() - found == set()


def test_colours_are_found() -> None:
    found = ("#fff", "0 1px #0004", "rgb(0 0 0)", "1px solid Red", "white")
    others = ("var(--red)", "var(--white-line)", "transparent", "currentColor", "CanvasText")
    mixed = "color-mix(in srgb, var(--red) 40%, transparent)"
    assert [each for each in (*found, *others, mixed) if COLOUR.search(each)] == [*found]


def stated_elsewhere() -> Iterator[tuple[str, str]]:
    """Yield the name of each sheet but that of the tokens, with each of its declarations."""
    for sheet in SHEETS:
        if sheet != TOKENS:
            yield from ((sheet.name, each) for _, block in declarations(sheet.read_text()) for each in block)


def test_a_colour_stands_in_the_tokens_alone() -> None:
    assert [(sheet, each) for sheet, each in stated_elsewhere() if COLOUR.search(each.partition(": ")[2])] == []


def test_a_value_that_has_a_token_is_written_as_the_token() -> None:
    tokens = TOKEN.findall(COMMENT.sub("", TOKENS.read_text()))
    stated = list(stated_elsewhere())
    again = []
    for kind, properties in WITH_TOKENS.items():
        values = {value for name, value in tokens if name.startswith(kind)}
        assert values
        for sheet, each in stated:
            name, _, value = each.partition(": ")
            if properties.fullmatch(name) and values.intersection(NUMBER.findall(value)):
                again.append((sheet, each))
    assert again == []
