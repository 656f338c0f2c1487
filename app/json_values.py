"""What JSON can say, as a type."""

import json
from typing import Any, TypeAlias

JsonValue: TypeAlias = bool | int | float | str | list["JsonValue"] | dict[str, "JsonValue"] | None
JsonObject: TypeAlias = dict[str, JsonValue]
JsonDocument: TypeAlias = dict[str, Any]
"""A JSON object that a model has written, or will check: the types of its values are the model's."""


def parse_object(text: bytes | str) -> JsonObject:
    """Return a JSON object; raise ValueError for anything else."""
    parsed: JsonValue = json.loads(text)
    if not isinstance(parsed, dict):
        raise ValueError("this is no JSON object")
    return parsed
