"""`bodydrive report`: the suffix decides about the form; bad input is a sentence, and nothing is written."""

import shutil
from contextlib import closing
from datetime import date

import pytest
from cli.answers import assert_refused
from features.reports.reported_clinic import CODE, store_reported_course
from features.reports.words_of import html_page, pdf_pages

from app.features.consents.service import give_consent, withdraw_consent
from app.store.database import Database
from app.store.tables import LogEntry


@pytest.fixture(scope="module")
def stored(tmp_path_factory):
    """Return the folder of a clinic with a course of two sessions, which nobody has open."""
    folder = tmp_path_factory.mktemp("stored") / "clinic"
    database = Database(folder / "bodydrive.sqlite")
    patient = store_reported_course(database, folder / "runs", 2, recordings=False)
    with database.transaction() as db:
        give_consent(db, patient, "sharing", date(2026, 1, 1), "Ana")
    database.close()
    return folder


@pytest.fixture
def clinic(stored, tmp_path):
    """Return the folder of such a clinic for one test."""
    return shutil.copytree(stored, tmp_path / "clinic")


def log_of(clinic):
    with closing(Database(clinic / "bodydrive.sqlite")) as database, database.transaction() as db:
        return [(row.person, row.what) for row in db.query(LogEntry)]


def test_both_forms_are_written_and_stand_in_the_log(bodydrive, clinic, tmp_path):
    code, out, err = bodydrive("report", CODE, "--session", 2, "--out", "two.pdf", "--state", "clinic")
    assert (code, out, err) == (0, "two.pdf is written.\n", "")
    assert "Session 2" in "".join(pdf_pages((tmp_path / "two.pdf").read_bytes()))
    assert bodydrive("report", CODE, "--letter", "--out", "all.HTML", "--state", "clinic")[0] == 0
    assert "Course of 2 sessions" in html_page((tmp_path / "all.HTML").read_bytes())[0]
    assert log_of(clinic)[-2:] == [("command line", "report exported")] * 2


def test_a_report_is_in_the_language_of_the_terminal(bodydrive, clinic, tmp_path, monkeypatch):
    monkeypatch.setenv("LC_ALL", "es_ES.UTF-8")
    for name, *options in (("own.html",), ("english.html", "--language", "en")):
        assert bodydrive("report", CODE, *options, "--out", name, "--state", "clinic")[0] == 0
    assert '<html lang="es">' in (tmp_path / "own.html").read_text(encoding="utf-8")
    assert '<html lang="en">' in (tmp_path / "english.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("P-9", "--out", "a.pdf"), "There is no patient with the code 'P-9': see the list of patients."),
        ((CODE, "--out", "a.docx"), "--out a.docx ends neither with .pdf nor with .html: give one of these."),
        ((CODE, "--session", "7", "--out", "a.pdf"), "This patient has no session 7: choose one that was opened."),
        ((CODE, "--language", "xx", "--out", "a.pdf"), "--language xx is not offered: give one of en"),
        ((CODE, "--out", "none/there/a.pdf"), None),
        ((CODE,), "Missing option '--out'"),
    ],
)
def test_bad_input_is_a_sentence(bodydrive, clinic, tmp_path, words, sentence):
    if sentence is None:
        (tmp_path / "none").write_text("a file")
        sentence = "is a file and not a folder, choose another place"
    before = log_of(clinic)
    assert_refused(bodydrive("report", *words, "--state", "clinic"), sentence)
    assert list(tmp_path.glob("a.*")) == []
    assert log_of(clinic) == before


def test_without_consent_to_sharing_only_a_copy_for_the_patient_is_written(bodydrive, clinic, tmp_path):
    with closing(Database(clinic / "bodydrive.sqlite")) as database, database.transaction() as db:
        withdraw_consent(db, 1, "sharing", "Ana")
    words = ("report", CODE, "--out", "all.html", "--state", "clinic")
    assert_refused(
        bodydrive(*words),
        "has not consented to sharing outside the clinic",
        "A copy for the patient needs no consent. For such a copy, add --for-patient.",
    )
    assert not (tmp_path / "all.html").exists()
    assert bodydrive(*words, "--for-patient")[0] == 0
    assert "Copy for the patient" in html_page((tmp_path / "all.html").read_bytes())[0].replace("\n", " ")
