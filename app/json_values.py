"""What JSON can say, as a type."""

import json
from typing import TypeAlias

JsonValue: TypeAlias = bool | int | float | str | list["JsonValue"] | dict[str, "JsonValue"] | None
JsonObject: TypeAlias = dict[str, JsonValue]


def parse_object(text: bytes | str) -> JsonObject:
    """Return a JSON object; raise ValueError for anything else."""
    parsed: JsonValue = json.loads(text)
    if not isinstance(parsed, dict):
        raise ValueError("this is no JSON object")
    return parsed
