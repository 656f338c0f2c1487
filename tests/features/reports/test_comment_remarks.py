"""Comments on moments of trials in a report: who said what, when and about which moment; long ones flow."""

from collections.abc import Iterator
from dataclasses import replace
from datetime import timedelta

import pytest
from clinic_rows import ClinicRows, rows_in
from features.reports.reported_clinic import CODE, Course, material_of, stored_course
from features.reports.words_of import letters, pdf_pages

from app.features.comments.service import add_comment, comment_history, revise_comment, withdraw_comment
from app.features.reports import composition
from app.features.reports.composition import compose
from app.features.reports.rendering import render_html, render_pdf
from app.store.tables import PatientSession, Trial

LONG = "\n".join(f"Line {number} of what was seen." for number in range(60))
SESSIONS = 2


@pytest.fixture(scope="module")
def commented(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Course]:
    """Yield a course: in the first session one comment, in the second two that stand and one that was withdrawn."""
    with stored_course(tmp_path_factory.mktemp("commented"), SESSIONS) as course:
        with rows_in(course[0]) as rows:
            comment_on_both(rows)
        yield course


def comment_on_both(rows: ClinicRows) -> None:
    db, dora = rows.db, rows.person("Dora Weiß", "reviewer")
    trials = [
        db.query(Trial).join(PatientSession).filter(PatientSession.number == number).order_by(Trial.id).first()
        for number in (1, 2)
    ]
    first, second = [one for one in trials if one is not None]
    add_comment(db, first, dora.id, 3.0, "The first one.")
    revised = add_comment(db, second, dora.id, 12.34, "It turns late.")
    revise_comment(db, revised, dora.id, "It turns late, <b>because</b> the arm\u202e tires.")
    comment_history(db, revised.id)[-1].written += timedelta(minutes=5)
    add_comment(db, second, dora.id, -1.5, LONG)
    withdraw_comment(db, add_comment(db, second, dora.id, 2.0, "A mistake."), dora.id)


def test_a_session_has_its_comments_by_their_moments(commented: Course) -> None:
    long, revised = compose(material_of(*commented, 2)).comments
    assert ", trial 8, at \u22121.5 s: Dora Weiß, 20" in long.head
    assert long.text == LONG
    assert ", trial 8, at 12.3 s: Dora Weiß, 20" in revised.head
    assert ", revised 20" in revised.head
    assert revised.text == "It turns late, <b>because</b> the arm[U+202E] tires."


def test_a_course_has_all_of_them_with_their_sessions(commented: Course, monkeypatch: pytest.MonkeyPatch) -> None:
    found = compose(material_of(*commented, None)).comments
    assert [one.head.partition(",")[0] for one in found] == ["Session 1", "Session 2", "Session 2"]
    monkeypatch.setattr(composition, "MOST_COMMENTS", 2)
    shorter = compose(material_of(*commented, None)).comments
    assert [one.text for one in shorter[:1]] == ["1 comment on earlier trials is not shown."]
    assert shorter[1:] == found[1:]


def test_both_files_show_every_line_and_no_markup(commented: Course) -> None:
    report = compose(material_of(*commented, 2))
    pages = pdf_pages(render_pdf(report, "a4"))
    shown = letters("".join(pages))
    assert len(pages) > 1  # the long comment flows
    for words in (*LONG.split("\n"), "<b>because</b>", "Comments on trials", "Dora Weiß"):
        assert letters(words) in shown
    html = render_html(report, "a4").decode()
    assert "&lt;b&gt;because&lt;/b&gt;" in html
    assert "Line 59 of what was seen." in html
    assert CODE in html


def test_without_comments_there_is_no_heading(commented: Course) -> None:
    report = compose(replace(material_of(*commented, 2), comments=()))
    assert report.comments == ()
    assert "Comments on trials" not in render_html(report, "a4").decode()
