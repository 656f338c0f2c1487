"""Turns the validation errors of a document into one sentence for the person who wrote it."""

from collections.abc import Sequence

from pydantic import ValidationError
from pydantic_core import ErrorDetails

LONGEST_QUOTE = 40


def one_sentence(error: ValidationError, where: str) -> str:
    """Return one sentence: what is wrong, where in `where` (a file or a form), and what to do."""
    return sentence_of(error.errors(include_url=False), where)


def sentence_of(problems: Sequence[ErrorDetails], where: str) -> str:
    """Return one sentence on pydantic's list of problems: what is wrong, where in `where`, and what to do."""
    first = problems[0]
    place = _place(first["loc"])
    start = f"{where}, {place}" if place else where
    sentence = f"{start}: {_problem(first)}"
    remaining = len(problems) - 1
    if remaining:
        sentence += f" ({remaining} more {'problem' if remaining == 1 else 'problems'} in it)"
    return sentence


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


def _problem(problem: ErrorDetails) -> str:
    """Return a problem as half a sentence: what is wrong, and what to do."""
    kind: str = problem["type"]
    message: str = problem["msg"]
    if kind == "value_error":
        return message.removeprefix("Value error, ")
    if kind == "missing":
        return "this is missing, add it"
    if kind == "extra_forbidden":
        return "this is not known here, leave it out"
    if kind == "json_invalid":
        return f"this is not JSON, correct it ({message.removeprefix('Invalid JSON: ')})"
    if kind == "union_tag_invalid":
        return (
            f"{problem['ctx']['discriminator']} must be one of {problem['ctx']['expected_tags']}, choose one of these"
        )
    if kind == "union_tag_not_found":
        return f"{problem['ctx']['discriminator']} is missing, add it"
    bounds = problem.get("ctx", {})
    if kind == "too_long":
        return f"there may be at most {bounds['max_length']}, but there are {bounds['actual_length']}, remove some"
    if kind == "too_short":
        return f"there must be at least {bounds['min_length']}, but there are {bounds['actual_length']}, add some"
    quoted = repr(problem.get("input"))
    if len(quoted) > LONGEST_QUOTE:
        quoted = quoted[:LONGEST_QUOTE] + "..."
    return f"{message[:1].lower()}{message[1:]}, but it is {quoted}: correct it"
