"""Take in foreign files one at a time, read them by the isolated reader, and turn its errors into answers."""

import asyncio
import re
from collections.abc import Callable, Sequence
from typing import Any, Final, ParamSpec, TypeVar

from fastapi import HTTPException

from app.isolated_reader import ReadingTimeoutError, read_isolated

Given = ParamSpec("Given")
Answer = TypeVar("Answer")
FILE_IN_FRONT: Final = re.compile(r"[\w-]+\.\w+[:,] ")  # of a sentence: it keeps its first letter


class OneAtATime:
    """Runs work in a thread, one piece after the other: several large files at once would need too much memory."""

    def __init__(self) -> None:
        self._turn = asyncio.Lock()  # a waiting request must not occupy one of the few threads

    async def run(self, work: Callable[Given, Answer], *given: Given.args, **named: Given.kwargs) -> Answer:
        """Return what `work` returns, once the work before it has ended."""
        async with self._turn:
            return await asyncio.to_thread(work, *given, **named)


class Readings(OneAtATime):
    """Reads drawings, pictures and 3D objects."""


class Uploads(OneAtATime):
    """Reads recordings that people bring, each in memory as a whole."""


def refusal(error: ValueError, places: Sequence[str] = ()) -> HTTPException:
    """Return the answer for an error of a reader: 422, or 503 when it took too long.

    `places` are removed from its sentence, which begins with a capital letter unless a file's name stands in front.
    """
    sentence = str(error)
    for place in places:
        sentence = sentence.replace(place, "")
    return HTTPException(503 if isinstance(error, ReadingTimeoutError) else 422, whole_sentence(sentence))


def whole_sentence(sentence: str) -> str:
    """Return a sentence with a capital letter, unless a file's name stands in front, and with its full stop."""
    if not FILE_IN_FRONT.match(sentence):
        sentence = sentence[:1].upper() + sentence[1:]
    return f"{sentence.removesuffix('.')}."


def read_or_refuse(module: str, question: dict[str, Any], places: Sequence[str] = ()) -> dict[str, Any]:
    """Return what `read_isolated` answers, or raise what `refusal` makes of its error."""
    try:
        return read_isolated(module, question)
    except ValueError as error:
        raise refusal(error, places) from error
