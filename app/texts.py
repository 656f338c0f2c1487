"""Texts for people: an id with values, and its sentence in Fluent (projectfluent.org) in the reader's language.

The sentences stand in web_static/words/LANGUAGE/, those that only the server shows in its folder server/. The program
passes and stores ids with values; the sentence is made where somebody reads it.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from datetime import date, datetime, time
from functools import reduce
from typing import Any, ClassVar, Final, NamedTuple, Union

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, SchemaSerializer, core_schema

ENGLISH: Final = "en"
LANGUAGES: Final = (ENGLISH, "es", "de")  # that a person can choose

_language: ContextVar[str] = ContextVar("language", default=ENGLISH)


class Figure(NamedTuple):
    """A number with a fixed count of decimals; its point or comma is that of the language."""

    number: float
    digits: int = 0


Value = Union[str, int, float, Figure, date, datetime, time, "Text", Exception, Sequence["Value"]]
"""A value of a text. A list becomes "a, b and c"; an exception stands for the text that it was raised with.

A `datetime` is shown as the day and the time of day in this computer's time zone, one without a time zone as it is.
"""
MOMENTS: Final = {kind.__name__: kind for kind in (date, datetime, time)}


class Text:
    """A sentence or a name for people: its id in the catalogue, and the values that stand in it.

    `str(text)` is the sentence in the language of the reader (`reader_language`).
    """

    __slots__ = ("id", "values")
    __pydantic_serializer__: ClassVar = SchemaSerializer(
        core_schema.any_schema(serialization=core_schema.to_string_ser_schema())
    )
    """In a field of any type, too, it is sent as a sentence."""

    def __init__(self, id: str, /, **values: Value) -> None:  # noqa: A002
        self.id = id
        self.values: Mapping[str, Value] = {name: _kept(value) for name, value in values.items()}

    def __str__(self) -> str:
        from app import fluent_catalogue as catalogue  # noqa: PLC0415  # the control process never gets here

        language = _language.get()
        values = {name: _shown(value, language) for name, value in self.values.items()}
        return catalogue.sentence(language, self.id, values)

    def __repr__(self) -> str:
        return f"Text({self.id!r}, {self.values!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Text) and (self.id, self.values) == (other.id, other.values)

    def __hash__(self) -> int:
        return hash(self.id)

    def __reduce__(self) -> tuple[object, ...]:
        return _remade, (self.id, dict(self.values))

    @classmethod
    def __get_pydantic_core_schema__(cls, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return the schema of a field: given as a text, or as a plain string such as a name; sent as a sentence."""
        return core_schema.union_schema(
            [core_schema.is_instance_schema(cls), core_schema.str_schema()],
            mode="left_to_right",
            serialization=core_schema.to_string_ser_schema(),
        )

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: Any) -> dict[str, str]:
        """Return what it is in JSON."""
        return {"type": "string"}


def value_text(value: Value) -> str:
    """Return a value as it stands in a sentence in the language of the reader, for a cell of a table."""
    return _written(value, _language.get())


def text_of(error: Exception) -> Text | str:
    """Return the text that an exception was raised with, its message when it was raised with a string."""
    first = error.args[0] if len(error.args) == 1 else None
    return first if isinstance(first, Text) else str(error)


def in_sequence(sentences: Iterable[Text]) -> Text:
    """Return sentences, of which there is at least one, one after the other as one text."""
    return reduce(lambda before, after: Text("text-sequence", before=before, after=after), sentences)


def to_document(text: Text | str) -> Any:
    """Return a text as JSON that can be stored and is shown later in any language; a string is kept as it is."""
    if isinstance(text, str):
        return text
    return {"text": text.id, "values": {name: _value_document(value) for name, value in text.values.items()}}


def from_document(document: Any) -> Text | str:
    """Return the text that `to_document` made JSON of."""
    if isinstance(document, str):
        return document
    return Text(document["text"], **{name: _value_of(value) for name, value in document["values"].items()})


def load_language(language: str = ENGLISH) -> None:
    """Read the messages of a language before the first sentence would have to wait."""
    from app import fluent_catalogue as catalogue  # noqa: PLC0415  # the control process never gets here

    catalogue.load(language)


def current_language() -> str:
    """Return the language in which sentences are made now."""
    return _language.get()


@contextmanager
def reader_language(language: str) -> Iterator[None]:
    """Make sentences in this language, one of LANGUAGES, within the block and what it calls."""
    token = _language.set(language)
    try:
        yield
    finally:
        _language.reset(token)


def _kept(value: Value) -> Value:
    if isinstance(value, Exception):
        return text_of(value)
    if isinstance(value, str | int | float | Figure | date | time | Text):
        return value
    return tuple(_kept(item) for item in value)


def _remade(id: str, values: dict[str, Value]) -> Text:  # noqa: A002
    return Text(id, **values)


def _value_document(value: Value) -> Any:
    if isinstance(value, Text):
        return to_document(value)
    if isinstance(value, Figure):
        return {"number": value.number, "digits": value.digits}
    if isinstance(value, date | time):
        return {type(value).__name__: value.isoformat()}
    if isinstance(value, str | int | float):
        return value
    assert not isinstance(value, Exception)  # a text has none
    return [_value_document(item) for item in value]


def _value_of(document: Any) -> Value:
    if isinstance(document, list):
        return tuple(_value_of(item) for item in document)
    if isinstance(document, dict):
        for kind in MOMENTS.keys() & document.keys():
            return MOMENTS[kind].fromisoformat(document[kind])
        return from_document(document) if "text" in document else Figure(**document)
    value: str | int | float = document
    return value


def _shown(value: Value, language: str) -> Any:
    """Return a value as it stands in the sentence."""
    from app import fluent_catalogue as catalogue  # noqa: PLC0415  # the control process never gets here

    if isinstance(value, Figure):
        return catalogue.figure(language, value.number, value.digits)
    if isinstance(value, str | Text | Exception):
        return str(value)
    if isinstance(value, int | float):
        return catalogue.number(value)
    if isinstance(value, date | time):
        return catalogue.moment(language, value)
    return catalogue.joined(language, [_written(item, language) for item in value])


def _written(value: Value, language: str) -> str:
    """Return a value as it stands in the sentence, a number as well."""
    from app import fluent_catalogue as catalogue  # noqa: PLC0415  # the control process never gets here

    return catalogue.written(language, _shown(value, language))
