"""Read foreign files by the isolated reader, one at a time, and turn its errors into answers."""

import asyncio
from collections.abc import Callable, Sequence
from typing import Any, ParamSpec, TypeVar

from fastapi import HTTPException

from app.isolated_reader import ReadingTimeoutError, read_isolated

Given = ParamSpec("Given")
Answer = TypeVar("Answer")

# An asyncio semaphore: a waiting request must not occupy one of the few threads.
_turn = asyncio.Semaphore(1)


async def in_turn(work: Callable[Given, Answer], *given: Given.args, **named: Given.kwargs) -> Answer:
    """Run `work`, which reads a foreign file, in a thread; one file at a time."""
    async with _turn:
        return await asyncio.to_thread(work, *given, **named)


def refusal(error: ValueError, places: Sequence[str] = ()) -> HTTPException:
    """Return the answer for an error of a reader: 422, or 503 when it took too long; `places` are removed."""
    sentence = str(error).removesuffix(".")
    for place in places:
        sentence = sentence.replace(place, "")
    if sentence.startswith("this "):
        sentence = sentence[:1].upper() + sentence[1:]
    return HTTPException(503 if isinstance(error, ReadingTimeoutError) else 422, f"{sentence}.")


def read_or_refuse(module: str, question: dict[str, Any], places: Sequence[str] = ()) -> dict[str, Any]:
    """Return what `read_isolated` answers, or raise what `refusal` makes of its error."""
    try:
        return read_isolated(module, question)
    except ValueError as error:
        raise refusal(error, places) from error
