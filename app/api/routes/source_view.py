"""The source of a trial or drive, as every answer shows it, and which trials a review looks at."""

from typing import Annotated, Any

from fastapi import Depends, Query
from pydantic import model_validator

from app.api.deps import PeopleParts
from app.source import Source, SourceGroup, source_words


class SourceView(Source):
    """Where the signals came from, with the words for it."""

    words: str

    @model_validator(mode="before")
    @classmethod
    def _add_words(cls, source: Any) -> Any:
        if isinstance(source, Source) and not isinstance(source, SourceView):
            return {**source.model_dump(), "words": source_words(source)}
        return source


def requested_group(parts: PeopleParts, source: Annotated[SourceGroup | None, Query()] = None) -> SourceGroup:
    """Return the group of trials that is asked for: worn ones when none is named, in a demonstration simulated ones."""
    if source is not None:
        return source
    return "simulated" if parts.settings.demo else "worn"


RequestedGroup = Annotated[SourceGroup, Depends(requested_group)]
