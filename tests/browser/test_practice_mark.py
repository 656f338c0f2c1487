"""In a real clinic no shirt is chosen at first, and while nobody wears the one in use every page says so."""

import re

import pytest
from browser.served.clinic_app import go
from browser.sizes import SIZES, each_size, keep, photograph, window
from playwright.sync_api import expect

from folders import ROOT

pytestmark = [pytest.mark.browser]

PAGES = """() => import("/js/shell/pages.js").then(({ PAGES }) => Object.keys(PAGES))"""
DOCUMENTS = sorted(file.name for file in (ROOT / "web_static").glob("*.html"))
IN_VIEW = """(one) => {
  const { left, top, right, bottom } = one.getBoundingClientRect();
  return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight && right > left;
}"""


@pytest.fixture(scope="module")
def one_page(browser, page_log, served):
    """One page for all tests."""
    log = page_log(served.address)
    page = log.watch(browser.new_page(viewport=window("768x1024")))
    yield page
    log.assert_quiet()
    page.context.close()


@pytest.fixture
def page(one_page, served):
    """Return the page, on which the owner has just signed in."""
    return served.sign_in(one_page, "A-03")


def assert_marked(page, words):
    mark = page.locator(".practice")
    expect(mark).to_be_visible()
    expect(mark).to_have_text(re.compile(rf"{words}:\s*practice only"))
    assert mark.evaluate(IN_VIEW), page.url


def calibrated(route):
    answer = route.fetch()
    route.fulfill(response=answer, json={**answer.json(), "has_profile": True})


def test_who_was_calibrated_before_shirts_had_to_be_chosen_finds_the_way_to_one(page, served):
    assert served.good("GET", "/equipment")["shirt"] is None
    page.route("**/api/v1/session", calibrated)
    page.reload()
    go(page, "drive")
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    expect(page.locator(".foot")).to_contain_text("A trial needs a shirt")
    expect(page.get_by_role("button", name="Start trial")).to_have_count(0)
    page.locator(".foot").get_by_role("link", name="Choose a shirt").click()
    expect(page.get_by_text("No shirt yet: choose one").first).to_be_visible()
    page.unroute("**/api/v1/session")


def test_no_shirt_is_chosen_at_first_and_the_lamps_are_grey(page, served):
    equipment = served.good("GET", "/equipment")
    assert (equipment["shirt"], equipment["simulated"], equipment["body"]) == (None, None, None)
    go(page, "shirt")
    expect(page.get_by_text("No shirt yet: choose one").first).to_be_visible()
    expect(page.locator(".lamps .lamp").first).to_have_text("No shirt yet")
    expect(page.locator(".lamps .lamp").first).to_have_class(re.compile(r"\boff\b"))
    expect(page.locator(".practice")).to_be_hidden()
    expect(page.locator(".bodies .sensor")).to_have_count(0)
    practice = page.get_by_role("group", name="Practice only (simulated)")
    shirts = served.good("GET", "/equipment/shirts")
    offered = {one["kind"] for one in shirts if one["simulated"]}
    assert {radio.get_attribute("value") for radio in practice.get_by_role("radio").all()} == offered
    photograph(page, "no-shirt")
    go(page, "calibrate")
    page.get_by_role("link", name="Choose a shirt").click()
    worn = page.get_by_role("group", name="Somebody’s own movements")
    worn.get_by_role("radio", name="A shirt over the network").check(force=True)
    page.get_by_role("button", name="Use this").click()  # without a layout: the standard one
    expect(page.get_by_text("Network shirt on port 5252")).to_be_visible()
    assert served.good("GET", "/equipment")["simulated"] is False
    expect(page.locator(".practice")).to_be_hidden()


def test_every_page_carries_the_mark_while_nobody_wears_the_shirt(page, served):
    served.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
    names = page.evaluate(PAGES)
    assert len(names) >= 9
    for number, name in enumerate(names):
        go(page, name)
        expect(page.locator("main h1").first).to_be_visible()
        is_kept = name in {"shirt", "drive"}
        for size in each_size(page, SIZES if is_kept else [SIZES[number % len(SIZES)]], settle=0):
            assert_marked(page, "Simulated shirt")
            assert page.locator("#stop").evaluate(IN_VIEW), (name, size)
            if is_kept:
                keep(page, f"{size}-practice-{name}")
    link = served.good("POST", "/patient-screen/pairing")["url"]
    page.get_by_role("button", name="Sign out").click()
    expect(page.get_by_role("heading", name="Sign in")).to_be_visible()
    assert_marked(page, "Simulated shirt")
    # Five show no shirt: the pages of docs/, what somebody outside is shown, what explains trust to a tablet, the page
    # of a phone that is a sensor, and the frame in which a camera's pictures are read.
    of_no_shirt = {"camera.html", "docs.html", "phone.html", "share.html", "tablet.html"}
    assert set(DOCUMENTS) - of_no_shirt == {"index.html", "patient.html", "stereo.html"}
    for address in ("", "patient.html", "stereo.html", link[link.index("patient.html") :]):
        page.goto(f"{served.address}/icon.svg")
        page.goto(f"{served.address}/{address}")
        assert_marked(page, "Simulated shirt")
        keep(page, f"768x1024-practice-{address.split('.')[0].split('#')[0] or 'sign-in'}")
    expect(page.get_by_text("We wait for your clinician")).to_be_visible()


def test_the_mark_follows_the_shirt_on_pages_that_are_open(page, served):
    served.good("PUT", "/equipment/shirt", {"kind": "replay", "file": served.recording()})
    assert_marked(page, "Recorded signals")
    served.good("PUT", "/equipment/shirt", {"kind": "udp", "port": 0})
    expect(page.locator(".practice")).to_be_hidden()
