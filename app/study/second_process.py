"""The second process of a study: it fits, scores and draws, while the first one drives.

A person learns from trial to trial, so that one study drives one trial after the other; everything else can be done
beside it. The numbers do not depend on where they are computed.
"""

import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from importlib import import_module
from typing import ParamSpec, TypeVar

Arguments = ParamSpec("Arguments")
Answer = TypeVar("Answer")

# What is imported inside functions: by the fit, with which a study begins, and by scoring and drawing.
FIRST_LIBRARY = "sklearn.decomposition"
LATER_LIBRARIES = ("shapely", "scipy.signal", "scipy.optimize", "scipy.stats")
DRAWING_LIBRARY = "matplotlib.backends.backend_agg"


class SameProcess(Executor):
    """Computes at once, in this process."""

    def submit(
        self, ask: Callable[Arguments, Answer], /, *arguments: Arguments.args, **options: Arguments.kwargs
    ) -> Future[Answer]:
        """Return the answer, which is there already."""
        done: Future[Answer] = Future()
        done.set_result(ask(*arguments, **options))
        return done


@contextmanager
def second_process(processes: int, *, draws: bool = True) -> Iterator[Executor]:
    """Yield what computes, and draws, beside this process; with one process only, this process itself."""
    if processes == 1:
        yield SameProcess()
        return
    # An interrupt (Ctrl+C) ends the process that drives, and that one ends the other.
    with _SecondProcess((*LATER_LIBRARIES, DRAWING_LIBRARY) if draws else LATER_LIBRARIES) as second:
        yield second


class _SecondProcess(ProcessPoolExecutor):
    """Loads what the first question needs, and what later ones need behind it: nobody waits for the wrong library."""

    def __init__(self, later: tuple[str, ...]) -> None:
        super().__init__(1, initializer=signal.signal, initargs=(signal.SIGINT, signal.SIG_IGN))
        self._later = later
        super().submit(_load, (FIRST_LIBRARY,))

    def submit(
        self, ask: Callable[Arguments, Answer], /, *arguments: Arguments.args, **options: Arguments.kwargs
    ) -> Future[Answer]:
        """Return the answer that is to come."""
        answer = super().submit(ask, *arguments, **options)
        if self._later:
            super().submit(_load, self._later)
            self._later = ()
        return answer


def _load(libraries: tuple[str, ...]) -> None:
    for name in libraries:
        import_module(name)
