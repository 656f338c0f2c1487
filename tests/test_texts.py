"""Texts: the sentence of an id in the reader's language, and what is kept of it."""

import pickle
from datetime import UTC, date, datetime, time
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import BaseModel

from app.texts import (
    LANGUAGES,
    Figure,
    Text,
    from_document,
    in_sequence,
    reader_language,
    text_of,
    to_document,
    value_text,
)

PATH = Text("drive-no-path", path="Corridor")
IN_ENGLISH = "This floor plan has no path “Corridor” any more: choose another task."
VALUES = st.recursive(
    st.text()
    | st.integers()
    | st.floats(allow_nan=False)
    | st.builds(Figure, st.floats(-1e6, 1e6), st.integers(0, 6))
    | st.dates()
    | st.datetimes(timezones=st.just(UTC))
    | st.times(),
    lambda inner: st.lists(inner).map(tuple) | st.builds(lambda value: Text("any", value=value), inner),
    max_leaves=8,
)


class Answer(BaseModel):
    message: Text
    name: Text | None = None


class AnyAnswer(BaseModel):
    facts: dict[str, Any]


def test_a_sentence_is_in_the_language_of_the_reader():
    assert str(PATH) == IN_ENGLISH
    with reader_language("es"):
        assert str(PATH) == "Este plano ya no tiene el recorrido “Corridor”: elija otra tarea."
    assert f"{PATH}" == IN_ENGLISH


@pytest.mark.parametrize(
    ("value", "english", "german"),
    [
        (Figure(-3.456, 2), "−3.46", "−3,46"),
        (Figure(-0.001, 1), "0.0", "0,0"),
        (Figure(12345.0), "12345", "12345"),
        (["a", "b", "c"], "a, b and c", "a, b und c"),
        ([Text("drive-title"), Figure(1.5, 1)], "Where to? and 1.5", "Wohin? und 1,5"),
        (ValueError(Text("drive-title")), "Where to?", "Wohin?"),
        (1200.5, "1200.5", "1200,5"),
        ([46.0, 0.25], "46 and 0.25", "46 und 0,25"),
        (date(2026, 11, 9), "2026-11-09", "09.11.2026"),
        (time(9, 5), "09:05", "09:05"),
        (datetime(2026, 11, 9, 14, 5).astimezone(), "2026-11-09 14:05", "09.11.2026 14:05"),
        (datetime.fromisoformat("2026-03-29 02:30"), "2026-03-29 02:30", "29.03.2026 02:30"),  # no hour of Berlin
        ("x" * 3000, "x" * 3000, "x" * 3000),
        (2 * 10**9, "2000000000", "2000000000"),
        (1e300, f"1{300 * '0'}", f"1{300 * '0'}"),
    ],
)
def test_a_value_is_written_as_its_language_does(value, english, german):
    text = Text("drive-no-path", path=value)
    assert f"“{english}”" in str(text)
    assert value_text(value) == english
    with reader_language("de"):
        assert german in str(text)
        assert value_text(value) == german


def test_a_number_chooses_the_plural():
    assert str(Text("drive-screens-bad", count=1)) != str(Text("drive-screens-bad", count=2))


def test_an_exception_keeps_its_text():
    error = ValueError(PATH)
    assert (str(error), text_of(error), text_of(ValueError("plain"))) == (IN_ENGLISH, PATH, "plain")
    assert text_of(OSError(2, "No such file")) == "[Errno 2] No such file"
    assert text_of(pickle.loads(pickle.dumps(error))) == PATH


def test_a_field_is_a_string_in_json():
    assert Answer(message=PATH).model_dump_json() == f'{{"message":"{IN_ENGLISH}","name":null}}'
    assert Answer(message=PATH, name="Right wrist").model_dump(mode="json")["name"] == "Right wrist"
    assert Answer.model_json_schema()["properties"]["message"] == {"title": "Message", "type": "string"}


def test_in_a_field_of_any_type_it_is_a_string_in_json():
    assert AnyAnswer(facts={"first": [PATH]}).model_dump_json() == f'{{"facts":{{"first":["{IN_ENGLISH}"]}}}}'


def test_sentences_follow_one_another():
    sentences = [Text("drive-title"), PATH, Text("drive-title")]
    assert str(in_sequence(sentences)) == f"Where to? {IN_ENGLISH} Where to?"
    assert in_sequence([PATH]) == PATH


@given(VALUES)
def test_what_is_stored_is_the_same_text_afterwards(value):
    text = Text("any", value=value, text="also the name of a value")
    assert from_document(to_document(text)) == text
    assert pickle.loads(pickle.dumps(text)) == text


@given(VALUES, st.sampled_from(LANGUAGES))
def test_every_value_can_be_shown(value, language):
    with reader_language(language):
        assert str(Text("drive-no-path", path=value)) != "drive-no-path"


def test_a_text_without_a_message_shows_its_id():
    assert str(Text("no-such-message")) == "no-such-message"
