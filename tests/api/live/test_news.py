"""What the program sends as news: the pages wait for each of it, and it names no session without its patient."""

import ast
import re
from typing import get_args

import pytest
from pydantic import ValidationError

from app.news import News, What
from folders import ROOT

WHATS = set(get_args(What))
NOT_OF_PAGES = {"graphics"}  # web_static/js/live/live.js itself answers it


def test_news_is_equal_by_what_it_says() -> None:
    news = [News(what="trial", patient=1, trial=3), News(what="trial", patient=1, trial=3), News(what="trial")]
    assert len(set(news)) == 2


@pytest.mark.parametrize("ids", [{"session": 3}, {"trial": 4}, {"session": 3, "trial": 4}])
def test_news_of_a_session_or_a_trial_names_its_patient(ids: dict[str, int]) -> None:
    assert News(what="trial", patient=1, **ids).patient == 1
    with pytest.raises(ValidationError, match="names its patient"):
        News(what="trial", **ids)


def sent() -> set[str]:
    """Return what the program names in its news: in `News(what=...)`, and in the messages of what is recorded."""
    calls = [
        node
        for file in (ROOT / "app").rglob("*.py")
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and ast.unparse(node.func) in {"News", "FlowMessages"}
    ]
    values = [keyword.value for call in calls for keyword in call.keywords if keyword.arg in {"what", "event"}]
    return {str(value.value) for value in values if isinstance(value, ast.Constant)}


def awaited() -> set[str]:
    """Return what the pages wait for: the names in `what: [...]` of their scripts."""
    scripts = (file.read_text(encoding="utf-8") for file in (ROOT / "web_static" / "js").rglob("*.js"))
    lists = (names for script in scripts for names in re.findall(r"what: \[([^\]]*)\]", script))
    return {name for names in lists for name in re.findall(r'"([\w-]+)"', names)}


def test_each_name_is_sent_and_awaited() -> None:
    assert sent() == WHATS
    assert awaited() == WHATS - NOT_OF_PAGES
