"""The report as a file from the API: for those with the right to export, and in the log."""

import json
from typing import Any

import pytest
from api.fake_clinic import Clinic
from features.reports.reported_clinic import CODE, store_reported_course
from features.reports.words_of import html_page, pdf_pages

from app.features.consents.service import withdraw_consent
from app.settings import Settings
from app.store.log_chain import HeadFile


@pytest.fixture
def reported(signed_in: Clinic, settings: Settings) -> Any:
    """A clinic with a course of two sessions; its patient's id is the second value."""
    patient = store_reported_course(signed_in.database, settings.runs, 2, recordings=False)
    with signed_in.rows() as rows:
        rows.consent(patient, "sharing")
    return signed_in, patient


def test_a_report_is_a_file_and_a_row_of_the_log_whose_head_it_names(reported: Any, settings: Settings) -> None:
    clinic, patient = reported
    answer = clinic("GET", f"/patients/{patient}/report", params={"session": 2, "form": "pdf"})
    assert (answer.status_code, answer.headers["content-type"]) == (200, "application/pdf")
    disposition = answer.headers["content-disposition"]
    assert disposition.startswith(f'attachment; filename="bodydrive-report-{patient}-session-2-')
    assert CODE not in disposition
    row = clinic.log()[-1]
    assert (row.what, row.details["patient"], row.details["form"]) == ("report exported", patient, "pdf")
    head = HeadFile(settings.database).read()
    assert head is not None
    assert row.hash == head.hash
    assert head.hash in "".join(pdf_pages(answer.content)).replace("\r\n", "").replace("\n", "")
    assert "Heron" not in json.dumps(row.details)


def test_the_course_is_an_html_file_on_letter_paper(reported: Any) -> None:
    clinic, patient = reported
    answer = clinic("GET", f"/patients/{patient}/report", params={"form": "html", "letter": True})
    assert answer.headers["content-type"] == "text/html; charset=utf-8"
    assert answer.headers["content-disposition"].startswith("attachment; ")
    assert "Course of 2 sessions" in html_page(answer.content)[0]
    assert b"@page { size: letter; }" in answer.content


def test_a_report_is_in_the_language_of_the_request(reported: Any) -> None:
    clinic, patient = reported
    address, german = f"/patients/{patient}/report?form=html", {"accept-language": "de"}
    assert b'<html lang="de">' in clinic("GET", address, headers=german).content
    assert b'<html lang="en">' in clinic("GET", f"{address}&language=en", headers=german).content


def test_what_is_not_there_is_said_in_a_sentence(reported: Any) -> None:
    clinic, patient = reported
    before = len(clinic.log())
    said = clinic.refused(404, "GET", f"/patients/{patient}/report", params={"session": 3})
    assert said == "This patient has no session 3: choose one that was opened."
    assert clinic("GET", "/patients/999/report").status_code == 404
    for wrong in ({"form": "docx"}, {"language": "xx"}, {"session": 0}):
        assert clinic("GET", f"/patients/{patient}/report", params=wrong).status_code == 422, wrong
    assert len(clinic.log()) == before


def test_a_reviewer_reads_and_takes_nothing_out(reported: Any) -> None:
    clinic, patient = reported
    with clinic.as_person(clinic.cookies_of("Rita", "reviewer")):
        refused = clinic.refused(403, "GET", f"/patients/{patient}/report")
    assert refused.startswith("A reviewer takes no records out")


def test_without_consent_to_sharing_only_a_copy_for_the_patient_is_made(reported: Any) -> None:
    clinic, patient = reported
    with clinic.database.transaction() as db:
        withdraw_consent(db, patient, "sharing", "Ana")
    before = len(clinic.log())
    assert clinic.refused(409, "GET", f"/patients/{patient}/report", params={"form": "html"}) == (
        f"{CODE} has not consented to sharing outside the clinic: ask, and enter the date under "
        "“Sessions and consents”. A copy for the patient needs no consent."
    )
    assert len(clinic.log()) == before
    copy = clinic("GET", f"/patients/{patient}/report", params={"form": "html", "for_patient": True})
    assert copy.status_code == 200
    assert "Copy for the patient" in html_page(copy.content)[0].replace("\n", " ")
    row = clinic.log()[-1]
    assert (row.what, row.details["for_patient"]) == ("report exported", True)
