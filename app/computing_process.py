"""Computes in a process of its own what takes long or needs a large library.

A moving chair depends on the web process: a library that is loaded there takes the interpreter from the thread that
reads the screen's reports, and its memory stays. `ComputingProcess` starts `python -m app.computing_process
DESCRIPTOR`, which calls one function after the other, at low priority, and ends with the web process.
"""

import sys
import threading
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from importlib import import_module
from multiprocessing.connection import Connection
from typing import Final, ParamSpec, TypeVar, cast

from app.child_process import prepare_child, start_connected
from app.clock import monotonic
from app.refusals import Conflict, DiskFull, Unavailable
from app.texts import Figure, Text, current_language, reader_language, text_of

IDLE_LIMIT: Final = 300.0  # s without a question, after which the process ends and gives its memory back
ANSWER_LIMIT: Final = 120.0  # s
POLL_INTERVAL: Final = 0.05  # s between two checks whether the answer is still wanted
ENDED: Final = Text("computing-ended")
TOO_LONG: Final = Text("computing-too-long", limit=Figure(ANSWER_LIMIT))

# What the functions import late. The process loads them while nobody asks, in the order in which they are used.
SLOW_LIBRARIES: Final = (
    *("pyarrow", "pyarrow.parquet", "sklearn.decomposition", "shapely", "scipy.signal", "scipy.optimize"),
    *("scipy.special", "scipy.stats", "scipy.io", "pyarrow.csv"),
)

Arguments = ParamSpec("Arguments")
Answer = TypeVar("Answer")


class ComputingProcess:
    """Asks the computing process; starts it for the first question, and again when it has ended. Thread-safe.

    It is asked to call functions of modules, with arguments that can be pickled.
    """

    def __init__(self, idle_limit: float = IDLE_LIMIT) -> None:
        self._idle_limit = idle_limit
        self._one_at_a_time = threading.Lock()
        self._answered = threading.Condition()  # guards `questions`
        self.questions = 0
        """How many questions are being answered or wait for it."""
        self._running: _Running | None = None
        self._idle = threading.Timer(0.0, self._end_idle)
        self._closed = False

    def begin(self) -> None:
        """Start the process unless it runs, so that it loads its libraries before the first question."""
        if self._one_at_a_time.acquire(blocking=False):  # otherwise somebody asks, and it runs
            try:
                with suppress(OSError):  # the question that follows will say why it cannot be started
                    self._started()
                self._count_idle_time()
            finally:
                self._one_at_a_time.release()

    def ask(
        self, function: Callable[Arguments, Answer], /, *arguments: Arguments.args, **options: Arguments.kwargs
    ) -> Answer:
        """Return `function(*arguments, **options)`, computed when earlier questions are answered.

        Raises
        ------
        ValueError, OSError, Conflict, DiskFull
            With the words of the one that the function raised.
        Unavailable
            In one sentence, when the process ended, or gave no answer within 120 s.
        RuntimeError
            When the function raised another error; it names the place.
        """
        return self._answer(partial(function, *arguments, **options), lambda: False)

    def ask_last(
        self, function: Callable[Arguments, Answer], /, *arguments: Arguments.args, **options: Arguments.kwargs
    ) -> Answer:
        """Return `function(*arguments, **options)`, computed when nobody else waits. Raises what `ask` raises."""
        with self._answered:
            self._answered.wait_for(lambda: not self.questions)
        return self.ask(function, *arguments, **options)

    def ask_unless(self, leave_off: Callable[[], bool], question: Callable[[], Answer]) -> Answer | None:
        """Return `question()`, a partial function; None when `leave_off` returned True before the answer came.

        Raises what `ask` raises.
        """
        try:
            return self._answer(question, leave_off)
        except _NoLongerWantedError:
            return None

    def ask_while(self, progress: Callable[[], object], question: Callable[[], Answer]) -> Answer:
        """Return `question()`, a partial function, however long it takes while `progress()` returns new values.

        The 120 s count from the last new value. Raises what `ask` raises.
        """
        return self._answer(question, lambda: False, progress)

    def close(self) -> None:
        """End the process for good; who waits for an answer is refused."""
        self._closed = True
        running = self._running
        if running is not None:
            running.process.kill()
        with self._one_at_a_time:
            self._idle.cancel()
            self._end()

    def _answer(
        self,
        question: Callable[[], Answer],
        leave_off: Callable[[], bool],
        progress: Callable[[], object] = lambda: None,
    ) -> Answer:
        with self._counted(), self._one_at_a_time:
            self._idle.cancel()
            running = self._started()
            try:
                error, answer = running.answer(question, leave_off, progress)
            except BaseException:
                self._end()
                raise
            self._count_idle_time()
        if error is not None:
            raise error
        return cast(Answer, answer)

    @contextmanager
    def _counted(self) -> Iterator[None]:
        with self._answered:
            self.questions += 1
        try:
            yield
        finally:
            with self._answered:
                self.questions -= 1
                self._answered.notify_all()

    def _started(self) -> "_Running":
        if self._closed:
            raise Unavailable(ENDED)
        if self._running is None or self._running.process.poll() is not None:
            self._end()
            self._running = _Running()
        return self._running

    def _count_idle_time(self) -> None:
        self._idle.cancel()
        self._idle = threading.Timer(self._idle_limit, self._end_idle)
        self._idle.daemon = True
        self._idle.start()

    def _end_idle(self) -> None:
        if self._one_at_a_time.acquire(blocking=False):  # otherwise somebody asks
            try:
                self._end()
            finally:
                self._one_at_a_time.release()

    def _end(self) -> None:
        running, self._running = self._running, None
        if running is not None:
            running.end()


class _NoLongerWantedError(Exception):
    """Nobody wants the answer any more."""


class _Running:
    """A running computing process and the connection to it."""

    def __init__(self) -> None:
        self.process, self._connection = start_connected(__name__)

    def answer(
        self, question: Callable[[], object], leave_off: Callable[[], bool], progress: Callable[[], object]
    ) -> tuple[Exception | None, object]:
        """Return the error that the question raised, or None, and its answer."""
        until, before = monotonic() + ANSWER_LIMIT, progress()
        try:
            self._connection.send((current_language(), question))
            while not self._connection.poll(POLL_INTERVAL):
                if leave_off():
                    raise _NoLongerWantedError
                if (now := progress()) != before:
                    until, before = monotonic() + ANSWER_LIMIT, now
                elif monotonic() > until:
                    raise Unavailable(TOO_LONG)
            answered: tuple[Exception | None, object] = self._connection.recv()
        except (EOFError, ConnectionError) as error:
            raise Unavailable(ENDED) from error
        return answered

    def end(self) -> None:
        """End the process at once: it keeps nothing that could be lost."""
        self.process.kill()
        self.process.wait()
        self._connection.close()


def main(descriptor: int) -> None:
    """Answer questions until the web process ends."""
    prepare_child()
    with Connection(descriptor) as web, suppress(EOFError, ConnectionError):
        libraries = iter(SLOW_LIBRARIES)
        while True:
            if web.poll() or (name := next(libraries, None)) is None:
                language, question = web.recv()
                with reader_language(language):
                    web.send(answer(question))
            else:
                import_module(name)


def answer(question: Callable[[], object]) -> tuple[Exception | None, object]:
    """Return the error that a question raised, or None, and its answer. Any pickle can carry the error."""
    try:
        return None, question()
    except ValueError as error:
        return ValueError(text_of(error)), None
    except OSError as error:
        return OSError(str(error)), None
    except (Conflict, DiskFull) as error:
        return error, None
    except Exception:
        return RuntimeError(traceback.format_exc()), None


if __name__ == "__main__":
    main(int(sys.argv[1]))
