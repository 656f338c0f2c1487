"""Share links on the page of a patient's sessions: made with the consent only, shown once, opened, counted, revoked."""

import pytest
from browser.sizes import window
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

TELEPHONE = "390x844"


@pytest.fixture
def page(recorded, open_page):
    page = open_page(recorded.link, TELEPHONE, allowed="409 (Conflict)")  # the refusal
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    page.goto(f"{recorded.address}/#/session/patient/1")
    return page


@pytest.fixture
def card(page):
    """The card of the share links."""
    return page.locator(".card").filter(has=page.get_by_role("heading", name="Share links"))


def opens(browser, app, token, pin):
    """Open a link in a browser of its own; return the page, and whether it shows the records."""
    page = browser.new_page(viewport=window(TELEPHONE))
    page.goto(f"{app.address}/share.html#{token}")
    page.get_by_label("PIN of this link").fill(pin)
    page.get_by_role("button", name="Open").click()
    records = page.get_by_role("heading", name="Records of P-1")
    refusal = page.get_by_role("alert").filter(has_text="PIN")
    expect(records.or_(refusal)).to_be_visible()
    return page, records.is_visible()


def test_without_the_consent_one_sentence_stands_in_place_of_the_form(page, card):
    expect(card).to_contain_text("needs the patient's consent to sharing outside")
    expect(card.get_by_role("button")).to_have_count(0)
    page.get_by_role("button", name="Enter consent: Sharing outside").click()
    card.get_by_role("button", name="Make the link").click()
    expect(card.locator(".share-link")).to_contain_text("Can be opened")
    page.get_by_role("button", name="Withdraw the consent: Sharing outside").click()
    expect(card.locator(".share-link")).to_contain_text("Closed: no consent")
    expect(card.get_by_role("button", name="Make the link")).to_have_count(0)


def test_a_link_is_shown_once_opened_counted_and_revoked(browser, recorded, page, card):
    page.get_by_role("button", name="Enter consent: Sharing outside").click()
    card.get_by_label("What it shows").select_option("Session 1")
    card.get_by_label("How long").select_option("3 days")
    card.get_by_role("button", name="Make the link").click()
    expect(card.get_by_role("heading", name="The link and its PIN, shown this once: Session 1")).to_be_focused()
    expect(card).to_contain_text("Only this machine can open the link")  # the test's clinic serves nobody else
    card.get_by_role("button", name="Copy the link").click()
    expect(page.get_by_text("The link was copied.")).to_be_visible()
    url, pin = page.evaluate("navigator.clipboard.readText()"), card.locator(".typed-code").inner_text()
    assert url == card.locator("pre").inner_text()
    # Another consent changes nothing of what is shown once.
    page.get_by_role("button", name="Enter consent: Recording").click()
    expect(page.get_by_role("button", name="Withdraw the consent: Recording")).to_be_focused()
    expect(card.locator(".typed-code")).to_have_text(pin)
    card.get_by_role("button", name="Done").click()
    expect(card.get_by_role("button", name="Make the link")).to_be_focused()
    assert pin not in card.inner_text()

    visitor, is_open = opens(browser, recorded, url.partition("#")[2], pin)
    assert is_open
    expect(card.locator(".share-link")).to_contain_text("Opened once, ")  # without a reload
    card.get_by_role("button", name="Revoke the link: Session 1").click()
    expect(page.get_by_text("it shows nothing more")).to_be_visible()
    expect(card.get_by_role("heading", name="Share links")).to_be_focused()
    card.get_by_text("1 link that has ended").click()
    expect(card.locator(".share-link")).to_contain_text("Revoked")
    visitor.reload()
    expect(visitor.get_by_label("PIN of this link")).to_be_visible()
    visitor.context.close()
    again, is_open = opens(browser, recorded, url.partition("#")[2], pin)
    assert not is_open
    again.context.close()


def test_openings_appear_while_a_new_link_is_shown_and_the_list_of_ended_ones_is_unfolded(
    browser, recorded, page, card
):
    page.get_by_role("button", name="Enter consent: Sharing outside").click()
    card.get_by_role("button", name="Make the link").click()
    card.get_by_role("button", name="Done").click()
    card.get_by_role("button", name="Revoke the link").click()
    card.get_by_text("1 link that has ended").click()
    card.get_by_role("button", name="Make the link").click()
    token, pin = card.locator("pre").inner_text().partition("#")[2], card.locator(".typed-code").inner_text()
    wrong = "000000" if pin != "000000" else "111111"
    visitor, is_open = opens(browser, recorded, token, wrong)
    assert not is_open
    visitor.context.close()
    expect(card.locator(".share-link").first).to_contain_text("Not opened yet · 1 wrong PIN")
    button = card.get_by_role("button", name="Revoke the link")
    button.focus()
    visitor, is_open = opens(browser, recorded, token, pin)
    assert is_open
    visitor.context.close()
    expect(card.locator(".share-link").first).to_contain_text("Opened once, ")
    expect(button).to_be_focused()
    expect(card.locator("details")).to_have_attribute("open", "")
    expect(card.locator(".typed-code")).to_have_text(pin)


def test_a_refusal_of_the_server_is_said_and_the_form_stays(page, card):
    page.get_by_role("button", name="Enter consent: Sharing outside").click()
    expect(card.get_by_role("button", name="Make the link")).to_be_visible()
    withdrawn = "fetch('/api/v1/patients/1/consents/sharing', {method: 'DELETE', headers: {'Patient-Session': 'none'}})"
    assert page.evaluate(f"{withdrawn}.then((answer) => answer.status)") == 200  # as at another screen
    card.get_by_role("button", name="Make the link").click()
    expect(page.locator(".toast")).to_contain_text("P-1 has not consented to sharing outside the clinic")
    expect(card.get_by_role("button", name="Make the link")).to_be_visible()
    expect(card.locator(".share-link")).to_have_count(0)


def test_a_reviewer_has_no_share_links_and_asks_for_none(recorded, page, card):
    token = recorded.sign_in_as("Rhea", "reviewer")
    address = page.url
    page.goto("about:blank")  # what the owner's page still asks for is not the reviewer's, and needs the owner's cookie
    page.context.clear_cookies()
    page.context.add_cookies([{"name": "bodydrive_sign_in", "value": token, "url": recorded.address}])
    asked = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(address)
    expect(page.get_by_role("heading", name="Sessions of P-1")).to_be_visible()
    expect(page.get_by_role("link", name="Session 1", exact=True)).to_be_visible()
    expect(card).to_have_count(0)
    assert [url for url in asked if "/shares" in url] == []
