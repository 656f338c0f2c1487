"""Reads uploaded pictures, 3D objects and drawings in a process of its own, with limits of memory and time.

Such a file may make its reader use any amount of memory and time. The web process must not be slowed by that, because a
moving chair depends on it. `read_isolated` starts `python -m app.isolated_reader MODULE`, which answers one question
with `MODULE.answer(question)`.
"""

import importlib
import json
import os
import subprocess
import sys
import threading
from contextlib import suppress
from typing import Any, Final

MOST_MEMORY: Final = 3_000_000_000  # bytes of address space
LONGEST_COMPUTING: Final = 60  # s of processor time
LONGEST_WAIT: Final = 120.0  # s
LARGEST_ANSWER: Final = 50_000_000  # bytes of one file that the reader writes
NICE: Final = 10
COMMAND: Final = (sys.executable, "-m", "app.isolated_reader")
ONE_THREAD: Final = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}  # each thread reserves address space

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
            reader = subprocess.run(
                [*COMMAND, module],
                input=json.dumps(question).encode(),
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                timeout=LONGEST_WAIT,
                env=os.environ | ONE_THREAD,
                check=False,
            )
        except subprocess.TimeoutExpired as error:
            raise ReadingTimeoutError("reading this file takes too long: make it smaller, then add it again") from error
    if reader.returncode != 0:
        raise ValueError("this file could not be read, or takes too long: save it anew or make it smaller")
    answer: dict[str, Any] = json.loads(reader.stdout)
    if "problem" in answer:
        raise ValueError(str(answer["problem"]))
    return answer


def limit_this_process() -> None:
    """Set the limits of memory, processor time and file size for this process."""
    import resource  # noqa: PLC0415  (not on every system on which the command line runs)

    os.nice(NICE)
    limit_memory()
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST_COMPUTING, LONGEST_COMPUTING + 1))
    resource.setrlimit(resource.RLIMIT_FSIZE, (LARGEST_ANSWER, LARGEST_ANSWER))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def limit_memory() -> None:
    """Set the limit of memory for this process: beyond it, Python raises MemoryError."""
    import resource  # noqa: PLC0415

    with suppress(ValueError, OSError):  # some systems do not limit memory
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def main(module: str) -> None:
    """Answer one question from standard input on standard output."""
    limit_this_process()
    answer: dict[str, Any]
    try:
        answer = importlib.import_module(module).answer(json.load(sys.stdin))
    except ValueError as error:
        answer = {"problem": str(error)}
    except MemoryError:
        answer = {"problem": "this needs too much memory, make it smaller"}
    json.dump(answer, sys.stdout)


if __name__ == "__main__":
    main(sys.argv[1])
