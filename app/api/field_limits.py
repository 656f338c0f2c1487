"""The limits of what requests may hold, as pages show them beside their fields: read from the models of the bodies."""

from collections.abc import Iterator, Mapping
from typing import Any

from fastapi import FastAPI
from fastapi.routing import APIRoute, iter_route_contexts
from pydantic import TypeAdapter

from app.quantities import Document

LIMITS = {
    "minimum": "minimum",
    "exclusiveMinimum": "above",
    "maximum": "maximum",
    "minLength": "shortest",
    "maxLength": "longest",
    "default": "usual",
}
"""Words of JSON schema, and the fields that they become."""


class FieldLimits(Document):
    """The limits of one field of a request; null where there is none."""

    minimum: float | None = None
    above: float | None = None  # the value must be larger
    maximum: float | None = None
    shortest: int | None = None  # characters
    longest: int | None = None
    usual: float | str | None = None  # the value that holds where none is sent


Limits = dict[str, dict[str, FieldLimits]]
"""Name of a model -> name of its field -> limits."""


def field_limits(app: FastAPI) -> Limits:
    """Return the limits of every model that a request of the API can hold."""
    limits: Limits = {}
    for context in iter_route_contexts(app.routes):
        route = context.original_route
        if isinstance(route, APIRoute) and route.body_field is not None:
            body: TypeAdapter[Any] = TypeAdapter(route.body_field.field_info.annotation or Any)
            schema = body.json_schema()
            models = {schema.get("title", ""): schema, **schema.get("$defs", {})}
            limits |= {name: fields for name, model in models.items() if (fields := dict(_fields(model)))}
    return limits


def _fields(model: Mapping[str, Any]) -> Iterator[tuple[str, FieldLimits]]:
    for name, schema in model.get("properties", {}).items():
        forms = (schema, *schema.get("anyOf", ()))
        facts: dict[str, Any] = {
            LIMITS[word]: value
            for form in forms
            for word, value in form.items()
            if word in LIMITS and isinstance(value, int | float | str) and not isinstance(value, bool)
        }
        if "above" in facts and any(form.get("type") == "integer" for form in forms):
            facts["minimum"] = facts.pop("above") + 1  # the field of a page has no limit that it excludes
        if facts:
            yield name, FieldLimits(**facts)
