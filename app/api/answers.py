"""Answers that are filled from a row of the database or an object by the names of their fields."""

from datetime import datetime
from typing import Annotated, Any, Self

from pydantic import BeforeValidator, ConfigDict

from app.quantities import Document


def _text_of(moment: Any) -> Any:
    return moment.isoformat() if isinstance(moment, datetime) else moment


MomentText = Annotated[str, BeforeValidator(_text_of)]
"""A date and time in ISO 8601, filled from a datetime."""


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
