"""The page "Backup" in a real browser: folder, a backup with its course, a deleted patient undone and erased."""

import re

import pytest
from browser.served.clinic_app import go
from browser.sizes import photograph
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

ALLOWED = "Failed to load resource"  # what the server refuses, the browser reports


@pytest.fixture
def page(served, open_page):
    page = open_page(served.address, "1280x800", sign_in=served.sign_in_as("Ada"), allowed=ALLOWED)
    expect(page.get_by_role("heading", name="Who has come?")).to_be_visible()
    return page


def test_an_owner_backs_up_and_looks_after_deleted_patients(page, served, tmp_path):
    stick = tmp_path / "stick"
    stick.mkdir()
    served.good("PUT", "/record-keeping", {"years": 10})
    page.get_by_role("button", name="Delete B-12").click()
    expect(page.get_by_text(re.compile("must be kept until .*: give a reason"))).to_be_visible()
    page.get_by_label("Reason").fill("The patient's own wish")
    page.get_by_role("button", name="Delete for this reason").click()
    expect(page.get_by_text("B-12 was deleted.")).to_be_visible()
    expect(page.locator(".person")).to_have_count(1)
    go(page, "settings")
    page.get_by_role("link", name="Look at the backups").click()
    expect(page.get_by_role("heading", name="Backup", level=1)).to_be_visible()
    expect(page.get_by_text("There is no good backup yet: choose a folder")).to_be_visible()
    expect(page.get_by_role("button", name="Back up now")).to_be_disabled()
    photograph(page, "backup-first", touched="main")
    page.get_by_label("Folder").fill("relative")
    page.get_by_role("button", name="Save").first.click()
    expect(page.get_by_text("Give the whole path of the folder")).to_be_visible()
    page.get_by_label("Folder").fill(str(stick))
    page.get_by_role("button", name="Save").first.click()
    expect(page.get_by_text("Saved.")).to_be_visible()
    page.get_by_role("button", name="Back up now").click()
    expect(page.locator(".made-backup .tag").first).to_have_text("Good", timeout=60_000)
    expect(page.get_by_text("The last good backup is of")).to_be_visible()
    assert len(list(stick.glob("bodydrive-*.backup"))) == 1
    expect(page.get_by_text("erased in 30 days")).to_be_visible()
    page.get_by_role("button", name="Erase now: B-12").click()
    expect(page.get_by_role("button", name="Cancel")).to_be_focused()
    photograph(page, "backup-made", touched="main")
    cancel = page.get_by_role("button", name="Cancel").element_handle()
    (other,) = [one["id"] for one in served.good("GET", "/patients") if one["code"] == "A-03"]
    served.good("DELETE", f"/patients/{other}", {"reason": "The patient's own wish"})
    page.get_by_role("button", name="Save").first.click()  # the answer has both: the card is drawn again
    expect(page.get_by_text("erased in 30 days")).to_have_count(2)
    assert cancel.evaluate("(button) => button.isConnected")  # what was open is not drawn anew
    served.good("POST", f"/patients/{other}/restore")
    page.get_by_role("button", name="Cancel").click()
    expect(page.get_by_role("group", name="Erase now")).to_have_count(0)
    page.get_by_role("button", name="Undo the deletion of B-12").click()
    expect(page.get_by_text("Nobody was deleted.")).to_be_visible()
    stick.rename(tmp_path / "taken away")
    page.reload()
    expect(page.get_by_text("The folder of the backups is not there").first).to_be_visible()
    go(page, "patients")
    expect(page.locator(".note")).to_contain_text("connect the disk or network drive")
    page.get_by_role("link", name="Look at the backups").click()
    expect(page.get_by_role("heading", name="Backup", level=1)).to_be_visible()
    expect(page.locator(".note")).to_have_count(0)  # the page says it itself
    assert {one["code"] for one in served.good("GET", "/patients")} == {"A-03", "B-12"}
