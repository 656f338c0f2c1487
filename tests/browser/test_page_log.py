"""A page that asks another machine, or another program of this one, for anything is found, and nothing reaches it."""

import socket

import pytest
from browser.conftest import PageLog
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

ELSEWHERE = ("http://192.0.2.1/", "http://elsewhere.example/")
ASK = """(url) => { new Image().src = url; }"""


@pytest.fixture
def listening():
    """Yield a socket that another program of this machine listens at, and its address."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield server, f"http://127.0.0.1:{server.getsockname()[1]}/"


@pytest.fixture
def page(browser, served):
    log = PageLog(served.address.removeprefix("http://"))
    page = log.watch(browser.new_page())
    page.log = log
    return page


def finds(page, url):
    """Wait until the log has a request for an address, and forget it."""
    for _ in range(100):
        if url in page.log.outside:
            break
        page.wait_for_timeout(50)
    assert set(page.log.outside) == {url}
    page.log.outside.clear()


def test_what_a_page_of_ours_asks_elsewhere_is_refused_and_found(page, served, listening):
    page.goto(f"{served.address}/tablet.html")
    expect(page.locator("h1")).to_be_visible()
    assert page.log.outside == []
    for url in (*ELSEWHERE, listening[1]):
        page.evaluate(ASK, url)
        finds(page, url)
        page.evaluate("(url) => fetch(url).catch(() => null)", url)
        finds(page, url)
    listening[0].settimeout(0.2)
    with pytest.raises(TimeoutError):
        listening[0].accept()


def test_without_a_policy_other_machines_are_out_of_reach_and_where_a_page_is_led_is_found(page, served):
    page.set_content("<p>A page without a policy</p>")
    for url in ELSEWHERE:
        page.evaluate(ASK, url)
        finds(page, url)
    page.log.host = "127.0.0.1:1"
    page.goto(f"{served.address}/icon.svg")
    finds(page, f"{served.address}/icon.svg")
