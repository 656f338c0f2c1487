"""People read plain words; the symbols of publications stand behind "Details" only."""

import json
import re
from typing import get_args

from cli.symbols import symbols_in
from fluent.syntax import ast as fluent
from web_static.messages import WORDS, id_of, ids_of

from app.calibration.map_grades import SIGNAL_TO_NOISE_LIMITS, SPREAD_LIMITS, repeats_word, signal_word
from app.features.registration import EventKind
from words import entries_of

# Texts about the picture of a floor plan that a robot has drawn: a ROS map.
FLOOR_PLANS = ("editor.ftl: import", "uploads.ftl")
# Of the server: for the command line and studies, on fields of a document as it names them, on maps of robots.
NOT_ON_PAGES = {"command_help.ftl", "command_line.ftl", "study.ftl", "calibration_files.ftl", "plans.ftl"}
ALLOWED = {"measure-ldlj-definition": "only in exports", "api-map-picture-alone": "on a map of a robot"}
NAMES_OF_VALUES = re.compile(r"\$\w+|\[\w+\]|\{ *[a-z][\w-]* *\}")  # and of other messages


def read_texts(run_script):
    """Return every text of the pages by its file and id."""
    read = json.loads(run_script("texts.mjs", WORDS / "en"))
    return {f"{file}: {name}": text for file, texts in read.items() for name, text in texts.items()}


def test_no_text_of_the_pages_has_a_symbol(run_script):
    texts = read_texts(run_script)
    assert len(texts) > 2000
    shown = {key: text for key, text in texts.items() if "details" not in key and not key.startswith(FLOOR_PLANS)}
    assert {key: text for key, text in shown.items() if symbols_in(text)} == {}


def test_a_label_holds_the_words_that_it_replaces(run_script):
    """Who presses a button by voice says what is written on it."""
    texts = read_texts(run_script)
    labels = {key.removesuffix("-label"): text for key, text in texts.items() if key.endswith("-label")}
    replaced = {key: (texts[key], label) for key, label in labels.items() if key in texts}
    assert len(replaced) > 20
    assert {key: both for key, both in replaced.items() if both[0].lower() not in both[1].lower()} == {}


def test_no_sentence_of_the_server_that_a_page_shows_has_a_symbol():
    found = {}
    for file in sorted((WORDS / "en" / "server").glob("*.ftl")):
        text = file.read_text(encoding="utf-8")
        for entry in entries_of(text):
            if isinstance(entry, fluent.Message) and file.name not in NOT_ON_PAGES:
                symbols = symbols_in(NAMES_OF_VALUES.sub("", text[entry.value.span.start : entry.value.span.end]))
                if symbols and entry.id.name not in ALLOWED:
                    found[file.name, entry.id.name] = symbols
    assert found == {}


NEAR = 1e-6


def test_the_pages_and_the_server_have_the_same_words(answered, reference_file):
    signals = [value for limit in SIGNAL_TO_NOISE_LIMITS for value in (limit - NEAR, limit, limit + NEAR)]
    spreads = [value for limit in SPREAD_LIMITS for value in (limit - NEAR, limit, limit + NEAR)]
    words = answered("grade_words.mjs", {"signals": signals, "spreads": spreads}, reference_file)
    assert words == [[str(signal_word(value)) for value in signals], [str(repeats_word(value)) for value in spreads]]


def test_each_kind_of_event_has_its_text() -> None:
    found = {name for name in ids_of(WORDS / "en" / "share.ftl") if name.startswith("share-event-")}
    assert found == {f"share-event-{id_of(kind)}" for kind in get_args(EventKind)}
