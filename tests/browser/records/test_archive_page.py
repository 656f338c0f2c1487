"""A whole patient goes from one clinic to another, by the pages of both: as a file that the first one gives."""

import pytest
from browser.served.clinic_app import ClinicApp
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

COURSE = "is being sent and checked"
REFUSED = "Failed to load resource"  # what the browser writes by itself


@pytest.fixture
def second(tmp_path):
    with ClinicApp(tmp_path / "second") as served:
        yield served


def choose(page, file):
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Import an archive").click()
    chooser.value.set_files(file)


def let_wait(page):
    """Let an import wait, and answer how far a large one is; return the list that its request is added to."""
    waiting = []

    def answer(route):
        if route.request.method == "POST":
            waiting.append(route)
        else:
            route.fulfill(json={"step": "unpack", "done": 30_000_000, "total": 120_000_000})

    page.route("**/api/v1/archives", answer)
    return waiting


def exported(page, app, file):
    """Give the consent, end the session that is open, and save the archive of the patient."""
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    page.goto(f"{app.address}/#/session/patient/1")
    page.get_by_role("button", name="Enter consent: Sharing outside").click()
    card = page.locator(".card").filter(has=page.get_by_role("heading", name="Export for other programs"))
    form = card.get_by_label("Form")
    form.select_option("archive")
    expect(card.get_by_text("A session of this patient is open: end it first")).to_be_visible()
    expect(card.get_by_role("link")).to_have_count(0)
    form.select_option("csv")
    expect(card.get_by_role("link")).to_have_count(1)
    expect(card.get_by_label("Sessions")).to_be_visible()
    page.goto(f"{app.address}/#/patients")
    page.get_by_role("button", name="End session").click()
    expect(page.get_by_text("The session has ended")).to_be_visible()
    page.goto(f"{app.address}/#/session/patient/1")
    without_room = '{"bytes": 6000, "message": "There is no room for this archive."}'
    page.route("**/archive/room", lambda route: route.fulfill(body=without_room, content_type="application/json"))
    form.select_option("archive")
    expect(card.get_by_label("Sessions")).to_be_hidden()
    expect(card.get_by_role("status")).to_have_text("There is no room for this archive.")
    expect(card.get_by_role("link")).to_have_count(0)
    page.unroute("**/archive/room")
    form.select_option("csv")
    form.select_option("archive")
    expect(card.get_by_role("status")).to_contain_text("The recordings take ")
    with page.expect_download() as download:
        card.get_by_role("link", name="Export of P-1").click()
    download.value.save_as(file)
    expect(card.get_by_text("The export is complete: ")).to_be_visible()
    expect(card.get_by_role("progressbar")).to_have_count(0)


def test_a_patient_goes_to_another_clinic_by_the_pages_of_both(recorded, second, open_page, tmp_path):
    page = open_page(recorded.link, "390x844", allowed=REFUSED)
    exported(page, recorded, tmp_path / "heron.zip")
    page.goto(f"{recorded.address}/#/patients")
    choose(page, tmp_path / "heron.zip")
    question = page.get_by_role("alertdialog", name="P-1 is in this clinic already, and nothing was imported")
    expect(question).to_contain_text("An archive of the patient as it is now is made first, and kept for 30 days.")
    question.get_by_role("button", name="Cancel").click()
    expect(question).to_be_hidden()
    expect(page.get_by_role("alert")).to_have_count(0)
    choose(page, tmp_path / "heron.zip")
    question.get_by_role("button", name="Replace the patient").click()
    expect(page.get_by_text("P-1 is replaced: 1 session, 2 trials.")).to_be_visible()
    expect(page.get_by_text(COURSE)).to_have_count(0)
    page.context.close()

    page = open_page(f"{second.address}/#/patients", sign_in=second.sign_in_as("Ada"), allowed=REFUSED)
    expect(page.get_by_role("button", name="New patient")).to_be_visible()
    (tmp_path / "letter.zip").write_bytes(b"Dear colleague")
    choose(page, tmp_path / "letter.zip")
    expect(page.get_by_role("alert")).to_contain_text("This is no archive of bodydrive")
    waiting = let_wait(page)
    choose(page, tmp_path / "heron.zip")
    expect(page.get_by_text("Checking and unpacking: 30.0 MB of 120.0 MB")).to_be_visible()
    assert page.get_by_role("progressbar", name="How much of this step is done").evaluate("(bar) => bar.value") == 0.25
    waiting[0].continue_()
    expect(page.get_by_text("The patient P-1 is imported: 1 session, 2 trials.")).to_be_visible()
    expect(page.get_by_role("progressbar")).to_have_count(0)
    page.unroute("**/api/v1/archives")
    expect(page.get_by_role("alert")).to_have_count(0)
    expect(page.locator(".person").filter(has_text="Heron")).to_contain_text("2 trials")
    choose(page, tmp_path / "heron.zip")
    expect(page.get_by_text("P-1 was imported from this archive before")).to_be_visible()
    expect(page.locator(".person")).to_have_count(3)
    (patient,) = [one for one in second.good("GET", "/patients") if one["code"] == "P-1"]
    assert len(second.good("GET", f"/trials?patient={patient['id']}")) == len(recorded.trials)
