"""Render the document of a report as the bytes of a file: a PDF with typst, or one HTML file.

For the PDF the words travel as JSON, so that typst never reads them as markup. Only the fonts in `data/fonts/` are
used: a report looks alike on every machine. Characters that they do not have are written as their number and named at
the end. The HTML file needs nothing else: no request, no script. All words are escaped. The drawings are SVG in the
page, whose colours the style sheet changes in a dark room.
"""

import json
from collections.abc import Iterable, Iterator
from dataclasses import asdict, replace
from html import escape
from typing import Any, Final

from app.features.reports.characters import FONT, Coverage, coverage_of_fonts, missing_text, printable
from app.features.reports.document import (
    LABELS,
    Drawing,
    Fact,
    Form,
    InterfaceTestReport,
    MeasureRow,
    Paper,
    Remark,
    Report,
    ReportTable,
    TaskReport,
)
from app.settings import data_folder
from app.texts import Text, current_language

MEDIA_TYPES: Final[dict[Form, str]] = {"pdf": "application/pdf", "html": "text/html; charset=utf-8"}
MARKUP = frozenset({"svg"})  # names of fields that are no words


def render_pdf(report: Report, paper: Paper) -> bytes:
    """Return the report as a PDF, tagged for screen readers, with labels in the language of the reader."""
    import typst

    coverage = coverage_of_fonts()
    labels = {name: str(text) for name, text in LABELS.items()}
    labels["made"] = str(Text("report-made", clinic=report.clinic, moment=report.made))
    complete = replace(report, missing=str(missing_text(_texts(asdict(report)), coverage) or ""))
    document = json.dumps(_printable({**asdict(complete), "labels": labels}, coverage))
    fonts = typst.Fonts(include_system_fonts=False, include_embedded_fonts=False, font_paths=[data_folder() / "fonts"])
    pdf: bytes = typst.compile(
        data_folder() / "reports" / "report.typ",
        font_paths=fonts,
        sys_inputs={"report": document, "paper": paper, "language": current_language(), "font": FONT},
        format="pdf",
    )
    return pdf


def _texts(value: Any) -> Iterator[str]:
    """Yield all words of a document, without its drawings."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for name, inner in value.items():
            if name not in MARKUP:
                yield from _texts(inner)
    elif isinstance(value, list | tuple):
        for inner in value:
            yield from _texts(inner)


def _printable(value: Any, coverage: Coverage) -> Any:
    """Return a document in which the fonts have every character."""
    if isinstance(value, str):
        return printable(value, coverage)
    if isinstance(value, dict):
        return {name: inner if name in MARKUP else _printable(inner, coverage) for name, inner in value.items()}
    return [_printable(inner, coverage) for inner in value] if isinstance(value, list | tuple) else value


POLICY = "default-src 'none'; style-src 'unsafe-inline'"  # in the file itself: it loads nothing, whatever stands in it
PAGES: dict[Paper, str] = {"a4": "A4", "us-letter": "letter"}


def render_html(report: Report, paper: Paper) -> bytes:
    """Return the report as an HTML file in UTF-8, with labels in the language of the reader.

    `paper` is for printing it.
    """
    style = (data_folder() / "reports" / "report.css").read_text()
    title = f"{report.title}, {report.code}"
    return "\n".join(
        [
            f'<!doctype html>\n<html lang="{current_language()}">\n<head>\n<meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{escape(POLICY)}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{escape(title)}</title>",
            f"<style>\n{style}\n@page {{ size: {PAGES[paper]}; }}\n</style>\n</head>\n<body>\n<main>",
            *_head(report),
            *_section("goal", map(_remark, report.goals)),
            *(part for task in report.tasks for part in _task(task)),
            *([] if report.tasks else _section("trials", [_paragraph(str(LABELS["no_trial"]))])),
            *(_section("tests", map(_tests, report.tests)) if report.tests else ()),
            *(_section("drives", [_table(report.drives)]) if report.drives.rows else ()),
            *_section("condition", _condition(report)),
            *_section("scales", [_table(report.scales) or _paragraph(str(LABELS["no_scale"]))]),
            *(() if report.sessions.rows else _words(report)),
            *_foot(report),
            *((*_section("sessions", [_table(report.sessions)]), *_words(report)) if report.sessions.rows else ()),
            "</main>\n</body>\n</html>\n",
        ]
    ).encode()


def _head(report: Report) -> list[str]:
    made = Text("report-made", clinic=f"<bdi>{escape(report.clinic)}</bdi>", moment=escape(report.made))
    return [
        '<header><div class="mark">bodydrive</div>',
        f'<h1>{escape(report.title)} <bdi class="code">{escape(report.code)}</bdi></h1>',
        f'<p class="made">{made}</p></header>',
        f'<p class="{"source practice" if report.practice else "source"}"><b>{_label("source")}</b> '
        f"{escape(report.source)}</p>",
        _facts(report.facts),
    ]


def _words(report: Report) -> list[str]:
    """Return what people wrote; of a course it comes last, because it may be long."""
    return [
        *(_section("goals_between", map(_remark, report.other_goals)) if report.other_goals else ()),
        *_section("notes", map(_remark, report.notes)),
        *(_section("comments", map(_remark, report.comments)) if report.comments else ()),
    ]


def _condition(report: Report) -> list[str]:
    return [_facts(report.condition), _paragraph(report.condition_note), _table(report.controls)]


def _task(task: TaskReport) -> list[str]:
    rows = "".join(_measure(row) for row in task.measures)
    columns = (_label("measure"), _label("now"), escape(task.before), _label("band"), _label("verdict"))
    head = "".join(f'<th scope="col">{title}</th>' for title in columns)
    return _titled(
        f"<bdi>{escape(task.title)}</bdi>",
        [
            f'<p class="quiet">{escape(task.lead)}</p>',
            f'<div class="scroll"><table class="measures"><thead><tr>{head}</tr></thead>',
            f"<tbody>{rows}</tbody></table></div>",
            '<div class="drawings">',
            _figure(str(LABELS["trajectories"]), task.trajectories, task.trajectories_description),
            _figure(task.curve_title, task.curve, task.curve_description),
            "</div>",
            *(_paragraph(sentence) for sentence in task.sentences),
            *(f'<p class="quiet">{escape(sentence)}</p>' for sentence in task.statistics),
        ],
    )


def _tests(tests: InterfaceTestReport) -> str:
    return f'<p class="quiet">{escape(tests.lead)}</p>{_table(tests.table)}'


def _measure(row: MeasureRow) -> str:
    noise = f'<span class="quiet">{escape(row.noise)}</span>' if row.noise else ""
    cells = [
        f'<th scope="row">{escape(row.name)}</th>',
        f'<td class="now">{escape(row.now)}</td>',
        f"<td>{escape(row.before)}</td>",
        f"<td>{_drawing(row.drawing)}{noise}</td>",
        f'<td class="{row.tone or "plain"}">{escape(row.verdict)}</td>',
    ]
    return f"<tr>{''.join(cells)}</tr>"


def _figure(title: str, drawing: Drawing | None, description: str) -> str:
    if drawing is None:
        return ""
    caption = f"<b>{escape(title)}.</b> {escape(description)}"
    return f"<figure>{_drawing(drawing)}<figcaption>{caption}</figcaption></figure>"


def _drawing(drawing: Drawing | None) -> str:
    if drawing is None:
        return ""
    return drawing.svg.replace("<svg ", f'<svg role="img" aria-label="{escape(drawing.description)}" ', 1)


def _foot(report: Report) -> list[str]:
    line = f'<div class="line"><span>{_label("signature_line")}</span></div>'
    signed = _paragraph(report.signed) or line
    return [
        f'<section class="signature"><h2>{_label("signature")}</h2>{signed}</section>',
        f"<footer><p>{escape(report.explanation)}</p>{_facts(report.identity)}</footer>",
    ]


def _label(name: str) -> str:
    return escape(str(LABELS[name]))


def _section(label: str, parts: Iterable[str]) -> list[str]:
    return _titled(_label(label), parts)


def _titled(title: str, parts: Iterable[str]) -> list[str]:
    return [f"<section><h2>{title}</h2>", *parts, "</section>"]


def _paragraph(text: str) -> str:
    return f"<p>{escape(text)}</p>" if text else ""


def _facts(facts: Iterable[Fact]) -> str:
    rows = "".join(f"<div><dt>{escape(fact.name)}</dt><dd dir=auto>{escape(fact.value)}</dd></div>" for fact in facts)
    return f"<dl>{rows}</dl>" if rows else ""


def _remark(remark: Remark) -> str:
    head = f'<p class="quiet">{escape(remark.head)}</p>' if remark.head else ""
    return f'<div class="remark">{head}<p class="text" dir="auto">{escape(remark.text)}</p></div>'


def _table(table: ReportTable) -> str:
    if not table.rows:
        return ""
    head = "".join(f'<th scope="col">{escape(title)}</th>' for title in table.head)
    rows = "".join(f"<tr>{''.join(f'<td dir=auto>{escape(cell)}</td>' for cell in row)}</tr>" for row in table.rows)
    return f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>'
