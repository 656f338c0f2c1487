"""The export of a patient from the page of the sessions: only with the consent to sharing, and as a file."""

import json
import zipfile

import pytest
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]


def test_only_a_patient_who_consents_is_exported_and_anybody_gets_a_copy_of_the_report(recorded, open_page, tmp_path):
    page = open_page(recorded.link)
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    page.goto(f"{recorded.address}/#/session/patient/1")
    card = page.locator(".card").filter(has=page.get_by_role("heading", name="Export for other programs"))
    expect(card).to_contain_text("needs the patient's consent to sharing outside")
    expect(card.get_by_role("link")).to_have_count(0)
    page.get_by_role("button", name="Enter consent: Sharing outside").click()
    card.get_by_label("Form").select_option("parquet")
    with page.expect_download() as download:
        card.get_by_role("link", name="Export of P-1").click()
    file = tmp_path / "export.zip"
    download.value.save_as(file)
    with zipfile.ZipFile(file) as package:
        assert "P-1" in json.dumps(json.loads(package.read("export.json")))
        assert sum(name.endswith(".parquet") for name in package.namelist()) == len(recorded.trials)
    page.get_by_role("button", name="Withdraw the consent: Sharing outside").click()
    expect(card.get_by_role("link")).to_have_count(0)
    page.goto(f"{recorded.address}/#/session/1")
    report = page.locator(".card").filter(has=page.get_by_role("heading", name="Report"))
    expect(report).to_contain_text("P-1 has not consented to sharing outside")
    expect(report.get_by_role("link", name="Make the")).to_have_count(0)
    expect(report.get_by_role("link", name="Enter the consent")).to_be_visible()
    report.get_by_label("Made for").select_option("patient")
    with page.expect_download() as download:
        report.get_by_role("link", name="Make the web page: Session 1 of P-1").click()
    download.value.save_as(tmp_path / "report.html")
    assert "Copy for the patient" in (tmp_path / "report.html").read_text()
