"""Drives of real chairs in a report: each of a session, a row for each session of a course."""

from collections.abc import Iterator
from datetime import timedelta

import pytest
from clinic_rows import rows_in
from features.reports.reported_clinic import Course, material_of, stored_course
from features.reports.words_of import pdf_pages

from app.features.reports.composition import compose
from app.features.reports.document import Report
from app.features.reports.rendering import render_html, render_pdf
from app.store.parameters import current_parameters, save_parameters
from app.store.tables import PatientSession
from building import make_parameters

SESSIONS = 2
DRIVES = (("by hand", 12.5, 61.0), ("fault", 3.25, 20.0), ("by hand", None, 5.0))  # end, m, s


@pytest.fixture(scope="module")
def driven(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Course]:
    """Yield a course whose second session has drives of a real chair with a set of their own."""
    with stored_course(tmp_path_factory.mktemp("driven"), SESSIONS) as (database, runs, patient):
        with rows_in(database) as rows:
            rows.chair("Red \u202echair")
            session = rows.db.query(PatientSession).filter_by(patient_id=patient, number=2).one()
            _, profile = current_parameters(rows.db, patient)
            save_parameters(rows.db, profile, make_parameters().model_copy(update={"title": "Outdoors"}))
            for end, distance, seconds in DRIVES:
                drive = rows.drive(session, end, distance)
                drive.ended = drive.started + timedelta(seconds=seconds)
        yield database, runs, patient


def test_a_session_names_each_drive_with_its_end(driven: Course) -> None:
    rows = compose(material_of(*driven, 2)).drives.rows
    assert [(row[0], row[1], *row[3:]) for row in rows] == [
        ("1", "Red [U+202E]chair", "1 min 1 s", "12.5 m", "ended by hand"),
        ("2", "Red [U+202E]chair", "20 s", "3.2 m", "ended by a stop or fault"),
        ("3", "Red [U+202E]chair", "5 s", "not reported by the chair", "ended by hand"),
    ]


def test_a_course_has_a_row_for_each_session_with_drives(driven: Course) -> None:
    report = compose(material_of(*driven, None))
    assert report.drives.rows == (("2", "3", "Red [U+202E]chair", "1 min 26 s", "15.8 m", "1"),)
    assert compose(material_of(*driven, 1)).drives.rows == ()


def test_the_source_and_the_set_of_the_drives_are_named(driven: Course) -> None:
    report = compose(material_of(*driven, 2))
    assert "Worn shirt, real chair" in report.source
    assert {fact.name: fact.value for fact in report.condition}["Set"] == "Outdoors"
    assert report.condition_note.startswith("The newest set is shown; 1 other set")


def test_a_session_with_drives_only_has_its_condition(driven: Course) -> None:
    database, _, patient = driven
    with rows_in(database) as rows:
        rows.drive(rows.session(patient))
    report = compose(material_of(*driven, 3))
    assert (report.source, report.practice, report.tasks) == ("Worn shirt, real chair", False, ())
    assert report.drives.rows[0][-1] == "goes on"
    assert {fact.name: fact.value for fact in report.condition}["Set"] == "Outdoors"


def shown(report: Report) -> str:
    return " ".join(" ".join(pdf_pages(render_pdf(report, "a4"))).split())


def test_both_files_show_them(driven: Course) -> None:
    report = compose(material_of(*driven, 2))
    for content in (shown(report), render_html(report, "a4").decode()):
        assert "Drives of real chairs" in content
        assert "ended by a stop or fault" in content
        assert "15.8" not in content  # no sum: each drive stands by itself
    without = compose(material_of(*driven, 1))
    assert "Drives of real chairs" not in render_html(without, "a4").decode()
