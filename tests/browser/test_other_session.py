"""Two tablets, two patients: what a page shows of one patient is never sent for another one."""

import re

import pytest
from browser.served.clinic_app import go
from browser.sizes import each_size, keep, window
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

COVER = ".other-session"
CHANGES = {"POST", "PUT", "DELETE"}


@pytest.fixture(scope="module")
def served(served):
    served.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
    return served


@pytest.fixture(scope="module")
def two_pages(browser, page_log, served):
    """Two browsers of their own for all tests."""
    log = page_log(served.address)
    pages = [log.watch(browser.new_page(viewport=window("768x1024"))) for _ in range(2)]
    yield pages
    log.assert_quiet()
    for page in pages:
        page.context.close()


@pytest.fixture
def tablets(two_pages, served):
    """Return both, just signed in while A-03 is here."""
    served.open_session("A-03")
    for page in two_pages:
        expect(served.sign_in(page).locator(".who")).to_contain_text("A-03")
    return two_pages


def opens(page, code):
    go(page, "patients")
    row = page.get_by_role("listitem").filter(has_text=code)
    row.get_by_role("button", name="Start session").click()
    page.get_by_role("button", name=f"End it and start {code}").click()
    expect(page.locator(".who")).to_contain_text(code)


@pytest.fixture
def changes_of():
    """Return what gives the list of the changes that a page sends from now on, each with the session that it names.

    After the test nothing listens any more: to be told of each file of a page takes a fifth of the time to open it.
    """
    listening = []

    def listen(page):
        sent = []

        def keep(request):
            if request.method in CHANGES:
                sent.append((request.url, request.headers.get("patient-session")))

        page.on("request", keep)
        listening.append((page, keep))
        return sent

    yield listen
    for page, listener in listening:
        page.remove_listener("request", listener)


def test_a_page_of_another_patient_is_covered_and_sends_nothing(tablets, served, changes_of):
    first, second = tablets
    go(first, "controls")
    handle = first.get_by_role("slider").first
    handle.focus()
    first.keyboard.press("ArrowRight")
    expect(first.get_by_role("status").filter(has_text="Saved")).to_be_visible()
    before = served.good("GET", "/controls")["hash"]
    sent = changes_of(first)
    opens(second, "B-12")

    cover = first.locator(COVER)
    expect(cover).to_be_visible()
    expect(cover).to_contain_text(
        re.compile(
            r"Patient B-12 was opened on another screen by Ada at \d\d:\d\d\. "
            r"What this page shows belongs to A-03 and can no longer be sent\."
        )
    )
    expect(cover.get_by_role("heading")).to_be_focused()
    for size in each_size(first, settle=0):
        keep(first, f"{size}-other-session")
        stop = first.locator("#stop").bounding_box()
        assert stop["x"] + stop["width"] <= window(size)["width"]
    handle.evaluate("(one) => one.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true }))")
    first.wait_for_timeout(900)  # twice as long as a change waits before it is sent
    assert sent == []
    assert served.good("GET", "/controls")["hash"] != before  # B-12's own set, untouched

    first.get_by_role("button", name="Go on with B-12").click()
    expect(cover).to_have_count(0)
    expect(first.get_by_role("heading", name="Which movement does what")).to_be_visible()
    first.get_by_role("slider").first.focus()
    first.keyboard.press("ArrowRight")
    expect(first.get_by_role("status").filter(has_text="Saved")).to_be_visible()
    assert {session for _, session in sent} == {str(served.good("GET", "/session")["session"]["id"])}


def test_what_was_entered_and_not_sent_is_named(tablets, served, changes_of):
    first, second = tablets
    go(first, "shirt")
    card = first.locator("section.card[data-card=source]")
    card.locator("summary").click()
    card.get_by_role("radio", name="A shirt over the network").check(force=True)
    card.get_by_label("Port").fill("6001")
    sent = changes_of(first)
    opens(second, "B-12")
    cover = first.locator(COVER)
    expect(cover).to_contain_text("Entered here and not sent")
    expect(cover.get_by_role("listitem")).to_have_text(["Port: 6001"])
    card.locator("form").evaluate("(form) => form.requestSubmit()")
    first.wait_for_timeout(500)
    assert served.good("GET", "/equipment")["shirt"]["kind"] == "simulator"
    cover.get_by_role("link", name="Go to the patients").click()
    expect(cover).to_have_count(0)
    assert sent == []


def test_a_page_that_belongs_to_no_session_is_left_alone_and_names_the_new_one(tablets, served):
    first, second = tablets
    go(first, "settings")
    expect(first.get_by_role("heading", name="Settings")).to_be_visible()
    opens(second, "B-12")
    expect(first.locator(".who")).to_contain_text("B-12")
    expect(first.locator(COVER)).to_have_count(0)
    go(second, "controls")
    served.good("DELETE", "/session")
    cover = second.locator(COVER)
    expect(cover).to_contain_text(
        "The session of patient B-12 was ended on another screen, and no session is open now."
    )
    expect(first.locator(".who")).to_contain_text("No session is open")


def test_who_starts_a_session_before_the_end_of_another_one_is_answered_is_not_refused(tablets):
    page, _ = tablets
    go(page, "patients")
    ends = []
    page.route("**/api/v1/session", lambda route: ends.append(route) if is_end(route) else route.continue_())
    page.get_by_role("button", name="End session").click()
    page.get_by_role("listitem").filter(has_text="B-12").get_by_role("button", name="Start session").click()
    page.wait_for_timeout(500)  # in which a request would have been sent
    ends[0].continue_()
    expect(page.locator(".who")).to_contain_text("B-12")
    page.unroute_all()


def test_who_opens_a_session_is_asked_before_that_of_another_patient_ends(tablets, served, changes_of):
    page, _ = tablets
    go(page, "patients")
    sent = changes_of(page)
    start = page.get_by_role("listitem").filter(has_text="B-12").get_by_role("button", name="Start session")
    question = page.get_by_role("alertdialog")
    cancel = question.get_by_role("button", name="Cancel")
    for leave in (cancel.click, lambda: page.keyboard.press("Escape")):
        start.click()
        expect(question).to_contain_text(re.compile(r"of A-03 is open: Ada began it at \d\d:\d\d, 0 trials\. Only one"))
        leave()
        expect(question).to_be_hidden()
        expect(start).to_be_enabled()
        assert sent == []
    start.click()
    expect(question).to_be_visible()
    for size in each_size(page, settle=0):
        keep(page, f"{size}-session-ends")
    served.good("DELETE", "/session")
    served.open_session("A-03")  # on another tablet: the session that the person agreed to end is no longer open
    with page.expect_response(lambda answer: answer.request.method == "POST") as refused:
        question.get_by_role("button", name="End it and start B-12").click()
    assert refused.value.status == 409
    assert "A-03" in refused.value.json()["detail"]
    assert served.good("GET", "/session")["patient"]["code"] == "A-03"


def is_end(route):
    return route.request.method == "DELETE"


def test_a_patient_who_is_deleted_leaves_every_page_and_comes_back_to_the_list(tablets, served):
    first, second = tablets
    patient = served.patients["A-03"]
    served.good("DELETE", "/session")
    go(first, f"session/patient/{patient}")
    expect(first.locator(".who")).to_have_text("A-03 shown")
    go(second, "patients")
    row = second.get_by_role("listitem").filter(has_text="A-03")
    expect(row).to_have_count(1)
    served.good("DELETE", f"/patients/{patient}")
    expect(first.get_by_role("heading", name="Patient deleted")).to_be_focused()
    expect(first.get_by_text("A-03 was deleted: nothing of this patient can be seen")).to_be_visible()
    expect(first.locator(".who")).to_have_text("No session is open")
    expect(row).to_have_count(0)
    served.good("POST", f"/patients/{patient}/restore")
    expect(row).to_have_count(1)
    first.get_by_role("main").get_by_role("link", name="Patients").click()
    expect(first.get_by_role("heading", name="Who has come?")).to_be_visible()
