"""Reads an uploaded file in the test's own process, where its libraries are loaded once.

A reader of its own imports them for every file, which takes a second or two. tests/test_isolated_reader.py,
tests/scene/test_models.py and tests/processes/test_upload_bombs.py read files as the program does.
"""

import importlib
import json
from typing import Any

import pytest

from app.api import foreign_files
from app.scene.models import objects

WITH_A_READER = (foreign_files, objects)
DIED = "this file could not be read, or takes too long: save it anew or make it smaller"


def read_here(module: str, question: dict[str, Any]) -> dict[str, Any]:
    """Answer as `app.isolated_reader.read_isolated` does, through JSON in both directions; nothing is limited."""
    asked = json.loads(json.dumps(question))
    try:
        answer = importlib.import_module(module).answer(asked)
    except ValueError as error:
        raise ValueError(str(error)) from error
    except Exception as error:  # the reader would have ended with a traceback
        raise ValueError(DIED) from error
    found: dict[str, Any] = json.loads(json.dumps(answer))
    assert "problem" not in found  # the reader says with this word why it has no answer
    return found


def read_in_this_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a test need no process for what it uploads."""
    for module in WITH_A_READER:
        monkeypatch.setattr(module, "read_isolated", read_here)
