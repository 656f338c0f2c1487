"""A text in a stored document: its id with its values, checked as a document of anybody is; or a string of before."""

from typing import Annotated, TypeAlias, Union

from pydantic import BeforeValidator, ConfigDict, Field, PlainSerializer

from app.json_values import JsonDocument
from app.quantities import Document, Finite
from app.texts import Text, from_document, to_document

ValueName = Annotated[str, Field(max_length=80, pattern=r"^[a-z][a-z0-9_]*$")]
MessageId = Annotated[str, Field(max_length=80, pattern=r"^[a-z][a-z0-9]*(-[a-z0-9]+)*$")]


class FigureDocument(Document):
    """A number with a fixed count of decimals."""

    number: Finite
    digits: Annotated[int, Field(strict=True, ge=0, le=20)]


Number = Annotated[int, Field(ge=-(2**31), le=2**31)]
Item: TypeAlias = Union[Annotated[str, Field(max_length=2000)], Number, Finite, FigureDocument, "TextDocument"]


class TextDocument(Document):
    """A text as `app.texts.to_document` writes it: the id of its message, and its values by name."""

    model_config = ConfigDict(strict=True)

    text: MessageId
    values: dict[ValueName, Item | list[Item]]


def _text(document: object) -> object:
    return from_document(TextDocument.model_validate(document).model_dump()) if isinstance(document, dict) else document


StoredText = Annotated[Text, BeforeValidator(_text), PlainSerializer(to_document, return_type=str | JsonDocument)]
"""The type of a field that holds a text and is stored."""
