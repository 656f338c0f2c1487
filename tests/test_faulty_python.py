"""The release of Python that reads zip and tar files safely is asked for, in one sentence."""

import socket
import sys
from typing import Any

import pytest

from app.cli import serve, server
from app.faulty_python import SAFE_FROM, python_warning
from app.settings import Settings


@pytest.mark.parametrize(("version", "least"), SAFE_FROM.items())
def test_the_release_before_is_warned_of_and_the_first_safe_one_is_not(version: tuple[int, int], least: int) -> None:
    words = str(python_warning((*version, least - 1)))
    assert f"install Python {version[0]}.{version[1]}.{least} or newer." in words
    assert "\n" not in words
    assert python_warning((*version, least)) is None


def test_a_later_version_is_safe() -> None:
    assert python_warning((3, 14, 0)) is None


@pytest.mark.parametrize("warning", ["", "This release is old."])
def test_a_start_says_it_of_the_release_that_runs(monkeypatch: pytest.MonkeyPatch, warning: str) -> None:
    asked: list[tuple[int, ...]] = []
    said: list[str] = []

    def warned(version: tuple[int, int, int]) -> str:
        asked.append(version)
        return warning

    def run(_settings: Settings, _launch: Any, _listening: Any, words: str, _others: Any) -> None:
        said.append(words)

    monkeypatch.setattr(serve, "python_warning", warned)
    monkeypatch.setattr(server, "run_clinic", run)
    with socket.socket() as listening:
        serve._run(Settings(), lambda: None, listening, ["The clinic."])  # type: ignore[arg-type]  # nothing starts
    assert asked == [tuple(sys.version_info[:3])]
    assert said == ["\n".join(["The clinic.", *filter(None, [warning])])]
