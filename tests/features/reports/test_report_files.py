"""The two files of a report: complete, one page, legible in every script, and never obedient to what people wrote."""

from dataclasses import replace

import pypdfium2
import pytest
from features.reports.reported_clinic import report_of, store_reported_course, with_words
from features.reports.words_of import html_page, letters, pdf_pages, words_of
from hypothesis import example, given, settings
from hypothesis import strategies as st

from app.features.reports.characters import without_invisible
from app.features.reports.document import Remark
from app.features.reports.rendering import render_html, render_pdf
from app.store.tables import PatientSession

SCRIPTS = {
    "Hebrew": "המטופל מרוצה מהנסיעה",
    "Arabic": "المريض متعب قليلا",
    "Cyrillic": "Очень устал к концу занятия",
    "Greek": "κουρασμένος",
    "Chinese": "今天转弯很顺利。測試",
    "Japanese": "右ひじは安定している",
    "Korean": "오른쪽 팔꿈치가 좋다",
    "Vietnamese": "Nguyễn Thị Hằng",
}
SIGNS = "#$[]{}()*_`<>@\\\"'/=-+~^&;:%!|\u202e\u2067\u05d0\u0639 \n\t"
HOSTILE = (
    '#read("/etc/passwd") #panic() $x^2$ ] [ *bold* _it_ `raw` <label> @ref \\ " \' // /* */ = heading',
    "</style><script>alert(1)</script><img src=x onerror=alert(1)>&amp;]]>",
    "\u202egnitirw\u202c \u2066isolate\u2069 \u200bzero \ufeff \x00\x07\x1b \u0085 \ud7ff \U0010ffff \ue000",
    "\r\n\r\t\n\n   \n",
)


def test_a_normal_session_is_one_page_with_every_word_of_the_document(session_report):
    pages = pdf_pages(render_pdf(session_report, "a4"))
    assert len(pages) == 1
    shown = letters("".join(pages))
    assert [words for words in words_of(session_report) if letters(words) not in shown] == []


def test_it_is_one_page_of_letter_paper_too(session_report):
    content = render_pdf(session_report, "us-letter")
    document = pypdfium2.PdfDocument(content)
    sizes = [tuple(round(side) for side in page.get_size()) for page in document]
    document.close()
    assert sizes == [(612, 792)]


def test_a_page_is_not_blank_and_nothing_is_drawn_over_its_edge(session_report):
    document = pypdfium2.PdfDocument(render_pdf(session_report, "a4"))
    picture = document[0].render(scale=1).to_numpy()[..., :3]
    document.close()
    dark = picture.min(axis=2) < 128
    assert 0.02 < dark.mean() < 0.3
    edge = 20  # points
    middle = dark[edge:-edge, edge:-edge]
    assert middle.sum() == dark.sum()
    colours = {tuple(colour) for colour in picture.reshape(-1, 3)[::7].tolist()}
    assert len(colours) > 50  # path, trajectories, band


def test_both_files_say_the_same(course_report):
    page, elements = html_page(render_html(course_report, "a4"))
    shown = letters(page)
    assert [words for words in words_of(course_report) if letters(words) not in shown] == []
    drawn = [attributes for tag, attributes in elements if tag == "svg"]
    pictures = [task.trajectories for task in course_report.tasks] + [task.curve for task in course_report.tasks]
    assert {one.description for one in pictures} <= {attributes["aria-label"] for attributes in drawn}


def test_the_html_file_asks_for_nothing(course_report):
    content = render_html(course_report, "a4")
    _, elements = html_page(content)
    asking = {"src", "href", "srcset", "action", "data", "poster", "background"}
    assert [(tag, given) for tag, given in elements if asking & given.keys() or tag in {"script", "link"}] == []
    assert b"url(" not in content
    assert b"@import" not in content


@pytest.mark.parametrize("script", SCRIPTS)
def test_a_script_comes_out_with_the_fonts_that_come_along(session_report, script):
    report = replace(session_report, notes=(Remark(SCRIPTS[script], SCRIPTS[script]),))
    content = render_pdf(report, "a4")
    shown = "".join(pdf_pages(content))
    assert "No font here" not in shown
    assert set(letters(SCRIPTS[script])) <= set(shown) or script == "Arabic"  # whose letters are joined to forms
    document = pypdfium2.PdfDocument(content)
    fonts = {one.get_font().get_base_name() for page in document for one in page.get_objects() if one.type == 1}
    document.close()
    assert all("Noto" in name for name in fonts)


def test_characters_without_a_font_are_named_and_not_empty_boxes(session_report):
    report = replace(session_report, notes=(Remark("", "Proud \U0001f600 of it \U00012000"),))
    shown = " ".join("".join(pdf_pages(render_pdf(report, "a4"))).split())
    assert "Proud [U+1F600] of it [U+12000]" in shown
    assert "[U+1F600] (grinning face), [U+12000] (cuneiform sign a)" in shown
    assert "\U0001f600" in html_page(render_html(report, "a4"))[0]  # a browser has fonts of its own


def test_long_notes_flow_to_further_pages(session_report):
    lines = [f"Line {number} of a long note." for number in range(200)]
    report = replace(session_report, notes=(Remark("", "\n".join(lines)),))
    pages = pdf_pages(render_pdf(report, "a4"))
    assert 3 <= len(pages) <= 6
    shown = "".join(pages)
    assert all(line in shown for line in lines)


def test_a_course_of_forty_sessions_is_a_page_and_the_list_of_its_sessions(database, tmp_path):
    patient = store_reported_course(database, tmp_path / "runs", 40, recordings=False)
    with database.transaction() as db:
        for number, session in enumerate(db.query(PatientSession).order_by(PatientSession.id), 1):
            session.goal = f"To get {number} m further by myself."
    report = report_of(database, tmp_path / "runs", patient, None)
    assert [goal.head for goal in report.goals] == ["Session 1", "Session 40"]
    assert (len(report.other_goals), len(report.notes)) == (38, 40)
    pages = pdf_pages(render_pdf(report, "a4"))
    assert "Name, date, signature" in pages[0]
    assert "Head of the log" in pages[0]
    assert pages[1].strip().startswith("Sessions")
    after = "".join(pages[1:])
    assert all(f"get {number} m further" in after for number in range(2, 40))
    assert "recordings cannot be read" in report.tasks[0].trajectories_description
    assert [row[0] for row in report.sessions.rows] == [str(number) for number in range(1, 41)]


@settings(max_examples=40)
@given(words=st.text(max_size=60) | st.text(SIGNS, max_size=60))
@example(HOSTILE[0])
@example(HOSTILE[1])
@example(HOSTILE[2])
@example(HOSTILE[3])
def test_what_people_wrote_is_shown_and_never_obeyed(session_report, words):
    words = f"x{without_invisible(words)}"
    report = with_words(session_report, words)
    shown, elements = html_page(render_html(report, "a4"))
    _, plain = html_page(render_html(with_words(session_report, "x"), "a4"))
    assert [tag for tag, _ in elements] == [tag for tag, _ in plain]
    assert letters(words) in letters(shown)
    pages = pdf_pages(render_pdf(report, "a4"))
    if words.isascii():  # in other scripts, a page shows characters in another order than a text
        assert letters(words) in letters("".join(pages))
