"""Turns the validation errors of a document into one sentence for the person who wrote it."""

from collections.abc import Mapping, Sequence
from typing import Any, Final

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from app.texts import Text, Value, text_of

LONGEST_QUOTE: Final = 40

# pydantic's kinds of problems, each with the end of its message's id and the field of its context that is the limit.
KINDS: Final[Mapping[str, tuple[str, str]]] = {
    "greater_than": ("greater-than", "gt"),
    "greater_than_equal": ("greater-than-equal", "ge"),
    "less_than": ("less-than", "lt"),
    "less_than_equal": ("less-than-equal", "le"),
    "finite_number": ("finite-number", ""),
    **dict.fromkeys(("float_type", "float_parsing"), ("number", "")),
    **dict.fromkeys(("int_type", "int_parsing", "int_parsing_size", "int_from_float"), ("whole-number", "")),
    **dict.fromkeys(("bool_type", "bool_parsing"), ("truth", "")),
    "string_type": ("text", ""),
    "string_too_short": ("text-longer", "min_length"),
    "string_too_long": ("text-shorter", "max_length"),
    **dict.fromkeys(("list_type", "tuple_type", "set_type", "frozen_set_type"), ("list", "")),
    **dict.fromkeys(("dict_type", "model_type", "model_attributes_type", "dataclass_type"), ("object", "")),
    **dict.fromkeys(("date_type", "date_parsing", "date_from_datetime_parsing"), ("date", "")),
    "none_required": ("nothing", ""),
}


def one_sentence(error: ValidationError, where: Text | str) -> Text:
    """Return one sentence: what is wrong, where in `where` (a file or a form), and what to do."""
    return sentence_of(error.errors(include_url=False), where)


def sentence_of(problems: Sequence[ErrorDetails], where: Text | str) -> Text:
    """Return one sentence on pydantic's list of problems: what is wrong, where in `where`, and what to do."""
    first = problems[0]
    place, problem = _place(first["loc"]), _problem(first)
    if place:
        sentence = Text("invalid-at", where=where, place=place, problem=problem)
    else:
        sentence = Text("invalid-in", where=where, problem=problem)
    more = len(problems) - 1
    return Text("invalid-more", sentence=sentence, count=more) if more else sentence


def _place(location: tuple[int | str, ...]) -> str:
    """Return the location as a path such as channels[3].name; indices count from 0."""
    place = ""
    for part in location:
        if isinstance(part, int):
            place += f"[{part}]"
        else:
            name = part if len(part) <= LONGEST_QUOTE else part[:LONGEST_QUOTE] + "..."
            place += f".{name}" if place else name
    return place


def _problem(problem: ErrorDetails) -> Text | str:
    """Return a problem as the end of a sentence: what is wrong, and what to do."""
    kind, message = problem["type"], problem["msg"]
    context: dict[str, Any] = problem.get("ctx", {})
    match kind:
        case "value_error":
            return text_of(context["error"])
        case "missing":
            return Text("invalid-missing")
        case "extra_forbidden":
            return Text("invalid-unknown-field")
        case "json_invalid":
            return Text("invalid-not-json", problem=message.removeprefix("Invalid JSON: "))
        case "union_tag_invalid":
            return Text("invalid-kind", field=context["discriminator"], kinds=context["expected_tags"])
        case "union_tag_not_found":
            return Text("invalid-kind-missing", field=context["discriminator"])
        case "too_long":
            return Text("invalid-too-many", most=context["max_length"], count=context["actual_length"])
        case "too_short":
            return Text("invalid-too-few", least=context["min_length"], count=context["actual_length"])
    value = _quoted(problem.get("input"))
    if kind in {"literal_error", "enum"}:
        return Text("invalid-choice", choices=context["expected"].replace(" or ", ", "), value=value)
    if kind not in KINDS:
        return Text("invalid-other", problem=message[:1].lower() + message[1:], value=value)
    name, limit = KINDS[kind]
    limits: dict[str, Value] = {"limit": context[limit]} if limit else {}
    return Text(f"invalid-{name}", value=value, **limits)


def _quoted(value: object) -> str:
    quoted = repr(value)
    return quoted if len(quoted) <= LONGEST_QUOTE else quoted[:LONGEST_QUOTE] + "..."
