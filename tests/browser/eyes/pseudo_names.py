"""Finds in the pseudo language what the places name in English: each letter stands for itself and for its accented one.

Places press buttons by their names and wait for sentences. Within the tests of the pseudo language these words become
patterns, so that the same places are opened in it.
"""

import re
from collections.abc import Callable
from functools import wraps
from typing import Any

import pytest
from playwright.sync_api import Locator, Page
from playwright.sync_api._generated import LocatorAssertions  # it is not exported by name
from pseudo_language import ACCENTS, FILLING

BETWEEN = rf"[\s\[\]{FILLING}]+"  # two words may belong to two messages
TEXT = re.compile(r"""text=(?P<quote>["']?)(?P<words>[^/"'](?:(?! >> ).)*)(?P=quote)$""")
HAS_TEXT = re.compile(r""":has-text\((["'])(.*?)\1\)""")
NAME = re.compile(r'\[name\*="(.*?)"i\]')
NAME_PATTERN = re.compile(r"\[name=/(.*?)/\]")


def pattern_of(words: str, *, exact: bool = False) -> str:
    """Return a regular expression that finds words in English and in the pseudo language."""
    found = BETWEEN.join("".join(map(_letter, word)) for word in words.split())
    return rf"^\[*{found}( {FILLING}+)*\]*$" if exact else found


def _letter(letter: str) -> str:
    return f"[{letter}{ACCENTS[letter]}]" if letter in ACCENTS else re.escape(letter).replace("/", "\\/")


def selector_of(selector: str) -> str:
    """Return a selector of Playwright whose words are found in both languages."""
    if "://" in selector:
        return selector
    selector = TEXT.sub(lambda found: f"text=/{pattern_of(found['words'])}/i", selector)
    selector = HAS_TEXT.sub(lambda found: _containing(pattern_of(found[2])), selector)
    selector = NAME.sub(lambda found: f"[name=/{pattern_of(found[1])}/i]", selector)
    return NAME_PATTERN.sub(lambda found: f"[name=/{_begins(found[1])}/i]", selector)


def _containing(pattern: str) -> str:
    written = pattern.replace("\\", "\\\\").replace('"', '\\"')
    return f':is(:text-matches("{written}", "i"), :has(:text-matches("{written}", "i")))'


def _begins(pattern: str) -> str:
    """Return a pattern that begins with ^ in both languages, any other one as it is."""
    return rf"^\[*{pattern_of(pattern[1:])}" if pattern.startswith("^") else pattern


def _changed(words: Any, *, exact: bool = False) -> Any:
    if isinstance(words, str):
        return re.compile(pattern_of(words, exact=exact), re.IGNORECASE)
    return [_changed(each, exact=exact) for each in words] if isinstance(words, list) else words


def _with_words(method: Callable[..., Any], option: str) -> Callable[..., Any]:
    """Return a method of Playwright whose words, its first argument or an option, are found in both languages."""

    @wraps(method)
    def call(one: Any, *arguments: Any, exact: bool = False, **options: Any) -> Any:
        if option in options:
            options[option] = _changed(options[option], exact=exact)
        elif arguments and option == "":
            arguments = (_changed(arguments[0], exact=exact), *arguments[1:])
        return method(one, *arguments, **options)

    return call


def _with_selector(method: Callable[..., Any]) -> Callable[..., Any]:
    @wraps(method)
    def call(one: Any, selector: Any, **options: Any) -> Any:
        if isinstance(selector, str):
            selector = selector_of(selector)
        return method(one, selector, **{name: _changed(words) for name, words in options.items()})

    return call


def _with_whole_words(method: Callable[..., Any]) -> Callable[..., Any]:
    @wraps(method)
    def call(one: Any, words: Any, **options: Any) -> Any:
        return method(one, _changed(words, exact=True), **options)

    return call


def find_in_both(patch: pytest.MonkeyPatch) -> None:
    """Let pages find what is named in English in the pseudo language, too."""
    for kind in (Page, Locator):
        patch.setattr(kind, "get_by_role", _with_words(kind.get_by_role, "name"))
        patch.setattr(kind, "get_by_text", _with_words(kind.get_by_text, ""))
        patch.setattr(kind, "get_by_label", _with_words(kind.get_by_label, ""))
        patch.setattr(kind, "locator", _with_selector(kind.locator))
    patch.setattr(Locator, "filter", _with_words(Locator.filter, "has_text"))
    patch.setattr(LocatorAssertions, "to_contain_text", _with_words(LocatorAssertions.to_contain_text, ""))
    patch.setattr(LocatorAssertions, "to_have_text", _with_whole_words(LocatorAssertions.to_have_text))
