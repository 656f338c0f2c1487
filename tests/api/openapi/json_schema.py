"""The part of JSON Schema that the OpenAPI document uses: whether a value fits a schema, and values for one.

A keyword that is not known here fails, so that none is passed over.
"""

import random
import re
from collections.abc import Iterator
from typing import Any

WORDS = {"title", "description", "default", "discriminator", "format", "examples", "writeOnly", "unit"}
CHECKED = {
    *("$ref", "type", "enum", "const", "anyOf", "oneOf", "allOf", "properties", "required", "additionalProperties"),
    *("items", "prefixItems", "minItems", "maxItems", "minLength", "maxLength", "pattern", "minimum", "maximum"),
    *("exclusiveMinimum", "exclusiveMaximum", "propertyNames", "patternProperties"),
}
TYPES: dict[str, tuple[type, ...]] = {
    "object": (dict,),
    "array": (list,),
    "string": (str,),
    "integer": (int,),
    "number": (int, float),
    "boolean": (bool,),
    "null": (type(None),),
}
TEXTS = (
    *("", "a", "Heron", "P-1", "room", "ahead", "corridor", "u1", "right_elbow", "0" * 64, "2026-01-31", "=1+1", ".."),
    *("a b", "2026-01-31T10:00:00Z", "\u202ex", "\ud83e\udd86", "x" * 300, "-1", "null", "csv", "html", "simulated"),
    "worn",
)
NUMBERS = (0, 1, 2, 3, 0.5, -1, 1e-9, 100, 2**31, 2**63, 1e300, -0.0)
JUNK: tuple[Any, ...] = (None, True, "", "x", 1, -1, 0.5, 2**70, [], [[]], {}, {"x": 1}, "\x00", 1e308)


def misfits(schema: Any, value: Any, root: dict[str, Any], place: str = "") -> Iterator[str]:
    """Yield where a value does not fit a schema."""
    if schema is True or schema == {}:
        return
    unknown = set(schema) - WORDS - CHECKED
    assert not unknown, f"{place}: keywords that are not checked here: {unknown}"
    if "$ref" in schema:
        yield from misfits(resolved(schema, root), value, root, place)
    for each in schema.get("allOf", ()):
        yield from misfits(each, value, root, place)
    for words in ("anyOf", "oneOf"):
        if words in schema and not any(not list(misfits(each, value, root, place)) for each in schema[words]):
            yield f"{place}: {str(value)[:80]} fits none of {words}"
    if "const" in schema and (value != schema["const"] or isinstance(value, bool) != isinstance(schema["const"], bool)):
        yield f"{place}: {str(value)[:80]} is not {schema['const']}"
    if "enum" in schema and value not in schema["enum"]:
        yield f"{place}: {str(value)[:80]} is none of {schema['enum']}"
    kind = schema.get("type")
    if kind is not None:
        is_bool = isinstance(value, bool) and kind != "boolean"
        if is_bool or not isinstance(value, TYPES[kind]):
            whole = kind == "integer" and isinstance(value, float) and value.is_integer()
            if not whole:
                yield f"{place}: {str(value)[:80]} is no {kind}"
                return
    if isinstance(value, dict):
        yield from _misfits_of_object(schema, value, root, place)
    elif isinstance(value, list):
        yield from _misfits_of_list(schema, value, root, place)
    elif isinstance(value, str):
        if not schema.get("minLength", 0) <= len(value) <= schema.get("maxLength", 10**9):
            yield f"{place}: a text of {len(value)} characters"
        if "pattern" in schema and not re.search(schema["pattern"], value):
            yield f"{place}: {value[:80]} is not as {schema['pattern']}"
    elif isinstance(value, int | float) and not isinstance(value, bool):
        low, high = schema.get("minimum", value), schema.get("maximum", value)
        above, below = schema.get("exclusiveMinimum"), schema.get("exclusiveMaximum")
        if not low <= value <= high or (above is not None and value <= above) or (below is not None and value >= below):
            yield f"{place}: {value} is out of bounds"


def _misfits_of_object(schema: Any, value: dict[str, Any], root: dict[str, Any], place: str) -> Iterator[str]:
    known = schema.get("properties", {})
    yield from (f"{place}: '{name}' is missing" for name in schema.get("required", ()) if name not in value)
    for name, inner in value.items():
        patterns = [one for pattern, one in schema.get("patternProperties", {}).items() if re.search(pattern, name)]
        others = [schema["additionalProperties"]] if "additionalProperties" in schema and not patterns else []
        for one in [known[name]] if name in known else [*patterns, *others]:
            if one is False:
                yield f"{place}: '{name}' is not in the schema"
            else:
                yield from misfits(one, inner, root, f"{place}.{name}")


def _misfits_of_list(schema: Any, value: list[Any], root: dict[str, Any], place: str) -> Iterator[str]:
    if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", 10**9):
        yield f"{place}: {len(value)} elements"
    first = schema.get("prefixItems", [])
    for number, inner in enumerate(value):
        one = first[number] if number < len(first) else schema.get("items", True)
        yield from misfits(one, inner, root, f"{place}.{number}")


def resolved(schema: dict[str, Any], root: dict[str, Any]) -> Any:
    """Return the schema that a reference names."""
    found: Any = root
    for step in schema["$ref"].removeprefix("#/").split("/"):
        found = found[step]
    return found


def value_for(schema: Any, root: dict[str, Any], dice: random.Random, odd: float, depth: int = 0) -> Any:
    """Return a value for a schema; each part of it is something else with the probability `odd`."""
    if dice.random() < odd or schema is True or not schema:
        return dice.choice(JUNK)
    if "$ref" in schema:
        return value_for(resolved(schema, root), root, dice, odd, depth + 1)
    for words in ("anyOf", "oneOf", "allOf"):
        if words in schema:
            return value_for(dice.choice(schema[words]), root, dice, odd, depth + 1)
    if "const" in schema:
        return schema["const"]
    if "enum" in schema:
        return dice.choice(schema["enum"])
    kind = schema.get("type")
    if kind == "object":
        known, needed = schema.get("properties", {}), set(schema.get("required", ()))
        chosen = [name for name in known if name in needed or (depth < 6 and dice.random() < 0.5)]
        made = {name: value_for(known[name], root, dice, odd, depth + 1) for name in chosen}
        return {**made, "one_more": 1} if dice.random() < odd else made
    if kind == "array":
        least, first = schema.get("minItems", 0), schema.get("prefixItems", [])
        many = min(max(least, dice.randrange(3) if depth < 6 else 0), max(least, schema.get("maxItems", 3)))
        inner = [*first, *[schema.get("items", {"type": "number"})] * max(0, many - len(first))]
        return [value_for(one, root, dice, odd, depth + 1) for one in inner]
    if kind == "string":
        fitting = [text for text in TEXTS if not list(misfits(schema, text, root))]
        return dice.choice(fitting or TEXTS)
    if kind in {"integer", "number"}:
        whole = [number for number in NUMBERS if kind == "number" or isinstance(number, int)]
        bounds = [schema[name] for name in ("minimum", "maximum") if name in schema]
        fitting = [number for number in [*whole, *bounds] if not list(misfits(schema, number, root))]
        return dice.choice(fitting or whole)
    return {"boolean": dice.random() < 0.5, "null": None}.get(kind or "")
