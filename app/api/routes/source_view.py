"""The source of a trial or drive in answers, and the group of trials that a review shows."""

from typing import Annotated, Any

from fastapi import Depends, Query
from pydantic import model_validator

from app.api.deps import SettingsPart
from app.source import Source, SourceGroup, source_description


class SourceView(Source):
    """The source of the signals, with its description."""

    description: str

    @model_validator(mode="before")
    @classmethod
    def _add_description(cls, source: Any) -> Any:
        if isinstance(source, Source) and not isinstance(source, SourceView):
            return {**source.model_dump(), "description": source_description(source)}
        return source


def requested_group(settings: SettingsPart, source: Annotated[SourceGroup | None, Query()] = None) -> SourceGroup:
    """Return the requested group of trials; by default worn ones, in a demonstration simulated ones."""
    if source is not None:
        return source
    return "simulated" if settings.demo else "worn"


RequestedGroup = Annotated[SourceGroup, Depends(requested_group)]
