"""The computing process: answers, errors, its ends, and what it loads."""

import ast
import itertools
import math
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from functools import partial
from pathlib import Path

import psutil
import pytest

from app import computing_process
from app.computing_process import SLOW_LIBRARIES, ComputingProcess, answer
from app.refusals import Conflict, DiskFull, Refusal, Unavailable
from folders import ROOT

MEASURING = ("calibration", "scoring", "signals")
LONG = 60.0  # s
LOWEST = 19  # priority of a process, as nice counts it


@pytest.fixture(scope="module")
def computing() -> Iterator[ComputingProcess]:
    """A computing process that starts with the first question; each new one loads large libraries between two."""
    made = ComputingProcess()
    yield made
    made.close()


def gone(pid: int) -> bool:
    """Wait until a process has ended; return False when it does not."""
    until = time.monotonic() + 20
    while psutil.pid_exists(pid) and psutil.Process(pid).status() != psutil.STATUS_ZOMBIE:
        if time.monotonic() > until:
            return False
        time.sleep(0.01)
    return True


def test_one_process_of_low_priority_answers_all_questions(computing: ComputingProcess) -> None:
    pid = computing.ask(os.getpid)
    assert pid != os.getpid()
    assert computing.ask(math.hypot, 3.0, 4.0) == 5.0
    assert computing.ask(sorted, [2, 3, 1], reverse=True) == [3, 2, 1]
    assert computing.ask(os.getpid) == pid
    assert computing.ask(os.nice, 0) >= min(os.nice(0) + 1, LOWEST)


@pytest.mark.parametrize("kind", [Conflict, DiskFull])
def test_a_refusal_comes_back_as_it_is(kind: type[Refusal]) -> None:
    def refuse() -> None:
        raise kind("Make room.")

    error, _ = pickle.loads(pickle.dumps(answer(refuse)))
    assert (type(error), str(error)) == (kind, "Make room.")


def test_errors_come_back_as_what_they_are(computing: ComputingProcess) -> None:
    with pytest.raises(ValueError, match="math domain error"):
        computing.ask(math.sqrt, -1.0)
    with pytest.raises(OSError, match="nowhere"):
        computing.ask(os.listdir, "/nowhere")
    with pytest.raises(RuntimeError, match="TypeError"):
        computing.ask(math.sqrt, "x")  # type: ignore[arg-type]
    assert computing.ask(math.sqrt, 4.0) == 2.0


def test_a_process_that_ends_is_one_sentence_and_the_next_question_starts_another(computing: ComputingProcess) -> None:
    with pytest.raises(Unavailable, match="try again"):
        computing.ask(os._exit, 3)
    assert computing.ask(math.sqrt, 4.0) == 2.0
    os.kill(computing.ask(os.getpid), signal.SIGKILL)
    try:  # ended before the question, or with it
        assert computing.ask(math.sqrt, 9.0) == 3.0
    except Unavailable:
        assert computing.ask(math.sqrt, 9.0) == 3.0


def test_a_question_that_takes_too_long_is_given_up(
    computing: ComputingProcess, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(computing_process, "ANSWER_LIMIT", 0.2)
    with pytest.raises(Unavailable, match="to compute"):
        computing.ask(time.sleep, LONG)


def test_a_question_may_take_long_while_it_goes_on(
    computing: ComputingProcess, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(computing_process, "ANSWER_LIMIT", 0.0)
    with pytest.raises(Unavailable, match="to compute"):
        computing.ask_while(lambda: 1, partial(time.sleep, LONG))
    looks = itertools.count()
    monkeypatch.setattr(computing_process, "ANSWER_LIMIT", 0.2)
    assert computing.ask_while(lambda: next(looks), partial(time.sleep, 1.0)) is None
    assert next(looks) > 2


def test_what_nobody_wants_any_more_is_left_off(computing: ComputingProcess) -> None:
    pid = computing.ask(os.getpid)
    assert computing.ask_unless(lambda: True, partial(time.sleep, LONG)) is None
    assert gone(pid)
    assert computing.ask_unless(lambda: False, partial(math.sqrt, 4.0)) == 2.0


def test_a_question_that_can_wait_comes_after_those_of_people_who_wait(
    computing: ComputingProcess, tmp_path: Path
) -> None:
    until = tmp_path / "until"
    os.mkfifo(until)
    order: list[str] = []

    def wait_for(questions: int) -> None:
        while computing.questions != questions:
            time.sleep(0.01)

    def begin(ask: Callable[..., object], name: str, *question: object) -> threading.Thread:
        def answered() -> None:
            ask(*question)
            order.append(name)

        thread = threading.Thread(target=answered)
        thread.start()
        return thread

    threads = [begin(computing.ask, "first", Path.read_text, until)]
    wait_for(1)
    threads.append(begin(computing.ask_last, "last", os.getpid))
    threads.append(begin(computing.ask, "second", os.getpid))
    wait_for(2)
    until.write_text("")
    for thread in threads:
        thread.join(20)
    assert order == ["first", "second", "last"]


def test_an_idle_process_ends_and_comes_back() -> None:
    computing = ComputingProcess(idle_limit=0.05)
    pid = computing.ask(os.getpid)
    assert gone(pid)
    assert computing.ask(os.getpid) != pid
    computing.close()


def test_closing_ends_the_question_under_way() -> None:
    computing = ComputingProcess()
    pid, refused = computing.ask(os.getpid), threading.Event()

    def wait() -> None:
        with pytest.raises(Unavailable):
            computing.ask(time.sleep, LONG)
        refused.set()

    waiting = threading.Thread(target=wait)
    waiting.start()
    computing.close()
    waiting.join(20)
    assert refused.is_set()
    assert gone(pid)
    with pytest.raises(Unavailable):
        computing.ask(os.getpid)


def test_it_ends_with_the_process_that_asks() -> None:
    program = (
        "import os, sys, time\n"
        "from app.computing_process import ComputingProcess\n"
        "print(ComputingProcess().ask(os.getpid), flush=True)\n"
        "time.sleep(60)\n"
    )
    asking = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert asking.stdout is not None
    with asking.stdout:
        pid = int(asking.stdout.readline())
        asking.kill()
        asking.wait()
    assert gone(pid)


def test_begun_early_it_loads_what_answers_will_need() -> None:
    with closing(ComputingProcess()) as computing:
        computing.begin()
        assert computing._running is not None
        started = psutil.Process(computing._running.process.pid)  # its command line is empty for a moment at first
        until = time.monotonic() + 150
        while not all(f"/{name}" in str(started.memory_maps()) for name in ("scipy/", "sklearn/", "pyarrow/_csv")):
            assert time.monotonic() < until
            time.sleep(0.1)


def test_every_library_that_measuring_imports_late_is_loaded_early() -> None:
    late = set()
    for package in MEASURING:
        for file in sorted(Path(ROOT / "app" / package).rglob("*.py")):
            functions = [node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.FunctionDef)]
            for node in (inner for function in functions for inner in ast.walk(function)):
                if isinstance(node, ast.ImportFrom):
                    late.add(node.module)
                elif isinstance(node, ast.Import):
                    late.update(name.name for name in node.names)
    assert late == set(SLOW_LIBRARIES)
