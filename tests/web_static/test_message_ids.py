"""Each message of the pages can be read by a browser, and is shown; each id that a page asks for has its message."""

import json
import re
from collections.abc import Iterator

import pytest
from web_static.messages import (
    COMPARED,
    LITERAL,
    TEMPLATE,
    WORDS,
    asked_for,
    id_of,
    ids_of,
    ids_of_language,
    is_made_by,
    scripts,
)

from app.api.pages import ALONE, IN_ENTRIES, IN_ENTRY
from app.texts import LANGUAGES
from folders import ROOT

# Of classes without a style, of an event, of an element, and of formats that the server names.
OTHER_NAMES = {"sign-in", "adapt-nothing", "trial-view", "shirt-key", "signal-file"}
CONTROLS = {"u1-plus", "u1-minus", "u2-plus", "u2-minus"}
BY_FILE = ids_of_language()
ALL = set().union(*BY_FILE.values())
SCRIPTS = scripts()


def catalogue_of(script: str) -> str:
    """Return the file whose messages alone a module reads; any other module reads those of all other files."""
    return {"help": "help", "tablet": "tablet", "tablet.js": "tablet"}.get(script.split("/", maxsplit=1)[0], "")


def ids_for(script: str) -> set[str]:
    alone = catalogue_of(script)
    return BY_FILE[alone] if alone else ALL - set().union(*(BY_FILE[name] for name in {*ALONE, IN_ENTRIES}))


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_messages_of_entries_stand_there_and_are_lines_without_values(language):
    entries = "".join(file.read_text() for file in (ROOT / "web_static").glob("*.html"))
    file = WORDS / language / f"{IN_ENTRIES}.ftl"
    assert set(ids_of(file)) | {"language"} == set(IN_ENTRY.findall(entries))
    lines = file.read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if "{" in line or line.startswith(" ")] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_message_can_be_read(run_script, language):
    """A browser leaves out what is no message, without a word."""
    read = json.loads(run_script("texts.mjs", WORDS / language))
    assert {file: set(texts) for file, texts in read.items()} == {
        file.name: set(ids_of(file)) for file in (WORDS / language).glob("*.ftl")
    }


def test_each_language_has_its_own_name_by_which_a_reader_chooses_it():
    assert {f"language-{language}" for language in LANGUAGES} - ALL == set()


class Anything:
    """Every value."""

    def __contains__(self, _):
        return True


def missing_in(name: str) -> Iterator[str]:
    """Yield the ids that a module asks for, and the templates of ids, that no message has."""
    known = ids_for(name)
    for argument in asked_for(SCRIPTS[name]):
        bare = COMPARED.sub("", TEMPLATE.sub("", argument))
        yield from (literal for literal in LITERAL.findall(bare) if literal not in known)
        made = TEMPLATE.findall(argument)
        yield from (each for each in made if not any(is_made_by(each, one, Anything()) for one in known))


def test_every_id_that_a_module_asks_for_has_a_message():
    assert {name: missing for name in SCRIPTS if (missing := list(missing_in(name)))} == {}


def test_the_ids_that_modules_ask_for_are_found():
    asked = [argument for script in SCRIPTS.values() for argument in asked_for(script)]
    assert len(asked) > 1500
    assert len([each for each in asked if TEMPLATE.search(each)]) > 200


def test_what_begins_as_an_id_is_one_or_the_name_of_something_else():
    """An id also stands apart from the call that shows it, as in a list."""
    beginnings = {name.split("-")[0] for name in ALL}
    literals = set().union(*(LITERAL.findall(script) for script in SCRIPTS.values()))
    alike = {each for each in literals if re.fullmatch(r"[a-z]\w*(-\w+)+", each) and each.split("-")[0] in beginnings}
    assert len(alike & ALL) > 1000
    styles = "".join(file.read_text() for file in (ROOT / "web_static" / "css").rglob("*.css"))
    named = set(re.findall(r"[.#]([a-z][\w-]+)", styles)) | OTHER_NAMES
    assert alike - ALL - named == set()


def test_no_message_is_left_over():
    """An id stands in a module, or a template makes it of a word that stands in the program."""
    texts = [file.read_text() for file in (ROOT / "app").rglob("*.py")] + list(SCRIPTS.values())
    words = set().union(*(LITERAL.findall(text) + re.findall(r"\w+", text) for text in texts))
    values = {id_of(word) for word in words} | {id_of(word.lower()) for word in words} | {"", *CONTROLS} | ALL
    named = BY_FILE[IN_ENTRIES].union(*(LITERAL.findall(script) for script in SCRIPTS.values()))
    templates = {each for script in SCRIPTS.values() for each in TEMPLATE.findall(script) if "-" in each}
    left = {name for name in ALL - named if not any(is_made_by(each, name, values) for each in templates)}
    assert left == set()
