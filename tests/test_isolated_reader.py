"""The process that reads uploaded files: its limits hold, and each failure is one sentence."""

import pytest

from app import isolated_reader
from app.isolated_reader import ReadingTimeoutError, read_isolated


@pytest.fixture
def module(tmp_path, monkeypatch):
    """Write the body of `answer(question)` and return the module's name."""
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:.")

    def written(body):
        (tmp_path / "foreign.py").write_text(f"def answer(question):\n    {body}\n")
        return "foreign"

    return written


def test_an_answer_comes_back(module):
    assert read_isolated(module("return {'double': 2 * question['number']}"), {"number": 21}) == {"double": 42}


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("raise ValueError('hall.png: this is damaged')", "hall.png: this is damaged"),
        ("return {'size': len(bytearray(4_000_000_000))}", "needs too much memory"),
        ("import os; os.abort()", "could not be read"),
        ("raise KeyError('x')", "could not be read"),
        ("import resource; resource.setrlimit(resource.RLIMIT_CPU, (1, 1))\n    while True: pass", "could not be read"),
        ("open(question['place'], 'wb').write(bytes(60_000_000))", "could not be read"),
    ],
)
def test_a_file_that_cannot_be_read_is_one_sentence(module, tmp_path, body, words):
    with pytest.raises(ValueError, match=words):
        read_isolated(module(body), {"place": str(tmp_path / "large")})


def test_a_reader_that_hangs_is_ended(module, monkeypatch):
    monkeypatch.setattr(isolated_reader, "LONGEST_WAIT", 0.5)
    with pytest.raises(ReadingTimeoutError, match="too long"):
        read_isolated(module("import time; time.sleep(60)"), {})


def test_a_reader_has_limits_of_memory_computing_and_files(module):
    body = "import resource as r; return {n: r.getrlimit(getattr(r, 'RLIMIT_' + n))[0] for n in ('AS', 'CPU', 'FSIZE')}"
    assert read_isolated(module(body), {}) == {"AS": 3_000_000_000, "CPU": 60, "FSIZE": 200_000_000}
