"""A text for people is one message, in the case in which its language writes it, with numbers as its language does."""

import re

from web_static.messages import scripts

from app.api.pages import LANGUAGE_MODULE
from app.texts import LANGUAGES

FORMATS = "widgets/format.js"
MESSAGES = "words.js"
CALL = re.compile(r"\.(toFixed|toPrecision|toLocale\w+|toLowerCase|toUpperCase)\(|\b(Intl)\.")
# What is no text that people read, and why.
ALLOWED = {
    "editor/document.js": {"toLowerCase"},  # the file name of a plan, made of its title
    "editor/drawing.js": {"toFixed"},  # places in an SVG path
    "editor/form.js": {"toFixed"},  # the value of a field of numbers, and angles of a document
    "editor/geometry.js": {"toFixed"},  # numbers of a document
    "editor/keys.js": {"toLowerCase"},  # the name of a key
    "pages/controls/handle_bar.js": {"toFixed"},  # numbers of a set, and aria-valuenow
    "pages/controls/store.js": {"toFixed"},  # numbers of a set
    "pages/patients/patients.js": {"toLowerCase", "toUpperCase"},  # a search, and the first letter of a pseudonym
    "pages/review/play_bar.js": {"toLowerCase"},  # the name of a key
    "pages/review/replay_view.js": {"toFixed"},  # a number for the server
    "shell/halt.js": {"toLowerCase"},  # the name of a fault, which is the same in every language
    "view/frame_rate.js": {"toFixed"},  # a number for the server
    "widgets/setting.js": {"toFixed"},  # a number that is rounded, not shown
    "widgets/joint_words.js": {"toLowerCase"},  # the label of a layout, compared with the name of its joint
    "widgets/movement.js": {"toFixed"},  # numbers for the server
}
SCRIPTS = scripts()
T = r"(?<![\w.])t\((?:[^()]|\([^()]*\))*\)"
ADDED = re.compile(rf"\+ {T}|{T} \+ |{T}\.(?:replace|split|charAt)")


def calls(script: str) -> set[str]:
    return {method or namespace for method, namespace in CALL.findall(script)}


def test_numbers_are_written_by_one_module_and_no_text_changes_its_case() -> None:
    found = {name: calls(script) for name, script in SCRIPTS.items() if name != FORMATS}
    assert {name: names for name, names in found.items() if names} == ALLOWED


def test_no_text_is_added_to_another_or_cut() -> None:
    found = {name: ADDED.findall(script) for name, script in SCRIPTS.items() if name != MESSAGES}
    assert {name: places for name, places in found.items() if places} == {}


def test_no_module_names_a_language() -> None:
    alone = {LANGUAGE_MODULE.removeprefix("js/"), FORMATS}
    language = re.compile(rf'"(?:{"|".join(LANGUAGES)})(?:-[A-Z]{{2}})?"')
    assert [name for name, script in SCRIPTS.items() if name not in alone and language.search(script)] == []


def test_the_rules_see_what_they_refuse() -> None:
    script = 't("a").toLowerCase() + value.toFixed(1) + new Intl.NumberFormat()'
    assert calls(script) == {"toLowerCase", "toFixed", "Intl"}
    for text in ('x + t("a")', 't("a", { b: c(d) }) + x', 't("a").charAt(0)'):
        assert ADDED.search(text)
