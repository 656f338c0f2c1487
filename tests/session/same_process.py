"""Computes in the test's own process what the computing process would."""

import pickle
from collections.abc import Callable
from functools import partial
from typing import Any

from app.computing_process import ComputingProcess, answer


class SameProcess(ComputingProcess):
    """Calls each function at once; `stand_ins` are called in place of the functions that they stand for."""

    def __init__(self, stand_ins: dict[Callable[..., Any], Callable[..., Any]] | None = None) -> None:
        super().__init__()
        self._stand_ins = stand_ins or {}

    def begin(self) -> None:
        pass

    def ask(self, function: Callable[..., Any], /, *given: Any, **named: Any) -> Any:
        return self._stand_ins.get(function, function)(*given, **named)

    def ask_unless(self, leave_off: Callable[[], bool], question: Callable[[], Any]) -> Any:
        """Ask a partial function; what stands in for it is given `leave_off`, too."""
        assert isinstance(question, partial)
        if question.func in self._stand_ins:
            return self._stand_ins[question.func](*question.args, leave_off)
        return question()

    def ask_while(self, _progress: Callable[[], object], question: Callable[[], Any]) -> Any:
        """Ask a question as it reaches another process, and return its answer as it comes back."""
        error, found = pickle.loads(pickle.dumps(answer(pickle.loads(pickle.dumps(question)))))
        if error is not None:
            raise error
        return found

    def close(self) -> None:
        pass
