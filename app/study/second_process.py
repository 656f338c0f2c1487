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

Asked = ParamSpec("Asked")
Answer = TypeVar("Answer")

# What fitting, scoring and drawing import inside their functions; loaded while nobody waits, in the order of use.
SLOW_LIBRARIES = (
    *("sklearn.decomposition", "shapely", "scipy.signal", "scipy.optimize", "scipy.stats"),
    *("statsmodels.regression.linear_model", "statsmodels.tools.eval_measures", "matplotlib.figure"),
)


class SameProcess(Executor):
    """Computes at once, in this process, what it is asked."""

    def submit(self, ask: Callable[Asked, Answer], /, *given: Asked.args, **named: Asked.kwargs) -> Future[Answer]:
        """Return the answer, which is there already."""
        done: Future[Answer] = Future()
        done.set_result(ask(*given, **named))
        return done


@contextmanager
def second_process(processes: int) -> Iterator[Executor]:
    """Yield what computes beside this process; with one process only, this process itself."""
    if processes == 1:
        yield SameProcess()
        return
    # An interrupt (Ctrl+C) ends the process that drives, and that one ends the other.
    with ProcessPoolExecutor(1, initializer=signal.signal, initargs=(signal.SIGINT, signal.SIG_IGN)) as second:
        second.submit(_load_slow_libraries)
        yield second


def _load_slow_libraries() -> None:
    for name in SLOW_LIBRARIES:
        import_module(name)
