"""Starts the child processes of the web process, asks them, and prepares each of them for its work.

A moving chair depends on the web process. Work that takes long, needs a large library, or reads a foreign file is
therefore done by children: the computing process, the reader of foreign files, the process that makes a backup, the
one that hashes passwords, and the one that measures the computer. Each is `python -m MODULE`, and none is shared
(docs/decisions/0055). A child reads its questions from its standard input, or from a connection of its own. Both end
with the web process, and so does the child.

A child loads this file too, before its first answer: what only some need is imported where it is used, and there is no
dataclass, because the module of those takes as long to load as all of the others.
"""

import json
import os
import signal
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Final, NamedTuple

from app.json_values import JsonObject, parse_object

if TYPE_CHECKING:
    from asyncio.subprocess import Process
    from multiprocessing.connection import Connection
    from subprocess import Popen

NICENESS: Final = 10  # a tenth of the processor time of an ordinary process on the same core
MOST_MEMORY: Final = 3_000_000_000  # bytes of address space
ONE_THREAD: Final = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}  # each thread reserves address space


class ChildEndedError(ConnectionError):
    """The child has ended, or has written something else than a JSON object."""


class ChildLimits(NamedTuple):
    """What a child may use beside MOST_MEMORY, so that a hostile file cannot use up the computer."""

    computing: int  # s of processor time
    file_size: int  # bytes of one file that the child writes


def command(module: str, *arguments: str) -> list[str]:
    """Return the command line of a child."""
    return [sys.executable, "-m", module, *arguments]


class JsonChild:
    """A running child that is asked, and answers, with one JSON object a line; for one task at a time."""

    def __init__(self, process: "Process") -> None:
        self._process = process

    @classmethod
    async def start(cls, module: str, *arguments: str, language: str | None = None) -> "JsonChild":
        """Start a child; raise OSError when the system refuses another process.

        With `language`, a child that is a command of `bodydrive` writes in that language.
        """
        import asyncio  # noqa: PLC0415

        pipe = asyncio.subprocess.PIPE
        environment = None if language is None else os.environ | {"LC_ALL": language}
        words = command(module, *arguments)
        return cls(await asyncio.create_subprocess_exec(*words, stdin=pipe, stdout=pipe, env=environment))

    async def send(self, question: Mapping[str, object]) -> None:
        """Write a question; raise ConnectionError when the child has ended."""
        assert self._process.stdin is not None
        self._process.stdin.write(json.dumps(question).encode() + b"\n")
        await self._process.stdin.drain()

    async def receive(self) -> JsonObject:
        """Return the child's next line; raise ChildEndedError when none comes."""
        assert self._process.stdout is not None
        try:
            return parse_object(await self._process.stdout.readline())
        except ValueError as error:  # also for the empty line of a child that has ended
            raise ChildEndedError from error

    async def end(self, limit: float = 0.0) -> None:
        """Close the child's input, and kill the child when it has not ended after `limit` (s)."""
        import asyncio  # noqa: PLC0415

        assert self._process.stdin is not None
        self._process.stdin.close()
        try:
            async with asyncio.timeout(limit):
                await self._process.wait()
        except TimeoutError:
            with suppress(ProcessLookupError):
                self._process.kill()
            await self._process.wait()


def ask_once(command: list[str], question: Mapping[str, object], limit: float) -> JsonObject:
    """Start a child for one question, and return its answer, both JSON; wait in the calling thread.

    Raises
    ------
    TimeoutError
        When there was no answer within `limit` (s); the child is ended.
    ChildEndedError
        When the child failed.
    """
    import subprocess  # noqa: PLC0415

    try:
        ended = subprocess.run(
            command,
            input=json.dumps(question).encode(),
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=limit,
            env=os.environ | ONE_THREAD,
            check=True,
        )
        return parse_object(ended.stdout)
    except subprocess.TimeoutExpired as error:
        raise TimeoutError from error
    except (subprocess.CalledProcessError, ValueError) as error:
        raise ChildEndedError from error


def start_connected(module: str) -> "tuple[Popen[bytes], Connection]":
    """Start a child with a connection that carries pickles; its descriptor is the child's only argument."""
    from multiprocessing.connection import Pipe  # noqa: PLC0415
    from subprocess import DEVNULL, Popen  # noqa: PLC0415

    connection, end_of_child = Pipe()
    with end_of_child:
        descriptor = end_of_child.fileno()
        process = Popen(command(module, str(descriptor)), stdin=DEVNULL, stdout=DEVNULL, pass_fds=[descriptor])
    return process, connection


def prepare_child(*, lowest_priority: bool = False, limits: ChildLimits | None = None) -> None:
    """Lower the priority of this process, a child, and limit what it may use.

    Ctrl-C reaches all processes of a terminal. A child with limits keeps nothing that could be lost, and ends by it.
    Any other leaves Ctrl-C to the web process, which then ends the child in order.
    """
    if limits is None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    else:
        _set_limits(limits)
    if lowest_priority:
        from app.realtime import take_lowest_priority  # noqa: PLC0415

        take_lowest_priority()
    else:
        os.nice(NICENESS)


def limit_memory() -> None:
    """Limit the address space of this process: beyond MOST_MEMORY, Python raises MemoryError."""
    import resource  # noqa: PLC0415  (not on every system on which the command line runs)

    with suppress(ValueError, OSError):  # some systems do not limit memory
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def _set_limits(limits: ChildLimits) -> None:
    import resource  # noqa: PLC0415

    limit_memory()
    resource.setrlimit(resource.RLIMIT_CPU, (limits.computing, limits.computing + 1))
    resource.setrlimit(resource.RLIMIT_FSIZE, (limits.file_size, limits.file_size))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def questions() -> Iterator[JsonObject]:
    """Yield what the web process asks this child, one JSON object a line, until that process has ended."""
    for line in sys.stdin:
        yield parse_object(line)


def respond(answer: Mapping[str, object]) -> None:
    """Write one JSON object for the web process; end this child in order when that process has ended."""
    try:
        sys.stdout.write(f"{json.dumps(answer)}\n")
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the interpreter writes the rest when it ends
        sys.exit(0)
