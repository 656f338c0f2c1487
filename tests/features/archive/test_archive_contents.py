"""An archive has every kind of record that a patient can have, comments on trials and the report for people."""

import json
import zipfile
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from clinic_rows import rows_in
from exported_clinic import make_clinic
from features.archive.archive_clinics import archive_of, bring, empty_clinic, rewrite

from app.features.archive.archive_file import LIST, REPORT, open_archive
from app.features.archive.patient_rows import LEFT_OUT, archived_tables, exchanged, not_archived, patient_rows, table_of
from app.features.archive.service import make_archive
from app.features.comments.service import add_comment, comment_history, comments_of, mark_read, revise_comment
from app.features.comments.tables import MomentComment
from app.features.reports.service import report_of_archive
from app.features.sharing.attention import patients_and_reasons
from app.refusals import Conflict
from app.settings import Settings
from app.store.database import Database
from app.store.keeping.owned_rows import tables_in
from app.store.tables import Trial
from app.texts import Text, reader_language


@pytest.fixture(scope="module")
def clinic(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    """Return a clinic in which somebody has commented on a trial, and revised the comment."""
    settings = make_clinic(tmp_path_factory.mktemp("from"))
    with rows_in(settings) as rows:
        dora = rows.person("Dora", "reviewer")
        comment = add_comment(rows.db, rows.db.get_one(Trial, 1), dora.id, 2.5, "Here it turns late.")
        revise_comment(rows.db, comment, dora.id, "Here it turns late, <b>and far</b>.")
    return settings


@pytest.fixture
def open_clinic(clinic: Settings) -> Iterator[Database]:
    with closing(Database(clinic.database)) as database:
        yield database


def archived(database: Database, clinic: Settings, package: Path) -> str:
    make_report = report_of_archive(database, clinic, 1, lambda *_: {})
    return make_archive(database, 1, "Ana", clinic.runs, package, make_report)


def test_each_table_is_in_the_archive_or_has_a_reason_why_not(clinic: Settings) -> None:
    carried = [one.kind.__tablename__ for one in archived_tables()]
    assert sorted([*carried, *not_archived()]) == sorted(tables_in(clinic.database).tables)
    assert all(reason.strip() for reason in not_archived().values())


def test_each_column_of_these_tables_is_in_the_archive_or_has_a_reason_why_not() -> None:
    for one in archived_tables():
        table = table_of(one.kind)
        assert {column.name for column in table.columns} - {column.name for column in exchanged(table)} <= set(LEFT_OUT)


def test_comments_come_along_with_author_moment_and_history(
    open_clinic: Database, clinic: Settings, other: Settings, tmp_path: Path
) -> None:
    digest = archived(open_clinic, clinic, tmp_path / "heron.zip")
    patient = bring(other, tmp_path / "heron.zip").patient_id
    with open_clinic.transaction() as db:
        (first,) = comments_of(db, patient_id=1)
    with rows_in(other) as rows:
        db = rows.db
        (comment,) = comments_of(db, patient_id=patient)
        shown = (comment.person, comment.t, comment.text, comment.written, comment.revised)
        assert shown == ("Dora", 2.5, "Here it turns late, <b>and far</b>.", first.written, first.revised)
        assert comment_history(db, comment.id)[0].text == "Here it turns late."
        ben = rows.person("Dora", "reviewer").id  # of an equal name, and another person
        assert comment.person_id is None
        with pytest.raises(Conflict, match="Only its author"):
            revise_comment(db, db.get_one(MomentComment, comment.id), ben, "Another text.")
        reasons = {one.id: [each.reason for each in found] for one, found in patients_and_reasons(db, ben)}
        assert "comment" in reasons[patient]  # nobody here has read it
        mark_read(db, comment.trial_id, ben)
        assert comments_of(db, patient_id=patient, not_read_by=ben) == []
    assert archive_of(other, tmp_path / "again.zip", patient, "Ben") == digest


def test_a_stored_text_goes_along_in_english(open_clinic: Database) -> None:
    with reader_language("de"), open_clinic.transaction() as db:
        db.get_one(Trial, 1).discard_reason = Text("drive-title")
        db.flush()
        assert patient_rows(db, 1)["trial"][0]["discard_reason"] == "Where to?"
        db.rollback()


def without_author(rows: dict[str, Any]) -> None:
    rows["moment_comment"][0]["author"] = None


def hidden_sign(rows: dict[str, Any]) -> None:
    rows["comment_revision"][0]["text"] = "late\u202e"


@pytest.mark.parametrize(
    ("change", "words"), [(without_author, "a comment in it has no author"), (hidden_sign, "which nobody sees")]
)
def test_a_comment_without_author_or_with_hidden_signs_is_refused(
    open_clinic: Database, clinic: Settings, tmp_path: Path, change: Any, words: str
) -> None:
    archived(open_clinic, clinic, tmp_path / "heron.zip")
    rewrite(tmp_path / "heron.zip", tmp_path / "wrong.zip", patient=change)
    with pytest.raises(ValueError, match=words):
        bring(empty_clinic(tmp_path / "other"), tmp_path / "wrong.zip")


def test_the_report_of_the_course_lies_in_the_archive_and_is_outside_its_hash(
    open_clinic: Database, clinic: Settings, other: Settings, tmp_path: Path
) -> None:
    digest = archived(open_clinic, clinic, tmp_path / "heron.zip")
    assert archive_of(clinic, tmp_path / "plain.zip") == digest
    with zipfile.ZipFile(tmp_path / "heron.zip") as opened:
        report = opened.read(REPORT).decode()
        assert json.loads(opened.read(LIST))["report"]["bytes"] == len(report.encode())
    assert "<title>Course of 1 session, =P-1</title>" in report
    with open_archive(tmp_path / "heron.zip") as archive:
        assert archive.listed.hash == digest
    bring(other, tmp_path / "heron.zip")
    assert list(other.state.rglob(REPORT)) == []


def test_a_changed_report_is_refused(open_clinic: Database, clinic: Settings, tmp_path: Path) -> None:
    archived(open_clinic, clinic, tmp_path / "heron.zip")

    def forged(contents: dict[str, bytes]) -> None:
        contents[REPORT] = contents[REPORT].replace(b"Course", b"Coarse")

    rewrite(tmp_path / "heron.zip", tmp_path / "wrong.zip", forged)
    with pytest.raises(ValueError, match=r"'report\.html' in the archive was changed"):
        bring(empty_clinic(tmp_path / "other"), tmp_path / "wrong.zip")
