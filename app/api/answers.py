"""Answers that are filled from a row of the database or an object by the names of their fields."""

from datetime import datetime
from typing import Annotated, Any, Self

from pydantic import BeforeValidator, ConfigDict

from app.quantities import Document
from app.texts import Text


def _text_of(moment: Any) -> Any:
    return moment.isoformat() if isinstance(moment, datetime) else moment


def _sentence_of(text: Text | str | None) -> str:
    return "" if text is None else str(text)


MomentText = Annotated[str, BeforeValidator(_text_of)]
"""A date and time in ISO 8601, filled from a datetime."""

Sentence = Annotated[str, BeforeValidator(_sentence_of)]
"""A sentence, empty where there is none, filled from a text or None."""


class Answer(Document):
    """Base of such answers."""

    model_config = ConfigDict(from_attributes=True)

    @classmethod
    def of(cls, source: object) -> Self:
        """Return the answer with the values that `source` has under the names of the fields."""
        return cls.model_validate(source)


class OriginView(Answer):
    """The clinic that a session was held in, and who imported it when."""

    clinic: str
    person: str
    at: MomentText
