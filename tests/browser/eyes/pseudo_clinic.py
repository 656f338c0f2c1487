"""A clinic whose pages and sentences are in the pseudo language, and what on its pages is in no language."""

import calendar
import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache, wraps
from pathlib import Path
from typing import Any

import pytest
from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.pseudo_names import find_in_both
from browser.eyes.sweep import TEXTS
from browser.served import served_clinic
from playwright.sync_api import Route
from pseudo_language import PSEUDO, UNITS, child_command, copy_pages, use_words

from app import child_process, isolated_reader
from app.api import app as application
from app.api import request_language
from app.api.pages import Pages
from app.settings import data_folder, static_folder
from app.world.place_texts import messages_in
from app.world.scene import bundled_places

PLAIN_WORD = re.compile(r"[A-Za-z][a-z]+|[A-Z]{2,}")
# What is on a page and comes from no message, with the reason.
VALUES = (
    # the names of people, patients, chairs, sets, and of what a person may do, which is a name in these tests
    *("Ada", "Ben", "Rita", "Person", "The clinician", "The reviewer", "Heron", "Otter", "Nightingale", "Kingfisher"),
    *("Ward", "ward", "Standard", "The corridor of ward 3", "Camera, upper body"),
    # what people wrote
    *("To get from my bed to the kitchen table by myself", "Calm, and tired after the second trial", "Calm"),
    *("The turn begins late here, as in the last session", "A pause of three seconds: was it meant?", "A pause"),
    *("He was asked to stop, so the stop is not his", "Well turned", "a look at the page", "It was a drill"),
    # what numbers are measured in, and the name of a scale, which are the same in each language
    *("bit/s", "SCIM III"),
    # what the browser writes by itself, which does not know this language: lists and months
    *(" and ", " or ", *calendar.month_abbr[1:]),
)
ADDRESS = re.compile(r"https?://\S+")
CODES = re.compile(
    r"\b[\w-]+\.(?:csv|json|zip|key|crt|html|glb|parquet)\b"  # a file
    r"|\b(?=\w*\d)[0-9a-f]{8,}\b|\b[A-Z0-9]{4} [A-Z0-9]{4}\b"  # a fingerprint, a code
    r"|\b(?:bodydrive|certutil|umask|cat) .*"  # a command that is typed
)


@contextmanager
def pseudo_clinic(folder: Path) -> Iterator["PseudoClinic"]:
    """Serve the clinic of these tests; all that is asked of it, it answers in the pseudo language."""
    pages = copy_pages(static_folder(), folder)
    with pytest.MonkeyPatch.context() as patch:
        use_words(pages, patch.setattr)
        patch.setattr(request_language, "LANGUAGES", (PSEUDO,))
        patch.setattr(request_language, "ENGLISH", PSEUDO)
        patch.setattr(Pages.__init__, "__defaults__", (("en", PSEUDO),))
        patch.setattr(child_process, "command", lambda module, *words: child_command(pages, module, *words))
        patch.setattr(isolated_reader, "COMMAND", child_command(pages, isolated_reader.__name__))
        computing = served_clinic.SharedComputing()
        patch.setattr(served_clinic, "COMPUTING", computing)
        application._pages.cache_clear()
        find_in_both(patch)
        try:
            with PseudoClinic(folder / "clinic") as clinic:
                clinic.keep_what_is_said(patch)
                yield clinic
        finally:
            computing.end()
            application._pages.cache_clear()


class PseudoClinic(EyesClinic):
    """The clinic, which keeps what the tests say instead of the server."""

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self.said: set[str] = set()

    def keep_what_is_said(self, patch: pytest.MonkeyPatch) -> None:
        """Keep the sentences of each answer that a test gives to a page."""
        fulfill = Route.fulfill

        @wraps(fulfill)
        def keeping(route: Route, **options: Any) -> None:
            self.said |= set(strings(options.get("json")))
            fulfill(route, **options)

        patch.setattr(Route, "fulfill", keeping)

    def sayings(self) -> set[str]:
        """Return what the tests say now, in an answer, in the live picture, or for the control process."""
        return {*self.said, *strings([self.shown, self.shown_to_patient]), self.process.shirt_words}


def strings(document: Any) -> Iterator[str]:
    """Yield all texts of a document of JSON."""
    if isinstance(document, str):
        yield document
    elif isinstance(document, dict | list | tuple):
        for one in document.values() if isinstance(document, dict) else document:
            yield from strings(one)


@cache
def plan_words() -> frozenset[str]:
    """Return the texts of the floor plans and tasks that come with the program and have no message: what things are."""
    files = (file for name in ("floorplans", "scenes") for file in (data_folder() / name).glob("*.json"))
    texts = {text for file in files for text in strings(json.loads(file.read_text(encoding="utf-8")))}
    return frozenset(texts - {text for place in bundled_places().values() for text, _ in messages_in(place)})


def english_words(page: Any, clinic: PseudoClinic) -> dict[str, list[str]]:
    """Return the texts of a page that have words of no message, each with these words."""
    no_messages = sorted({*VALUES, *plan_words(), *clinic.sayings()} - {""}, key=len, reverse=True)
    found = {}
    for text in page.evaluate(TEXTS):
        rest = ADDRESS.sub(" ", text)
        for value in no_messages:
            rest = re.sub(rf"(?<![A-Za-z]){re.escape(value)}(?![A-Za-z])", " ", rest)
        rest = CODES.sub(" ", rest)
        words = [word for word in PLAIN_WORD.findall(rest) if word not in UNITS]
        if words:
            found[text] = words
    return found
