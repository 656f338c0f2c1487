"""The source of a trial or drive in answers, and the group of trials that a review shows."""

from typing import Annotated, Any

from fastapi import Depends, Query
from pydantic import model_validator

from app.api.deps import EquipmentPart, SettingsPart
from app.quantities import Document
from app.source import Source, SourceGroup, source_description


class SourceView(Document):
    """The source of the signals (`Source`), with its description and its group."""

    shirt: str
    body: str | None
    chair: str
    simulated: bool | None
    description: str
    group: SourceGroup

    @model_validator(mode="before")
    @classmethod
    def _describe(cls, source: Any) -> Any:
        if isinstance(source, Source):
            return {**source.model_dump(), "description": source_description(source), "group": source.group}
        return source


def requested_group(
    settings: SettingsPart, equipment: EquipmentPart, source: Annotated[SourceGroup | None, Query()] = None
) -> SourceGroup:
    """Return the requested group of trials; by default that of the shirt in use, before the first choice worn ones."""
    if source is not None:
        return source
    if equipment.kind is not None:
        return equipment.group
    return "simulated" if settings.demo else "worn"


RequestedGroup = Annotated[SourceGroup, Depends(requested_group)]
