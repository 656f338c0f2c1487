"""The words of a report's document, and of the files that were rendered from it."""

import re
from collections.abc import Iterator
from dataclasses import asdict
from html.parser import HTMLParser
from typing import Any

import pypdfium2

from app.features.reports.document import Report

ALT = {"svg", "description", "missing", "practice", "tone"}  # fields that are not running text


def words_of(report: Report) -> list[str]:
    """Return all running texts of a document."""
    return [text for text in _texts(asdict(report)) if text.strip()]


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for name, inner in value.items():
            if name not in ALT:
                yield from _texts(inner)
    elif isinstance(value, list | tuple):
        for inner in value:
            yield from _texts(inner)


def pdf_pages(content: bytes) -> list[str]:
    """Return the text of each page."""
    document = pypdfium2.PdfDocument(content)
    try:
        return [page.get_textpage().get_text_bounded() for page in document]
    finally:
        document.close()


class _Page(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.text: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text.append(data)


def html_page(content: bytes) -> tuple[str, list[tuple[str, dict[str, str | None]]]]:
    """Return the text of an HTML file, and its elements with their attributes."""
    page = _Page()
    page.feed(content.decode())
    return "".join(page.text), page.elements


def letters(text: str) -> str:
    """Return a text without white space and hyphens: lines are broken in other places."""
    return re.sub(r"[\s\u00ad\u2010\u0002\ufffe-]+", "", text)
