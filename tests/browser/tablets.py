"""Tablets of two sizes, signed in to a demonstration, and what a page sends with a change."""

from contextlib import contextmanager

from browser.sizes import keep, window
from playwright.sync_api import expect

TABLETS = ("1024x768", "820x1180")


@contextmanager
def signed_in(name, browser, page_log, link, **options):
    """Yield a page of one tablet, signed in to the demonstration, and a function that keeps a screenshot.

    The `options` are those of `new_context`.
    """
    page = browser.new_page(viewport=window(name), has_touch=True, **options)
    log = page_log(link)
    log.watch(page)
    page.goto(link)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    put_first_sentences_away(page)
    yield page, lambda picture: keep(page, f"{name}-{picture}")
    log.assert_clean()
    page.close()


def put_first_sentences_away(page):
    """Put the sentences for a first time away, where nobody has done it in this clinic before."""
    if not page.context.request.get(page.url.split("#")[0] + "api/v1/auth/me").json()["introduced"]:
        page.get_by_role("button", name="Got it").click()
        expect(page.locator(".first-sentences")).to_have_count(0)


def choose_network_shirt(page, port, key=None):
    """Choose a shirt over the network on the Shirt page, and return the card of its source."""
    go_to(page, "shirt")
    card = page.locator("section.card[data-card=source]")
    card.locator("summary").click()
    card.get_by_text("A shirt over the network", exact=True).click()
    card.get_by_label("Port").fill(str(port))
    if key:
        card.get_by_label("Key").select_option(key)
    return card


def send(page, link, method, path, body=None):
    """Send a request as a page does that shows the open session; return the answer."""
    base, calls = link.split("/#")[0].rstrip("/"), page.context.request
    return calls.fetch(f"{base}/api/v1{path}", method=method, data=body, headers=headers_of(calls, base))


def pairing_link(page, link):
    """Return a link that pairs a patient's screen with the open session."""
    return send(page, link, "POST", "/patient-screen/pairing").json()["url"]


def go_to(page, step):
    page.goto(page.url.split("#")[0] + f"#/{step}")


def headers_of(calls, base):
    """Return what a page of ours sends with a change: its origin, and the session that it shows."""
    session = calls.get(f"{base}/api/v1/session").json()["session"]
    return {"Origin": base, "Patient-Session": str(session["id"])}
