"""People read plain words; the symbols of publications stand behind "Details" only."""

import ast
import json
from typing import get_args

from cli.symbols import symbols_in
from web_static.messages import WORDS, id_of, ids_of

from app.calibration.map_grades import SIGNAL_TO_NOISE_LIMITS, SPREAD_LIMITS, repeats_word, signal_word
from app.features.registration import EventKind
from folders import ROOT

# Texts about the picture of a floor plan that a robot has drawn: a ROS map.
FLOOR_PLANS = ("editor.ftl: import", "uploads.ftl")
# Sentences for people come from these; messages on fields of a document name the field as the document does.
SENTENCES = ("app/faults.py", "app/scoring", "app/calibration", "app/session", "app/store", "app/api", "app/source.py")
ROWS_OF_THE_LOG = {"map adapted", "map taken back"}  # they are never changed, so that older rows have the same names
ONLY_IN_EXPORTS = {"Smoothness: logarithmic dimensionless jerk"}
DOCUMENTS = {"profile.py", "vocabulary.py", "prompts_file.py"}


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


def sentences(tree):
    """Yield the texts of a module with more than one word, without docstrings and descriptions of fields."""
    docstrings = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    for node in ast.walk(tree):
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docstrings
        if is_text and " " in node.value.strip():
            yield node.value


def test_no_sentence_that_a_page_shows_has_a_symbol():
    files = [ROOT / place for place in SENTENCES if place.endswith(".py")]
    files += [file for place in SENTENCES for file in (ROOT / place).rglob("*.py") if file.name not in DOCUMENTS]
    found = {}
    for file in files:
        for text in sentences(ast.parse(file.read_text(encoding="utf-8"))):
            if symbols_in(text) and text not in ROWS_OF_THE_LOG | ONLY_IN_EXPORTS:
                found.setdefault(str(file.relative_to(ROOT)), []).append(text)
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
