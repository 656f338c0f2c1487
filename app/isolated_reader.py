"""Reads uploaded pictures, 3D objects and drawings in a process of its own, with limits of memory and time.

Such a file may make its reader use any amount of memory and time. The web process must not be slowed by that, because a
moving chair depends on it. `read_isolated` starts `python -m app.isolated_reader MODULE`, which answers one question
with `MODULE.answer(question)`.
"""

import importlib
import sys
import threading
from typing import Any, Final

from app.child_process import ChildEndedError, ChildLimits, ask_once, command, prepare_child, questions, respond
from app.texts import Text, from_document, text_of, to_document

LIMITS: Final = ChildLimits(computing=60, file_size=200_000_000)  # an upload of 64 MB, as numbers of 64 bits
LONGEST_WAIT: Final = 120.0  # s
FAILED: Final = Text("reading-failed")
COMMAND: Final = command("app.isolated_reader")

_one_at_a_time = threading.Lock()


class ReadingTimeoutError(ValueError):
    """The reader gave no answer in time."""


def read_isolated(module: str, question: dict[str, Any]) -> dict[str, Any]:
    """Return the answer of `module.answer` to a question, both sent as JSON; one question at a time.

    Raises
    ------
    ValueError
        One sentence: what is wrong with the file, and what to do.
    ReadingTimeoutError
        When the reader gave no answer within 120 s.
    """
    with _one_at_a_time:
        try:
            answer = ask_once([*COMMAND, module], question, LONGEST_WAIT)
        except TimeoutError as error:
            raise ReadingTimeoutError(Text("reading-too-long")) from error
        except ChildEndedError as error:
            raise ValueError(FAILED) from error
    if "problem" in answer:
        raise ValueError(from_document(answer["problem"]))
    return answer


def main(module: str) -> None:
    """Answer one question of the web process."""
    prepare_child(limits=LIMITS)
    try:
        respond(importlib.import_module(module).answer(next(questions())))
    except ValueError as error:
        respond({"problem": to_document(text_of(error))})
    except MemoryError:
        respond({"problem": to_document(Text("reading-memory"))})


if __name__ == "__main__":
    main(sys.argv[1])
