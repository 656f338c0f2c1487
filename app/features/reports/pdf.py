"""Renders a report as a PDF with typst.

The words travel as JSON, so that typst never reads them as markup. Only the fonts in `data/fonts/` are used: a report
looks alike on every machine. Characters that they do not have are written as their number and named at the end.
"""

import json
from collections.abc import Iterator
from dataclasses import asdict, replace
from typing import Any

from app.features.reports.characters import Coverage, missing_words, printable
from app.features.reports.document import Paper, Report
from app.settings import data_folder

MARKUP = frozenset({"svg"})  # names of fields that are no words


def render_pdf(report: Report, paper: Paper) -> bytes:
    """Return the report as a PDF, tagged for screen readers."""
    import typst

    coverage = Coverage()
    complete = replace(report, missing=missing_words(_words(asdict(report)), coverage))
    document = json.dumps(_printable(asdict(complete), coverage))
    fonts = typst.Fonts(include_system_fonts=False, include_embedded_fonts=False, font_paths=[data_folder() / "fonts"])
    made: bytes = typst.compile(
        data_folder() / "reports" / "report.typ",
        font_paths=fonts,
        sys_inputs={"report": document, "paper": paper},
        format="pdf",
    )
    return made


def _words(value: Any) -> Iterator[str]:
    """Yield all words of a document, without its drawings."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for name, inner in value.items():
            if name not in MARKUP:
                yield from _words(inner)
    elif isinstance(value, list | tuple):
        for inner in value:
            yield from _words(inner)


def _printable(value: Any, coverage: Coverage) -> Any:
    """Return a document in which the fonts have every character."""
    if isinstance(value, str):
        return printable(value, coverage)
    if isinstance(value, dict):
        return {name: inner if name in MARKUP else _printable(inner, coverage) for name, inner in value.items()}
    return [_printable(inner, coverage) for inner in value] if isinstance(value, list | tuple) else value
