"""What the children of the web process share: how they are started, asked and ended."""

import asyncio
import os
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

from app.child_process import ChildEndedError, JsonChild, ask_once, command
from app.json_values import parse_object
from folders import ROOT

ECHO = """
from app.child_process import prepare_child, questions, respond
import os
prepare_child(lowest_priority={lowest})
for question in questions():
    respond({{"question": question, "niceness": os.nice(0), "pid": os.getpid()}})
"""


@pytest.fixture
def echo(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The name of a module that answers with what it was asked."""
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:.")
    (tmp_path / "echo_child.py").write_text(ECHO.format(lowest=False))
    (tmp_path / "lowest_child.py").write_text(ECHO.format(lowest=True))
    return "echo_child"


def answers(module: str, *questions: dict[str, object]) -> list[dict[str, object]]:
    async def ask() -> list[dict[str, object]]:
        child = await JsonChild.start(module)
        try:
            found: list[dict[str, object]] = []
            for question in questions:
                await child.send(question)
                found.append(dict(await child.receive()))
            return found
        finally:
            await child.end(20.0)

    return asyncio.run(ask())


def test_one_child_answers_each_question_in_order(echo: str) -> None:
    first, second = answers(echo, {"text": "ä\n"}, {"number": 2})
    assert (first["question"], second["question"]) == ({"text": "ä\n"}, {"number": 2})
    assert first["pid"] == second["pid"] != os.getpid()


@pytest.mark.parametrize(("module", "niceness"), [("echo_child", 10), ("lowest_child", 19)])
def test_a_child_has_a_lower_priority(echo: str, module: str, niceness: int) -> None:
    (answer,) = answers(module, {})
    assert answer["niceness"] == min(os.nice(0) + niceness, 19)


def test_a_child_ends_when_its_input_ends(echo: str) -> None:
    (answer,) = answers(echo, {})
    assert not psutil.pid_exists(int(str(answer["pid"])))


def test_a_child_that_goes_on_is_killed() -> None:
    async def end() -> int | None:
        pipe = asyncio.subprocess.PIPE
        process = await asyncio.create_subprocess_exec("sleep", "60", stdin=pipe, stdout=pipe)
        await JsonChild(process).end()
        return process.returncode

    assert asyncio.run(end()) == -9


def test_a_child_that_ends_is_an_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:.")
    (tmp_path / "ending_child.py").write_text("input(); print('[1]')")
    with pytest.raises(ChildEndedError):
        answers("ending_child", {})
    with pytest.raises(ChildEndedError):
        ask_once(command("ending_child"), {}, 60.0)


def test_a_child_without_a_web_process_ends_without_a_word(echo: str) -> None:
    child = subprocess.Popen(command(echo), stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert child.stdin is not None
    assert child.stdout is not None
    child.stdout.close()  # as when the web process was killed
    _, complaint = child.communicate(b"{}\n{}\n", 60)
    assert (child.returncode, complaint) == (0, b"")


@pytest.mark.parametrize("text", ["", "[1]", "1", "{", "null"])
def test_what_is_no_object_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"Expecting|no JSON object"):
        parse_object(text)


def test_a_child_loads_nothing_that_only_the_web_process_needs() -> None:
    large = ("asyncio", "ctypes", "dataclasses", "multiprocessing", "pydantic", "subprocess")
    code = f"import sys, app.child_process; print([name for name in {large} if name in sys.modules])"
    seen = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert seen.stdout.strip() == "[]"


def test_one_module_starts_the_children() -> None:
    starting = {"app/child_process.py", "app/process/supervisor.py"}  # the other one starts the control process
    naming = {"app/cli/host/service.py"}  # writes a command for systemd, which starts the program itself
    found = {
        str(file.relative_to(ROOT)) for file in (ROOT / "app").rglob("*.py") if "sys.executable" in file.read_text()
    }
    assert found == starting | naming
