"""What a screen reader would say: the words that come into live regions, and how urgently."""

from collections.abc import Callable
from typing import Any

from browser.script import script

# Collects what live regions say: the text that is added to one, with how urgently. A region within another one that is
# "off" is silent, and so is one that nobody sees.
LISTEN = script("listen")
QUIET = 700  # ms in which nothing more may be said
HEARD = "(words) => window.said.some(([, row]) => row.includes(words))"


def said(page: Any) -> Any:
    """Return what was said since the last look, with its urgency."""
    return page.evaluate("() => window.said.splice(0)")


def said_after(page: Any, change: Callable[[], Any], words: str = "") -> list[list[str]]:
    """Return what is said after a change, with its urgency: up to these words, and for a while from then on."""
    said(page)
    change()
    if words:
        page.wait_for_function(HEARD, arg=words)
    page.wait_for_timeout(QUIET)
    return [row for row in said(page) if "No connection" not in row[1]]  # late on a busy machine, and said, too


def is_said(page: Any, change: Callable[[], Any], words: str, live: str = "polite") -> list[list[str]]:
    """Fail when a change does not say these words once, and as urgently as this; return all that is said."""
    rows = said_after(page, change, words)
    assert with_words(rows, words) == [live], rows
    return rows


def with_words(rows: Any, words: str) -> list[str]:
    """Return how urgently these words were said, once for each time."""
    return [live for live, row in rows if words in row]
